// Error against sample count, and the slopes.

function slopeVerdict(series) {
  const meets = series.meets_expectation;
  if (meets === null) return DASH;
  return meets ? badge("holds", "agrees") : badge("undecided", "apart");
}

function convergenceSection() {
  const state = { integrand: mostCompared(), x: "n", y: "mse", bands: true, expected: true, hidden: new Set() };
  return seriesSection({
    id: "convergence",
    title: "Convergence",
    state,
    lead: "Error against sample count over independent replicates. Bands are 95 % intervals of the MSE; dashed lines have the slope that theory expects; slopes are those of log MSE on log n. One true slope in twenty lies outside its 95 % interval: verdicts stand with the claims.",
    controls: (redraw) => [
      axisChoice("Error", { mse: Y_AXES.mse, rmse: Y_AXES.rmse }, state, "y", redraw),
      toggleOf("Confidence bands", state, "bands", redraw),
      toggleOf("Expected slopes", state, "expected", redraw),
    ],
    legend: {
      headings: ["fitted slope", "95 %", "expected", "theory", "replicates", "claim"],
      numeric: [1, 2, 3, 5],
      row: (s) => [
        readable(s.slope.value),
        interval(s.slope),
        s.expected_text,
        slopeVerdict(s),
        count(s.replicates),
        s.claim ? claimLink(s.claim) : DASH,
      ],
    },
  });
}
