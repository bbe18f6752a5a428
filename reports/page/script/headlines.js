// What sources state against what was measured: a table, each line with its interval drawn into the stated bound.

const STANDINGS = {
  met: { kind: "holds", sign: "✓" },
  "not met": { kind: "refuted", sign: "✕" },
  undecided: { kind: "undecided", sign: "?" },
  "not comparable": { kind: "none", sign: "–" },
};

function standing(outcome) {
  const { kind, sign } = STANDINGS[outcome];
  return h("span", { class: `badge ${kind}` }, h("span", { "aria-hidden": "true" }, sign), ` ${outcome}`);
}

/** From a number to a place on the glyph: what is stated and what was measured, with a margin about them. */
function headlineScale(headline, width) {
  const { stated, measured, logarithmic } = headline;
  const f = logarithmic ? (x) => (x > 0 ? Math.log(x) : Number.isNaN(x) ? NaN : -Infinity) : (x) => x;
  const ends = [stated.low, stated.high, measured.low, measured.high, measured.value]
    .map((x) => f(num(x)))
    .filter(Number.isFinite);
  const [low, high] = d3.extent(ends);
  const margin = 0.15 * (high - low) || 1;
  const [from, to] = [low - margin, high + margin];
  return (x) => {
    const y = f(num(x));
    return Number.isNaN(y) ? NaN : (width * (Math.min(Math.max(y, from), to) - from)) / (to - from);
  };
}

/** The stated bound as a band, what was measured as a dot with its interval; null where nothing was. */
function headlineGlyph(headline) {
  const { stated, measured, outcome } = headline;
  if (Number.isNaN(num(measured.value))) return null;
  const { width, height } = { width: 170, height: 18 };
  const x = headlineScale(headline, width);
  const text = `stated ${interval(stated)}, measured ${readable(measured.value)} ${interval(measured)}`;
  const bar = (low, high, top, kind) =>
    svgElement("rect", { x: low, y: top, width: Math.max(high - low, 1.5), height: height - 2 * top, class: kind });
  const drawn = [bar(x(stated.low), x(stated.high), 1, "band")];
  if (Number.isFinite(num(measured.low))) drawn.push(bar(x(measured.low), x(measured.high), 7, "interval"));
  drawn.push(svgElement("circle", { cx: x(measured.value), cy: height / 2, r: 3.5, class: "interval" }));
  return svgElement(
    "svg",
    { class: `glyph ${STANDINGS[outcome].kind}`, width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": text },
    svgElement("title", {}, text),
    ...drawn,
  );
}

function headlineRow(headline) {
  const { measured } = headline;
  const notes = [headline.reason, headline.remark].filter(Boolean).map((text) => h("div", { class: "note" }, text));
  const shown = Number.isNaN(num(measured.value))
    ? DASH
    : [readable(measured.value), Number.isFinite(num(measured.low)) ? [" ", h("span", { class: "range" }, interval(measured))] : null];
  const measure = headline.figure
    ? h("a", { href: `#${headline.figure}` }, headline.measure)
    : h("span", {}, headline.measure || "nothing here");
  return [
    standing(headline.outcome),
    h("div", {}, h("b", {}, headline.place), h("div", { class: "states" }, headline.quoted ? `“${headline.states}”` : headline.states), notes),
    measure,
    h("span", { class: "range" }, interval(headline.stated)),
    h("span", {}, shown),
    headlineGlyph(headline) ?? DASH,
  ];
}

const outcomeCounts = (list) => Object.keys(STANDINGS).map((outcome) => list.filter((one) => one.outcome === outcome).length);

const headlineCount = () =>
  Object.keys(STANDINGS)
    .map((outcome, i) => `${outcomeCounts(study.headlines)[i]} ${outcome}`)
    .join(", ");

const papers = () => [...d3.group(study.headlines, (one) => one.source)];
const paperId = (source) => `paper-${slug(source)}`;

/** How many statements of each source ended how. */
const paperTable = () =>
  dataTable(
    "Statements by source",
    ["source", "statements", ...Object.keys(STANDINGS)],
    papers().map(([source, list]) => [
      h("a", { href: `#${paperId(source)}` }, source),
      String(list.length),
      ...outcomeCounts(list).map((n) => (n ? String(n) : DASH)),
    ]),
    [1, 2, 3, 4, 5],
  );

/** A table for each source, in the order of the files. */
function headlineSection() {
  return section(
    "headlines",
    "Stated against measured",
    `${headlineCount()}. Met: the ${readable(100 * study.headline_level, 4)} % interval of what was measured lies within what is stated; not met: it lies outside; undecided: it reaches across the end. The band is what is stated, the dot what was measured, the bar its interval; ratios stand on a logarithmic scale. What stands in quotation marks are the source's words; how words are read as numbers is ours. Nothing is tuned to meet a statement.`,
    papers().length > 1 ? h("div", { class: "papers" }, paperTable()) : null,
    papers().map(([source, list]) => [
      h("h3", { id: paperId(source) }, cited(source)),
      entryOfWhole(source),
      h(
        "div",
        { class: "headlines" },
        dataTable(
          `Statements of ${source}`,
          ["outcome", "statement", "measured here as", "stated", "measured", "stated and measured"],
          list.map(headlineRow),
        ),
      ),
    ]),
  );
}
