// Error against work for the series on one integrand: what "Convergence" and "Work–precision" share.

const byName = (list) => Object.fromEntries(list.map((one) => [one.name, one]));
const X_AXES = byName(axes.works);

/** `exponent` is that of a metric where the MSE has 1, null where it is no power of it. */
const Y_AXES = byName(axes.metrics);

/** [value, low, high] of a metric at a point, as the program computed them; its cost are seconds where they are the x
    axis, else evaluations. */
const metricAt = (p, x, y) =>
  p.metrics[Y_AXES[y].by_cost ? `${y}/${x === "seconds" ? x : "evaluations"}` : y] ?? [NaN, NaN, NaN];

const CSV_COLUMNS = ["n", "evaluations", "seconds", "mse", "mse_low", "mse_high", "bias", "bias_standard_error"];

/** The points of a series in the chosen axes; those a logarithmic axis cannot show are left out and counted. */
function plottable(series, x, y) {
  const drawn = [];
  for (const p of series.points) {
    const [value, low, high] = metricAt(p, x, y);
    const at = p[x];
    if (!(value > 0 && Number.isFinite(value) && at > 0)) continue;
    drawn.push({ series, point: p, x: at, y: value, ...logBand(value, low, high) });
  }
  return { drawn, missing: series.points.length - drawn.length };
}

/** The expected slope as a line through the geometric middle of the points; only where x is n and y a power of MSE. */
function expectedLine({ drawn }, series, x, y) {
  const expected = series.expected_slope;
  if (!expected || x !== "n" || !Y_AXES[y].exponent || drawn.length < 2) return [];
  const slope = (Y_AXES[y].exponent * (num(expected.low) + num(expected.high))) / 2;
  if (!Number.isFinite(slope)) return [];
  const middle = [d3.mean(drawn, (d) => Math.log(d.x)), d3.mean(drawn, (d) => Math.log(d.y))];
  return [drawn[0].x, drawn.at(-1).x].map((at) => ({
    series,
    x: at,
    y: Math.exp(middle[1] + slope * (Math.log(at) - middle[0])),
  }));
}

/** Guides of the given exponents of the MSE, from the highest of the first points down to the lowest that is shown. */
function guideLines(points, values, slopes, { x, y }) {
  const power = Y_AXES[y].exponent;
  if (!slopes?.length || !power || x === "seconds" || points.length === 0) return [];
  const [left, right] = d3.extent(points, (d) => d.x);
  const start = d3.max(points, (d) => (d.x === left ? d.y : -Infinity));
  const floor = d3.min(values.filter((v) => v > 0));
  return slopes.map((slope) => {
    const exponent = slope * power;
    const end = exponent < 0 ? Math.min(right, left * (floor / start) ** (1 / exponent)) : right;
    return { exponent, ends: [left, end].map((at) => ({ exponent, x: at, y: start * (at / left) ** exponent })) };
  });
}

function guideMarks(guides) {
  return [
    Plot.line(
      guides.flatMap((g) => g.ends),
      { x: "x", y: "y", z: "exponent", stroke: "var(--soft)", strokeDasharray: "5 4", strokeWidth: 1 },
    ),
    Plot.text(
      guides.map((g) => g.ends[1]),
      { x: "x", y: "y", text: (d) => readable(d.exponent), fill: "var(--soft)", textAnchor: "start", dx: 4 },
    ),
  ];
}

function tipText(d) {
  const p = d.point;
  return [
    d.series.estimator,
    `n ${p.n} · ${readable(p.evaluations)} evaluations · ${seconds(p.seconds)}`,
    `MSE ${readable(p.mse)} [${readable(p.mse_low)}, ${readable(p.mse_high)}]`,
    `bias ${readable(p.bias)} ± ${readable(p.bias_standard_error)}`,
  ].join("\n");
}

