// Relative error of formulas over their hard cases, against multi-precision truth, with the bound that is claimed.

/** A place for every case: its x on the corpus' axis, or its rank where the corpus has no axis. */
function stabilityPoints(record) {
  const points = record.points.map((p, i) => ({
    name: p.case,
    x: num(p.x),
    error: num(p.relative_error),
    rank: i + 1,
  }));
  const spread = new Set(points.map((p) => p.x)).size > 1 && points.every((p) => Number.isFinite(p.x));
  return { points: points.map((p) => ({ ...p, at: spread ? p.x : p.rank })), label: spread ? record.axis : "case" };
}

/** Linear from 0, or logarithmic when errors and bound lie so far apart that one of them would vanish. */
function errorAxis(errors, bound, unit) {
  const label = `relative error (${unit})`;
  const worst = d3.max(errors) ?? 0;
  const positive = [bound, ...errors].filter((x) => x > 0);
  if (worst === 0 || (worst / bound < 20 && bound / worst < 20))
    return { floor: 0, axis: { label, domain: [0, 1.15 * Math.max(bound, worst)], grid: true, ticks: 5 } };
  const domain = [d3.min(positive) / 3, 3 * d3.max(positive)];
  return { floor: domain[0], axis: logAxis(label, 300, domain) };
}

function placeAxis(record, width) {
  const { points, label } = stabilityPoints(record);
  const places = points.map((p) => p.at);
  const [low, high] = d3.extent(places);
  if (low > 0 && high / low > 1e3) return logAxis(label, width, logDomain(places));
  const ticks = d3.ticks(low, high, Math.max(3, Math.floor(width / 110)));
  return label === "case"
    ? { label, grid: true, inset: 8, ticks: ticks.filter(Number.isInteger), tickFormat: String }
    : { label, grid: true, inset: 8, ticks };
}

function stabilityNote(lost, exact) {
  const notes = [];
  if (lost) notes.push(`${plural(lost, "case")} with an infinite or undefined error, marked △ at the top.`);
  if (exact) notes.push(`${plural(exact, "case")} without any error, marked ▽ at the foot of the logarithmic axis.`);
  return notes.join(" ");
}

function drawStability(record, width) {
  const { points } = stabilityPoints(record);
  const bound = num(record.bound);
  const finite = points.filter((p) => Number.isFinite(p.error));
  const { floor, axis } = errorAxis(
    finite.map((p) => p.error),
    bound,
    record.unit,
  );
  const lost = points.filter((p) => !Number.isFinite(p.error));
  const drawn = finite.filter((p) => floor === 0 || p.error > 0);
  const exact = finite.filter((p) => floor > 0 && p.error === 0);
  const colour = (p) => (p.error <= bound ? "var(--series-0)" : "var(--refuted)");
  const at = (y) => ({ x: "at", y });
  return {
    height: 300,
    marginLeft: 52,
    marginBottom: 42,
    marginRight: 16,
    marginTop: 28,
    x: placeAxis(record, width),
    y: axis,
    symbol: { type: "identity" },
    marks: [
      Plot.ruleY([axis.domain[0]], { stroke: "var(--rule)" }),
      Plot.ruleY([bound], { stroke: "var(--refuted)", strokeDasharray: "6 4", strokeWidth: 1.5 }),
      Plot.text([bound], {
        y: (b) => b,
        frameAnchor: "right",
        text: () => `bound ${readable(bound)}`,
        dx: -4,
        dy: -8,
        fill: "var(--refuted)",
        textAnchor: "end",
      }),
      Plot.dot(drawn, {
        ...at("error"),
        stroke: colour,
        fill: colour,
        fillOpacity: 0.25,
        symbol: (p) => (p.error <= bound ? "circle" : "times"),
        r: 4,
      }),
      Plot.text(lost, { ...at(() => axis.domain[1]), text: () => "△", fill: "var(--refuted)" }),
      Plot.text(exact, { ...at(() => floor), text: () => "▽", fill: "var(--series-0)", dy: -6 }),
      Plot.tip(drawn, Plot.pointer({ ...at("error"), title: (p) => `${p.name}\n${readable(p.error)} ${record.unit}` })),
    ],
    note: stabilityNote(lost.length, exact.length),
  };
}

function worstCases(record) {
  const { points } = stabilityPoints(record);
  const worst = points
    .toSorted((a, b) =>
      d3.descending(Number.isNaN(a.error) ? Infinity : a.error, Number.isNaN(b.error) ? Infinity : b.error),
    )
    .slice(0, 8);
  return dataTable(
    `The worst of ${plural(points.length, "hard case")}`,
    ["case", record.axis || "place", `error (${record.unit})`, "of the bound"],
    worst.map((p) => [
      p.name,
      readable(p.x),
      readable(p.error),
      `${readable((100 * p.error) / num(record.bound), 2)} %`,
    ]),
    [1, 2, 3],
  );
}

function stabilitySection() {
  let record = allStability[0];
  const table = h("div", {});
  const plot = figure(
    () => `stability-${slug(record.formula)}`,
    () =>
      `Relative error of ${record.formula} over its hard cases; claimed bound ${readable(record.bound)} ${record.unit}`,
    (width) => drawStability(record, width),
    () => [
      ["formula", "case", record.axis || "x", `error_${record.unit}`, "bound"],
      stabilityPoints(record).points.map((p) => [record.formula, p.name, p.x, p.error, num(record.bound)]),
    ],
  );
  const from = h("p", {});
  const show = (index) => {
    record = allStability[index];
    from.replaceChildren("Claim: ", claimLink(record.claim));
    table.replaceChildren(worstCases(record));
    plot.redraw();
  };
  const formula = choice(
    "Formula",
    allStability.map((r, i) => [i, r.formula]),
    show,
  );
  show(0);
  return section(
    "stability",
    "Stability",
    "Relative error of each formula where it can cancel, overflow or degenerate, against a multi-precision truth; one unit in the last place (ulp) is the spacing of doubles there.",
    h("div", { class: "controls" }, formula.element),
    from,
    plot.element,
    table,
  );
}
