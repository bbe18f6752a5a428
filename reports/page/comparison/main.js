// The page.

const pictureParts = pictureSection();
document
  .getElementById("main")
  .replaceChildren(
    verdictSection(),
    pictureParts.element,
    ...(found.error_known ? [tileSection(pictureParts.zoomTo), channelSection()] : [meanSection()]),
    errorSection(),
  );