function seriesMarks(list, { x, y, bands, expected, slopes }) {
  const colour = (d) => styleOf(d.series.estimator).colour;
  const symbol = (d) => styleOf(d.series.estimator).symbol;
  const parts = list.map((series) => plottable(series, x, y));
  const points = parts.flatMap((part) => part.drawn);
  const lines = list.flatMap((series, i) => expectedLine(parts[i], series, x, y));
  const key = (d) => d.series.key;
  const clamped = bands ? points.filter((d) => d.lowClamped || d.highClamped) : [];
  const shown = bands ? points.flatMap((d) => [d.low, d.y, d.high]) : points.map((d) => d.y);
  const marks = [
    ...guideMarks(guideLines(points, shown, slopes, { x, y })),
    bands ? Plot.areaY(points, { x: "x", y1: "low", y2: "high", z: key, fill: colour, fillOpacity: 0.16 }) : null,
    expected
      ? Plot.line(lines, { x: "x", y: "y", z: key, stroke: colour, strokeDasharray: "2 4", strokeWidth: 1.25 })
      : null,
    Plot.line(points, { x: "x", y: "y", z: key, stroke: colour, strokeWidth: 1.75 }),
    Plot.text(clamped, {
      x: "x",
      y: (d) => (d.lowClamped ? d.low : d.high),
      text: (d) => (d.lowClamped ? "▽" : "△"),
      fill: colour,
    }),
    Plot.dot(points, { x: "x", y: "y", stroke: colour, fill: "var(--paper)", symbol, r: 3.5, strokeWidth: 1.75 }),
    Plot.tip(points, Plot.pointer({ x: "x", y: "y", title: tipText })),
  ];
  return { marks, points, values: shown, clamped: clamped.length, missing: d3.sum(parts, (part) => part.missing) };
}

function seriesNote({ clamped, missing }, y) {
  const notes = [];
  if (clamped)
    notes.push(
      `${plural(clamped, "confidence bound")} at or below 0 (or infinite) cannot stand on a logarithmic axis: drawn a factor of ten away, marked ▽ or △.`,
    );
  if (missing)
    notes.push(
      `${plural(missing, "point")} not drawn: the ${Y_AXES[y].label.split(" ")[0]} or the work is 0 or unknown.`,
    );
  return notes.join(" ");
}

/** The options of Plot.plot for these series. */
function drawSeries(list, setting, width) {
  const drawn = seriesMarks(list, setting);
  const xs = logDomain(drawn.points.map((d) => d.x)),
    ys = logDomain(drawn.values);
  const height = Math.round(Math.min(460, Math.max(280, width * 0.6)));
  return {
    height,
    marginLeft: 52,
    marginBottom: 42,
    marginRight: setting.slopes?.length ? 30 : 16,
    marginTop: 28,
    x: logAxis(setting.xLabels?.[setting.x] || X_AXES[setting.x].label, width, xs, X_AXES[setting.x].base),
    y: logAxis(Y_AXES[setting.y].label, height, ys),
    symbol: { type: "identity" },
    marks: drawn.marks,
    note: seriesNote(drawn, setting.y),
  };
}

function seriesCsv(list) {
  const headings = [
    "estimator",
    "integrand",
    "claim",
    "replicates",
    ...CSV_COLUMNS,
    "slope",
    "slope_low",
    "slope_high",
    "expected_low",
    "expected_high",
  ];
  const rows = list.flatMap((s) =>
    s.points.map((p) => [
      s.estimator,
      s.integrand,
      s.claim,
      s.replicates,
      ...CSV_COLUMNS.map((c) => p[c]),
      num(s.slope.value),
      num(s.slope.low),
      num(s.slope.high),
      num(s.expected_slope?.low),
      num(s.expected_slope?.high),
    ]),
  );
  return [headings, rows];
}

/** The integrands that have series, the one with most of them first chosen. */
const integrandsWithSeries = () => [...d3.group(allSeries, (s) => s.integrand)];
const mostCompared = () => d3.greatest(integrandsWithSeries(), ([, list]) => list.length)?.[0];
