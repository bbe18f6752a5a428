// A study: its texts, and each figure with its panels, controls and numbers.

/** What a series is of, and what it is held against: pictures of somebody's have no integrands. */
const SERIES = study?.renders ? "renders" : "estimator",
  SUBJECT = study?.renders ? "reference" : "integrand";

const paragraphs = (text) => text.split(/\n\s*\n/).filter((part) => part.trim()).map((part) => h("p", {}, part));

const sourceSays = (text) => (text ? h("blockquote", {}, h("b", {}, "The source: "), text) : null);

/** One plot for each integrand and metric, sharing the state of the figure's controls. */
function studyPanels(plan, state) {
  return plan.panels.flatMap((panel) => {
    const series = panel.series.map((index) => allSeries[index]);
    const xLabels = { ...state.xLabels, evaluations: panel.unit };
    const visible = () => series.filter((s) => !state.hidden.has(s.estimator));
    return plan.metrics.map((metric) => {
      const setting = () => ({ ...state, xLabels, y: state.y ?? metric });
      const several = plan.metrics.length > 1;
      const parts = [plan.panels.length > 1 ? panel.integrand : "", several ? metric : ""].filter(Boolean);
      const plot = figure(
        () => slug([plan.id, ...parts].join("-")),
        () => `${plan.title}: ${Y_AXES[setting().y].label} on ${panel.integrand} for ${study.renders ? visible().map((s) => s.estimator).join(", ") : plural(visible().length, SERIES)}`,
        (width) => drawSeries(visible(), setting(), width),
        () => seriesCsv(visible()),
      );
      const heading = several ? `${panel.integrand}: ${Y_AXES[metric].label}` : panel.integrand;
      return { element: h("div", { class: "panel" }, h("h3", { class: "id" }, heading), plot.element), redraw: plot.redraw };
    });
  });
}

function studyNumbers(plan) {
  const rows = plan.panels.flatMap((panel) => panel.series.map((index) => allSeries[index]));
  const table = dataTable(
    `Numbers of ${plan.title}`,
    [SERIES, SUBJECT, "fitted slope", "95 %", "expected", "theory", "largest n", "MSE there", "bias ± standard error"],
    rows.map((s) => {
      const last = s.points.at(-1);
      return [
        h("span", { class: "id" }, s.estimator),
        h("span", { class: "id" }, s.integrand),
        readable(s.slope.value),
        interval(s.slope),
        s.expected_text,
        slopeVerdict(s),
        count(last?.n),
        readable(last?.mse),
        `${readable(last?.bias)} ± ${readable(last?.bias_standard_error, 2)}`,
      ];
    }),
    [2, 3, 4, 6, 7, 8],
  );
  return h("div", { class: "numbers" }, table);
}

/** Of pictures, samples of a pixel are all that is counted, and seconds where the names of the files tell them. */
const renderAxes = () => ({ n: { ...X_AXES.n, label: "samples per pixel" }, seconds: X_AXES.seconds });

/** A plot's place in the bar of sections: over several studies, that of its study. */
const shortTitle = (plan) => (study.several ? plan.title.split(": ")[0] : plan.title);

function studySection(plan) {
  const state = {
    x: plan.x,
    y: null, // as each panel says
    xLabels: { n: plan.x_label },
    slopes: plan.slopes,
    bands: true,
    expected: false,
    hidden: new Set(),
  };
  const panels = studyPanels(plan, state);
  const redraw = () => panels.forEach((panel) => panel.redraw());
  const names = [...new Set(plan.panels.flatMap((panel) => panel.series.map((index) => allSeries[index].estimator)))];
  const toggle = (name) =>
    checkbox([swatch(name), h("span", { class: "id" }, name)], true, (on) => {
      on ? state.hidden.delete(name) : state.hidden.add(name);
      redraw();
    });
  const up = () => {
    state.y = plan.metrics[0];
    return axisChoice("Up", Y_AXES, state, "y", redraw);
  };
  const element = section(
    plan.id,
    plan.title,
    null,
    h("div", { class: "lead" }, paragraphs(plan.text), sourceSays(plan.source_says)),
    h(
      "div",
      { class: "controls" },
      axisChoice("Across", study.renders ? renderAxes() : X_AXES, state, "x", redraw),
      plan.metrics.length === 1 ? up() : null,
      toggleOf("Confidence bands", state, "bands", redraw),
      study.renders ? null : toggleOf("Expected slopes", state, "expected", redraw),
    ),
    h("fieldset", { class: "names" }, h("legend", {}, study.renders ? "Renders" : "Estimators"), names.map(toggle)),
    h(
      "div",
      { class: "panels" },
      panels.map((panel) => panel.element),
    ),
    studyNumbers(plan),
  );
  element.dataset.short = shortTitle(plan);
  return element;
}

const studyTexts = () => [study.source, ...study.headlines.map((one) => one.source)];

/** What is compared, then the figures. */
const studySections = () => [
  section(
    "about",
    study.renders ? "What is measured" : "What is compared",
    null,
    h("div", { class: "lead" }, paragraphs(study.text), study.source ? h("p", {}, "Source: ", cited(study.source)) : null),
  ),
  study.headlines.length ? headlineSection() : null,
  ...study.figures.map(studySection),
  sourcesSection(studyTexts()),
];
