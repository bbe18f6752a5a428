// A section with a plot of series, its controls, and a legend that is a table of what was fitted.

/** `state` holds {integrand, x, y, bands, expected, hidden}; `legend` holds {headings, row(series), numeric}. */
function seriesSection({ id, title, lead, state, controls, legend }) {
  const current = () => allSeries.filter((s) => s.integrand === state.integrand);
  const visible = () => current().filter((s) => !state.hidden.has(s.key));
  const legendBox = h("div", { class: "legend" });
  const plot = figure(
    () => `${id}-${slug(state.integrand)}`,
    () =>
      `${title}: ${Y_AXES[state.y].label} against ${X_AXES[state.x].label} for ${plural(visible().length, "estimator")} on ${state.integrand}`,
    (width) => drawSeries(visible(), state, width),
    () => seriesCsv(visible()),
  );

  const toggle = (series) => (on) => {
    on ? state.hidden.delete(series.key) : state.hidden.add(series.key);
    plot.redraw();
  };
  const name = (series) =>
    checkbox([swatch(series.estimator), series.estimator], !state.hidden.has(series.key), toggle(series));
  const refresh = () => {
    const { headings, row, numeric } = legend;
    legendBox.replaceChildren(
      dataTable(
        `Estimators on ${state.integrand}`,
        ["estimator", ...headings],
        current().map((series) => [name(series), ...row(series)]),
        numeric,
      ),
    );
    plot.redraw();
  };
  const showAll = (on) => () => {
    for (const series of current()) on ? state.hidden.delete(series.key) : state.hidden.add(series.key);
    refresh();
  };
  const choose = choice(
    "Integrand",
    integrandsWithSeries().map(([integrand, list]) => [integrand, `${integrand} (${list.length})`]),
    (value) => {
      state.integrand = value;
      refresh();
    },
  );
  choose.select.value = state.integrand;
  refresh();
  return {
    element: section(
      id,
      title,
      lead,
      h("div", { class: "controls" }, choose.element, controls(plot.redraw)),
      plot.element,
      legendBox,
      h("div", { class: "buttons" }, button("Show all", showAll(true)), button("Hide all", showAll(false))),
    ),
    show: (integrand) => {
      state.integrand = choose.select.value = integrand;
      refresh();
    },
  };
}

const axisChoice = (label, axes, state, key, redraw) => {
  const control = choice(
    label,
    Object.entries(axes).map(([value, axis]) => [value, axis.label]),
    (value) => {
      state[key] = value;
      redraw();
    },
  );
  control.select.value = state[key];
  return control.element;
};

const toggleOf = (label, state, key, redraw) =>
  checkbox(label, state[key], (on) => {
    state[key] = on;
    redraw();
  });
