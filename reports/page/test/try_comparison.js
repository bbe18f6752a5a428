// Run inside the page by comparison_test.cpp: clicks every control, reads pixels back, and tells the page around it.
const canvas = (i = 0) => all(".pane canvas")[i];
const buttonOf = (text) => all("button").find((b) => b.textContent === text);
const sliderOf = (label) => document.querySelector(`input[aria-label="${label}"]`);
const slide = (label, value) => {
  sliderOf(label).value = value;
  sliderOf(label).dispatchEvent(new Event("input"));
};
const checkboxOf = (text) => all("label.check").find((l) => l.textContent === text).querySelector("input");
const key = (name, target = document.body) =>
  target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));

/** Where a pixel of the picture lies in a canvas at fit. */
function placeOf(x, y, c = canvas()) {
  const { width, height } = { width: 16, height: 16 };
  const zoom = Math.min(c.clientWidth / width, c.clientHeight / height);
  return [c.clientWidth / 2 + (x + 0.5 - width / 2) * zoom, c.clientHeight / 2 + (y + 0.5 - height / 2) * zoom];
}

/** A copy of a canvas to read from (the browser complains of many reads from what it draws). */
function pixelsOf(c) {
  const copy = document.createElement("canvas");
  copy.width = c.width;
  copy.height = c.height;
  const context = copy.getContext("2d", { willReadFrequently: true });
  context.drawImage(c, 0, 0);
  return context.getImageData(0, 0, c.width, c.height);
}

/** The colour at a place of a canvas. */
function colourAt([px, py], c = canvas()) {
  const ratio = c.width / c.clientWidth;
  const i = 4 * (Math.round(py * ratio) * c.width + Math.round(px * ratio));
  return [...pixelsOf(c).data.slice(i, i + 3)].join(",");
}

function pointAt([px, py], type = "pointermove", c = canvas()) {
  const box = c.getBoundingClientRect();
  c.dispatchEvent(new PointerEvent(type, { clientX: box.left + c.clientLeft + px, clientY: box.top + c.clientTop + py, pointerId: 1, bubbles: true }));
}

async function views() {
  checkboxOf("outline tiles that differ").click();
  await settled();
  const spot = placeOf(1, 1);
  saw.a = colourAt(spot);
  for (const [name, text] of [["b", "b"], ["difference", "a − b"], ["z", "z of pixels"], ["tiles", "z of tiles"]]) {
    buttonOf(text).click();
    await settled();
    saw[name] = colourAt(spot);
  }
  buttonOf("a").click();
  key("t");
  await settled();
  saw.toggled = colourAt(spot);
  buttonOf("toggle a/b").click();
  await settled();
  saw.back = colourAt(spot);
  key("3");
  await settled();
  saw.third = colourAt(spot);
  key("1");
  slide("Exposure", 1);
  await settled();
  saw.exposed = colourAt(spot);
  slide("Exposure", 0);
}

async function wipe() {
  slide("Wipe", 50);
  await settled();
  saw.wipeLeft = colourAt(placeOf(1, 1));
  saw.wipeRight = colourAt(placeOf(14, 1));
  slide("Wipe", 100);
  await settled();
}

async function pointer() {
  pointAt(placeOf(3, 2));
  saw.place = document.getElementById("place").textContent;
  saw.numbers = all("#under tbody tr")
    .map((row) => [...row.children].map((cell) => cell.textContent).join(" "))
    .join("; ");
}

async function moves() {
  checkboxOf("side by side").click();
  await settled();
  saw.panes = all(".pane canvas").length;
  saw.rightPane = colourAt(placeOf(1, 1, canvas(1)), canvas(1));
  const middle = [canvas().clientWidth / 2, canvas().clientHeight / 2];
  pointAt(middle);
  const before = document.getElementById("place").textContent;
  pointAt(middle, "pointerdown");
  pointAt([middle[0] + 60, middle[1]]);
  pointAt([middle[0] + 60, middle[1]], "pointerup");
  pointAt(middle);
  saw.moved = before !== document.getElementById("place").textContent;
  const there = document.getElementById("place").textContent;
  pointAt(middle, "pointermove", canvas(1));
  saw.inStep = there === document.getElementById("place").textContent;
  canvas().dispatchEvent(new WheelEvent("wheel", { deltaY: -1, cancelable: true }));
  key("+", canvas());
  key("ArrowLeft", canvas());
  buttonOf("+").click();
  buttonOf("−").click();
  buttonOf("fit").click();
  checkboxOf("side by side").click();
  await settled();
}

async function tiles() {
  checkboxOf("outline tiles that differ").click();
  const first = all(".tile-list button")[0];
  saw.first = first.textContent;
  saw.rows = all(".tile-list tbody tr").length;
  first.click();
  await settled();
  pointAt([canvas().clientWidth / 2, canvas().clientHeight / 2]);
  saw.zoomed = document.getElementById("place").textContent.slice(0, 14);
  const colours = pixelsOf(canvas()).data;
  let pink = 0;
  for (let i = 0; i < colours.length; i += 4) pink += colours[i] > 240 && colours[i + 1] < 80 && colours[i + 2] > 190;
  saw.outlined = pink > 100;
  key("f");
}

(async () => {
  await settled();
  saw.badge = document.querySelector(".badge").textContent;
  saw.sections = all("section").map((e) => e.id).join(" ");
  saw.width = document.documentElement.clientWidth;
  saw.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  try {
    await views();
    await wipe();
    await pointer();
    await moves();
    await tiles();
  } catch (error) {
    saw.error = `${error.message} ${error.stack}`;
  }
  saw.wrongNumbers = all("section").some((e) => /NaN|undefined|\[object/.test(e.textContent));
  parent.postMessage(saw, "*");
})();
