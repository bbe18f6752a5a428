// The picture section: what is shown, and how.

function slider(label, { min, max, step, value }, text, oninput) {
  const output = h("output", {}, text(value));
  const input = h("input", { type: "range", min, max, step, value, "aria-label": label });
  const set = (next) => {
    input.value = next;
    output.textContent = text(Number(input.value));
  };
  input.addEventListener("input", () => {
    set(input.value);
    oninput(Number(input.value));
  });
  return { element: h("label", { class: "control" }, h("span", {}, `${label}: `, output), input), set };
}

/** Numbers of a pixel and of its tile. */
function numbersUnder(x, y) {
  if (!found.error_known) {
    const values = channels.map((name, c) => {
      const n = numbersAt(x, y, c);
      return [name, ...[n.a, n.b, n.difference].map((v) => readable(v, 5))];
    });
    return [
      h("p", { class: "note", id: "place" }, `Pixel (${x}, ${y})`),
      dataTable("Pixel under the pointer", ["channel", "a", "b", "a − b"], values, [1, 2, 3]),
    ];
  }
  const rows = channels.map((name, c) => {
    const n = numbersAt(x, y, c);
    return [name, ...[n.a, n.b, n.difference, n.sd, n.z].map((v) => readable(v, 5))];
  });
  const tiles = tilesAt(x, y)
    .map((t) => `${t.channel} ${readable(t.z)} (${t.state})`)
    .join(", ");
  return [
    h("p", { class: "note", id: "place" }, `Pixel (${x}, ${y}); z of its tile: ${tiles}`),
    dataTable("Pixel under the pointer", ["channel", "a", "b", "a − b", "standard deviation", "z"], rows, [1, 2, 3, 4, 5]),
  ];
}

function pictureSection() {
  const state = { view: "a", two: false, wipe: 100, wiping: false, exposure: 0, outlines: true };
  const under = h("div", { class: "under", id: "under" }, h("p", { class: "note" }, "Point at the picture to read its numbers."));
  const panes = [];
  const redraw = () => panes.forEach((p) => p.draw());
  const handlers = { redraw, onpointer: (x, y) => under.replaceChildren(...numbersUnder(x, y)) };
  const other = () => (state.view === "b" ? "a" : "b");
  panes.push(
    pane(state, () => ({ left: state.view, right: state.wiping && !state.two ? other() : null }), handlers),
    pane(state, () => ({ left: other(), right: null }), handlers),
  );
  const frame = h("div", { class: "panes" }, panes[0].element);

  const buttons = Object.fromEntries(
    [
      ["a", "a"],
      ["b", "b"],
      ["difference", "a − b"],
      ["z", "z of pixels"],
      ["tiles", "z of tiles"],
    ]
      .filter(([view]) => found.error_known || !["z", "tiles"].includes(view))
      .map(([view, text]) => [view, button(text, () => showView(view))]),
  );
  function showView(view) {
    if (!buttons[view]) return;
    state.view = view;
    for (const [name, element] of Object.entries(buttons)) {
      element.classList.toggle("pressed", name === view);
      element.setAttribute("aria-pressed", String(name === view));
    }
    bar.hidden = !VIEWS[view].legend;
    redraw();
  }
  const toggle = () => showView(other());
  const bar = h("div", { class: "legend-bar", hidden: true, style: `background: linear-gradient(to right, ${[-1, 0, 1].map((v) => `rgb(${diverging(v)})`)})`, role: "img", "aria-label": "blue: a is darker; red: a is brighter" });
  const exposure = slider("Exposure", { min: -10, max: 10, step: 0.25, value: 0 }, (v) => `${v > 0 ? "+" : ""}${v} stops`, (value) => {
    state.exposure = value;
    redraw();
  });
  const wipe = slider("Wipe", { min: 0, max: 100, step: 0.5, value: 100 }, (v) => `${v} %`, (value) => {
    state.wipe = value;
    state.wiping = value < 100;
    redraw();
  });
  const sideBySide = checkbox("side by side", false, (on) => {
    state.two = on;
    frame.classList.toggle("two", on);
    frame.replaceChildren(...panes.slice(0, on ? 2 : 1).map((p) => p.element));
    redraw();
  });
  const outlines = checkbox("outline tiles that differ", true, (on) => {
    state.outlines = on;
    redraw();
  });
  function fit() {
    Object.assign(look, { zoom: 0, x: width / 2, y: height / 2 });
    redraw();
  }
  /** A quarter of the window's edge for the tile. */
  function zoomTo(tile) {
    const canvas = panes[0].element.querySelector("canvas");
    look.zoom = Math.min(64, Math.min(canvas.clientWidth / tile.width, canvas.clientHeight / tile.height) / 4);
    look.x = tile.x + tile.width / 2;
    look.y = tile.y + tile.height / 2;
    redraw();
    canvas.scrollIntoView({ block: "nearest" });
  }
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || /INPUT|SELECT|BUTTON/.test(event.target.tagName)) return;
    const act = { t: toggle, " ": toggle, f: fit, 1: () => showView("a"), 2: () => showView("b"), 3: () => showView("difference"), 4: () => showView("z"), 5: () => showView("tiles") }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  showView("a");
  const lead = h("p", { class: "note" }, h("kbd", {}, "T"), " toggles a and b, ", h("kbd", {}, "1"), " to ", h("kbd", {}, found.error_known ? "5" : "3"), " choose what is shown, ", h("kbd", {}, "F"), " fits; drag moves, the wheel zooms.");
  const element = section(
    "pictures",
    "Pictures",
    null,
    h(
      "div",
      { class: "controls" },
      h("div", { class: "buttons", role: "group", "aria-label": "View" }, Object.values(buttons), button("toggle a/b", toggle, "key T")),
      exposure.element,
      wipe.element,
      sideBySide,
      found.error_known ? outlines : null,
      h("div", { class: "buttons" }, button("+", () => panes[0].zoomBy(1.5), "zoom in"), button("−", () => panes[0].zoomBy(1 / 1.5), "zoom out"), button("fit", fit, "key F")),
    ),
    bar,
    frame,
    lead,
    under,
  );
  return { element, zoomTo };
}
