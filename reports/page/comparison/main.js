// The page.

const pictureParts = pictureSection();
document
  .getElementById("main")
  .replaceChildren(
    verdictSection(),
    pictureParts.element,
    tileSection(pictureParts.zoomTo),
    channelSection(),
    errorSection(),
  );
