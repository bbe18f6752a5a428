// A section with a plot of series, its controls, and a legend that is a table of what was fitted.

/** `state` holds {integrand, x, y, bands, expected, hidden}; `legend(list)` gives [headings, row of a series, numeric]. */
function seriesSection({ id, title, lead, state, controls, legend }) {
  const current = () => allSeries.filter((s) => s.integrand === state.integrand);
  const visible = () => current().filter((s) => !state.hidden.has(s.key));
  const legendBox = h("div", { class: "legend" });
  const plot = figure(() => `${id}-${slug(state.integrand)}`,
    () => `${title}: ${Y_AXES[state.y].label} against ${X_AXES[state.x].label} for ${plural(visible().length, "estimator")} on ${state.integrand}`,
    (width) => drawSeries(visible(), state, width), () => seriesCsv(visible()));

  const toggle = (series) => (on) => { on ? state.hidden.delete(series.key) : state.hidden.add(series.key); plot.redraw(); };
  const name = (series) => h("label", { class: "check" },
    checkboxOf(!state.hidden.has(series.key), toggle(series)), swatch(series.estimator), h("span", {}, series.estimator));
  const refresh = () => {
    const { headings, row, numeric } = legend;
    legendBox.replaceChildren(dataTable(`Estimators on ${state.integrand}`, ["estimator", ...headings],
      current().map((series) => [name(series), ...row(series)]), numeric));
    plot.redraw();
  };
  const showAll = (on) => () => {
    for (const series of current()) on ? state.hidden.delete(series.key) : state.hidden.add(series.key);
    refresh();
  };
  const choose = choice("Integrand", integrandsWithSeries().map(([integrand, list]) => [integrand, `${integrand} (${list.length})`]),
    (value) => { state.integrand = value; refresh(); });
  choose.select.value = state.integrand;
  refresh();
  return {
    element: section(id, title, lead, h("div", { class: "controls" }, choose.element, controls(plot.redraw)),
      plot.element, legendBox, h("div", { class: "buttons" }, button("Show all", showAll(true)), button("Hide all", showAll(false)))),
    show: (integrand) => { state.integrand = choose.select.value = integrand; refresh(); },
  };
}

const checkboxOf = (checked, onchange) => {
  const input = h("input", { type: "checkbox", checked, onchange: () => onchange(input.checked) });
  return input;
};

const axisChoice = (label, axes, state, key, redraw) => {
  const control = choice(label, Object.entries(axes).map(([value, axis]) => [value, axis.label]), (value) => { state[key] = value; redraw(); });
  control.select.value = state[key];
  return control.element;
};

function slopeVerdict(series) {
  const expected = series.expected_slope;
  if (!expected || Number.isNaN(num(series.slope.value))) return DASH;
  const apart = num(series.slope.high) < num(expected.low) || num(series.slope.low) > num(expected.high);
  return apart ? badge("refuted", "apart") : badge("holds", "agrees");
}

function expectedText(expected) {
  if (!expected) return DASH;
  return num(expected.low) === num(expected.high) ? readable(expected.low) : `${readable(expected.low)} to ${readable(expected.high)}`;
}

function convergenceSection() {
  const state = { integrand: mostCompared(), x: "n", y: "mse", bands: true, expected: true, hidden: new Set() };
  return seriesSection({
    id: "convergence", title: "Convergence", state,
    lead: "Error against sample count over independent replicates. Bands are 95 % intervals of the MSE; dashed lines have the slope that theory expects; slopes are those of log MSE on log n.",
    controls: (redraw) => [axisChoice("Error", { mse: Y_AXES.mse, rmse: Y_AXES.rmse }, state, "y", redraw),
      checkbox("Confidence bands", true, (on) => { state.bands = on; redraw(); }),
      checkbox("Expected slopes", true, (on) => { state.expected = on; redraw(); })],
    legend: {
      headings: ["fitted slope", "95 %", "expected", "", "replicates", "claim"], numeric: [1, 2, 3, 5],
      row: (s) => [readable(s.slope.value), interval(s.slope), expectedText(s.expected_slope), slopeVerdict(s), count(s.replicates),
        s.claim ? claimLink(s.claim) : DASH],
    },
  });
}

function workSection() {
  const state = { integrand: mostCompared(), x: "evaluations", y: "mse", bands: true, expected: false, hidden: new Set() };
  const last = (s) => s.points.at(-1);
  return seriesSection({
    id: "work", title: "Work–precision", state,
    lead: "What an error costs: the same measurements against evaluations of the integrand or against seconds. Efficiency is 1 / (MSE × cost), the cost in evaluations, or in seconds when they are the axis. Seconds depend on the machine and decide nothing.",
    controls: (redraw) => [axisChoice("Across", X_AXES, state, "x", redraw), axisChoice("Up", Y_AXES, state, "y", redraw),
      checkbox("Confidence bands", true, (on) => { state.bands = on; redraw(); })],
    legend: {
      headings: ["largest n", "evaluations", "seconds", "MSE", "bias ± standard error"], numeric: [1, 2, 3, 4, 5],
      row: (s) => [last(s).n, count(last(s).evaluations), seconds(last(s).seconds), readable(last(s).mse),
        `${readable(last(s).bias)} ± ${readable(last(s).bias_standard_error, 2)}`].map(String),
    },
  });
}
