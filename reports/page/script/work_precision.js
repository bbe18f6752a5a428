// Error against what it costs.

function workSection() {
  const state = {
    integrand: mostCompared(),
    x: "evaluations",
    y: "mse",
    bands: true,
    expected: false,
    hidden: new Set(),
  };
  const last = (s) => s.points.at(-1);
  const errors = Object.fromEntries(Object.entries(Y_AXES).filter(([, axis]) => !axis.by_truth)); // no integral here
  return seriesSection({
    id: "work",
    title: "Work–precision",
    state,
    lead: "What an error costs: the same measurements against evaluations (of an integrand, or rays of a scene) or against seconds. Efficiency is 1 / (MSE × cost), the cost in evaluations, or in seconds when they are the axis. Seconds depend on the machine and decide nothing.",
    controls: (redraw) => [
      axisChoice("Across", X_AXES, state, "x", redraw),
      axisChoice("Up", errors, state, "y", redraw),
      toggleOf("Confidence bands", state, "bands", redraw),
    ],
    legend: {
      headings: ["largest n", "evaluations", "seconds", "MSE", "bias ± standard error"],
      numeric: [1, 2, 3, 4, 5],
      row: (s) =>
        [
          last(s).n,
          count(last(s).evaluations),
          seconds(last(s).seconds),
          readable(last(s).mse),
          `${readable(last(s).bias)} ± ${readable(last(s).bias_standard_error, 2)}`,
        ].map(String),
    },
  });
}
