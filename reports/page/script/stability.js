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

function drawStability(record, width) {
  const { points, label } = stabilityPoints(record);
  const bound = num(record.bound);
  const [low, high] = d3.extent(points, (p) => p.at);
  const wide = low > 0 && high / low > 1e3;
  const finite = points.filter((p) => Number.isFinite(p.error));
  const lost = points.filter((p) => !Number.isFinite(p.error));
  const top = 1.15 * Math.max(bound, d3.max(finite, (p) => p.error) ?? 0, Number.MIN_VALUE);
  const colour = (p) => (p.error <= bound ? "var(--series-0)" : "var(--refuted)");
  const tip = (p) => `${p.name}\n${readable(p.error)} ${record.unit}`;
  return {
    height: 300,
    marginLeft: 52,
    marginBottom: 42,
    marginRight: 64,
    marginTop: 28,
    x: wide
      ? logAxis(label, width, logDomain([low, high]))
      : { label, grid: true, inset: 8, ticks: Math.max(3, Math.floor(width / 110)) },
    y: { label: `relative error (${record.unit})`, domain: [0, top], grid: true, ticks: 5 },
    symbol: { type: "identity" },
    marks: [
      Plot.ruleY([0], { stroke: "var(--rule)" }),
      Plot.ruleY([bound], { stroke: "var(--refuted)", strokeDasharray: "6 4", strokeWidth: 1.5 }),
      Plot.text([bound], {
        y: (b) => b,
        frameAnchor: "right",
        text: () => `bound ${readable(bound)}`,
        dx: 60,
        fill: "var(--refuted)",
        textAnchor: "end",
      }),
      Plot.dot(finite, {
        x: "at",
        y: "error",
        stroke: colour,
        fill: colour,
        fillOpacity: 0.25,
        symbol: (p) => (p.error <= bound ? "circle" : "times"),
        r: 4,
      }),
      Plot.text(lost, { x: "at", y: () => top, text: () => "△", fill: "var(--refuted)" }),
      Plot.tip(finite, Plot.pointer({ x: "at", y: "error", title: tip })),
    ],
    note: lost.length ? `${plural(lost.length, "case")} with an infinite or undefined error, marked △ at the top.` : "",
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
