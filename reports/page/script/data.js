// What the program wrote into the page, and how claims, mutants and series hang together.

const { results, against, study, axes } = JSON.parse(document.getElementById("data").textContent);

const claims = results.claims ?? [];
const mutants = results.mutants ?? [];
const claimById = new Map(claims.map((claim) => [claim.id, claim]));
const mutantsOf = d3.group(mutants, (mutant) => mutant.of);

/** Every series of the run, with the claim it was measured for ("" when for none) and numbers for plotting. */
const allSeries = [
  ...claims.flatMap((claim) => (claim.series ?? []).map((series) => ({ ...series, claim: claim.id }))),
  ...(results.series ?? []).map((series) => ({ ...series, claim: "" })),
].map((series, index) => ({ ...series, key: `s${index}`, points: series.points.map(numericPoint) }));

const allStability = claims.flatMap((claim) =>
  (claim.stability ?? []).map((record) => ({ ...record, claim: claim.id })),
);

/** `metrics` holds what each metric says at the point, as [value, low, high]. */
function numericPoint({ metrics, ...point }) {
  const mapped = (object, of) => Object.fromEntries(Object.entries(object).map(([name, value]) => [name, of(value)]));
  return { ...mapped(point, num), metrics: mapped(metrics, (triple) => triple.map(num)) };
}

const OUTCOMES = {
  holds: { sign: "✓", label: "holds", many: "hold" },
  undecided: { sign: "?", label: "undecided", many: "undecided" },
  refuted: { sign: "✕", label: "refuted", many: "refuted" },
};

function badge(outcome, text = OUTCOMES[outcome].label) {
  return h(
    "span",
    { class: `badge ${outcome}` },
    h("span", { "aria-hidden": "true" }, OUTCOMES[outcome].sign),
    ` ${text}`,
  );
}

const countOutcomes = (list) =>
  Object.keys(OUTCOMES).map((outcome) => [outcome, list.filter((x) => x.outcome === outcome).length]);

const claimLink = (id, text = id) =>
  claimById.has(id) ? h("a", { href: `#claim=${id}`, class: "id" }, text) : h("span", { class: "id" }, text);
