// Figures: one plot that follows the width of its frame, with its data and itself to download.

const { colours: COLOURS, symbols: SYMBOLS } = axes;

/** One colour and symbol for a name, the same in every figure of the page; a study says which. */
const styleOf = (() => {
  const order = [...new Set(allSeries.map((series) => series.estimator))];
  return (name) => {
    const i = study ? study.styles[name] : order.indexOf(name);
    return { colour: `var(--series-${i % COLOURS})`, symbol: SYMBOLS[i % SYMBOLS.length] };
  };
})();

/** The mark of a series in a legend. */
function swatch(name) {
  const { colour, symbol } = styleOf(name);
  return h(
    "span",
    { class: "swatch", "aria-hidden": "true" },
    Plot.plot({
      width: 34,
      height: 16,
      margin: 0,
      x: { domain: [0, 2], axis: null },
      y: { domain: [-1, 1], axis: null },
      marks: [
        Plot.ruleY([0], { stroke: colour, strokeWidth: 1.75 }),
        Plot.dot([[1, 0]], { stroke: colour, fill: "var(--paper)", symbol, r: 4, strokeWidth: 1.75 }),
      ],
    }),
  );
}

/** A confidence interval about `value` > 0 for a logarithmic axis, which has no place for bounds at or below 0 (or at
    infinity): they are put a factor of ten away and marked as clamped. */
function logBand(value, low, high) {
  const lowClamped = !(low > 0),
    highClamped = !Number.isFinite(high);
  return { low: lowClamped ? value / 10 : low, high: highClamped ? value * 10 : high, lowClamped, highClamped };
}

/** A figure: `draw(width)` gives the options of Plot.plot, `csv()` the data as [headings, rows]; the result's redraw()
    is called when what it shows has changed. */
function figure(name, label, draw, csv) {
  const frame = h("div", { class: "plot" });
  const notes = h("p", { class: "note", role: "status" });
  const save = (kind) => () =>
    kind === "csv"
      ? download(`${name()}.csv`, "text/csv", toCsv(...csv()))
      : download(`${name()}.svg`, "image/svg+xml", toSvg(frame.querySelector("svg")));
  let width = 0;
  const redraw = () => {
    if (width < 50) return;
    const { note, ...options } = draw(width);
    const style = { background: "transparent", overflow: "visible", fontSize: "12px" };
    frame.replaceChildren(Plot.plot({ width, ariaLabel: label(), style, ...options }));
    notes.textContent = note ?? "";
  };
  new ResizeObserver(([entry]) => {
    const now = Math.floor(entry.contentRect.width);
    if (now !== width) {
      width = now;
      requestAnimationFrame(redraw);
    } // not in the observer: it changes the height
  }).observe(frame);
  const element = h(
    "figure",
    {},
    frame,
    notes,
    h("div", { class: "buttons" }, button("Data as CSV", save("csv")), button("Plot as SVG", save("svg"))),
  );
  return { element, redraw };
}

/** Ticks at powers of ten (few of them), or of two for sample counts. */
function logAxis(label, width, domain, base = 10) {
  const [low, high] = domain.map((x) => Math.log(x) / Math.log(base));
  const room = Math.max(2, Math.floor(width / 70)),
    step = Math.max(1, Math.ceil((high - low) / room));
  const ticks = d3.range(Math.ceil(low / step - 1e-9) * step, high + 1e-9, step).map((e) => base ** e);
  const tickFormat = base === 2 ? (x) => String(x) : (x) => `10${superscript(String(Math.round(Math.log10(x))))}`;
  return {
    type: "log",
    base,
    label,
    domain,
    ticks: ticks.length > 1 ? ticks : 4,
    tickFormat: ticks.length > 1 ? tickFormat : (x) => readable(x, 2),
    grid: true,
  };
}

/** The extent of positive numbers, widened a little on a logarithmic scale. */
function logDomain(values, padding = 1.25) {
  const [low, high] = d3.extent(values.filter((x) => x > 0 && Number.isFinite(x)));
  return low === undefined ? [1, 10] : [low / padding, high * padding];
}
