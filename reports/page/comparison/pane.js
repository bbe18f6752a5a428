// A window onto the picture. All windows have the same zoom and place.

/** Screen pixels a picture's pixel, and the picture's place in the middle of the window. */
const look = { zoom: 0, x: width / 2, y: height / 2 };

/** `show(state)` says which view lies left of the wipe, and which right of it. */
function pane(state, show, { onpointer, redraw }) {
  const canvas = h("canvas", { tabindex: "0", "aria-label": "picture: arrow keys move, + and − zoom" });
  const caption = h("figcaption", {});
  const context = canvas.getContext("2d");

  const fit = () => Math.min(canvas.clientWidth / width, canvas.clientHeight / height);
  const zoom = () => look.zoom || fit();
  const toPicture = (px, py) => [
    look.x + (px - canvas.clientWidth / 2) / zoom(),
    look.y + (py - canvas.clientHeight / 2) / zoom(),
  ];
  const toScreen = (x, y) => [
    (x - look.x) * zoom() + canvas.clientWidth / 2,
    (y - look.y) * zoom() + canvas.clientHeight / 2,
  ];

  function outline(list, colour) {
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    for (const index of list) {
      const t = found.tiles[index];
      const [x, y] = toScreen(t.x, t.y);
      context.strokeRect(x + 0.75, y + 0.75, t.width * zoom() - 1.5, t.height * zoom() - 1.5);
    }
  }

  function draw() {
    const ratio = devicePixelRatio || 1;
    const [w, hh] = [canvas.clientWidth, canvas.clientHeight];
    if (w === 0) return;
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(hh * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.imageSmoothingEnabled = false;
    const { left, right } = show(state);
    const [x, y] = toScreen(0, 0);
    const place = [x, y, width * zoom(), height * zoom()];
    context.drawImage(imageOf(left, state), ...place);
    if (right) {
      const cut = x + (state.wipe / 100) * width * zoom();
      context.save();
      context.beginPath();
      context.rect(cut, 0, Math.max(0, w - cut), hh);
      context.clip();
      context.drawImage(imageOf(right, state), ...place);
      context.restore();
      context.fillStyle = "#888";
      context.fillRect(cut - 0.5, 0, 1, hh);
    }
    if (state.outlines) {
      const style = getComputedStyle(document.documentElement);
      outline(found.undecided.filter((i) => found.tiles[i].state === "heavy tails"), style.getPropertyValue("--undecided"));
      outline(found.differing, "#ff2fd0");
    }
    caption.textContent = VIEWS[left].label(state) + (right ? ` | ${VIEWS[right].label(state)}` : "");
  }

  function zoomBy(factor, px = canvas.clientWidth / 2, py = canvas.clientHeight / 2) {
    const [x, y] = toPicture(px, py);
    const next = Math.min(64, Math.max(fit() / 2, zoom() * factor));
    look.zoom = next;
    look.x = x - (px - canvas.clientWidth / 2) / next;
    look.y = y - (py - canvas.clientHeight / 2) / next;
    redraw();
  }
  function moveBy(dx, dy) {
    look.zoom = zoom();
    look.x -= dx / look.zoom;
    look.y -= dy / look.zoom;
    redraw();
  }

  let dragged = null;
  canvas.addEventListener("pointerdown", (event) => {
    dragged = [event.offsetX, event.offsetY];
    try {
      canvas.setPointerCapture(event.pointerId);
    } catch {
      // a pointer that is gone already
    }
  });
  canvas.addEventListener("pointerup", () => {
    dragged = null;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (dragged) {
      moveBy(event.offsetX - dragged[0], event.offsetY - dragged[1]);
      dragged = [event.offsetX, event.offsetY];
    }
    const [x, y] = toPicture(event.offsetX, event.offsetY).map(Math.floor);
    if (x >= 0 && y >= 0 && x < width && y < height) onpointer(x, y);
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      zoomBy(event.deltaY < 0 ? 1.25 : 0.8, event.offsetX, event.offsetY);
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }[event.key];
    if (step) moveBy(...step);
    else if (event.key === "+" || event.key === "=") zoomBy(1.25);
    else if (event.key === "-") zoomBy(0.8);
    else return;
    event.preventDefault();
  });
  new ResizeObserver(draw).observe(canvas);
  return { element: h("figure", { class: "pane" }, canvas, caption), draw, zoomBy };
}
