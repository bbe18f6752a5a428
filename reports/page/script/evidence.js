// What stands behind a verdict.

const term = (name, ...value) => h("div", {}, h("dt", {}, name), h("dd", {}, ...value));
const bullets = (items) =>
  h(
    "ul",
    {},
    items.map((item) => h("li", {}, item)),
  );
const number = (name, value, format = readable) => (Number.isNaN(num(value)) ? [] : term(name, format(value)));

/** A field of the evidence: numbers readable, long lists cut with the rest behind a click. */
function evidenceValue(value) {
  if (!Array.isArray(value)) return readable(value, 9);
  const text = value.map((x) => readable(x, 4));
  if (text.length <= 12) return text.join(", ");
  const start = `${text.slice(0, 8).join(", ")}, … (${text.length} values)`;
  return h("details", {}, h("summary", {}, start), text.slice(8).join(", "));
}

function mutantLines(claim) {
  const list = mutantsOf.get(claim.id) ?? [];
  if (list.length === 0) return claim.no_mutant ? term("No mutant", claim.no_mutant) : [];
  const line = (mutant) => [killBadge(mutant), ` ${mutant.id.replace(`${claim.id}/`, "")}: ${mutant.defect}`];
  return term("Mutants", bullets(list.map(line)));
}

function seriesLinks(claim, showSeries) {
  if (!claim.series?.length) return [];
  const link = ([integrand, list]) => {
    const text = `${list.map((series) => series.estimator).join("; ")} on ${integrand}`;
    return h("a", { href: "#convergence", onclick: () => showSeries(integrand) }, text);
  };
  return term("Series", bullets(d3.groups(claim.series, (series) => series.integrand).map(link)));
}

/** What is still possible after `holds`; for the other outcomes, what the claim would have excluded. */
function resolution(claim) {
  const found = num(claim.resolution);
  return number(claim.outcome === "holds" ? "could still hide" : "to be excluded", found, (x) =>
    x === 0 ? "nothing" : `±${readable(x)}`,
  );
}

function evidence(claim, showSeries) {
  const deviation = interval(claim.deviation);
  const fields = Object.entries(claim.evidence).map(([name, value]) =>
    term(name.replaceAll("_", " "), evidenceValue(value)),
  );
  return h(
    "div",
    { class: "evidence" },
    h(
      "dl",
      { class: "texts" },
      term("Why", claim.reason || DASH),
      term("Source", cited(claim.source)),
      mutantLines(claim),
      seriesLinks(claim, showSeries),
    ),
    h(
      "dl",
      { class: "facts" },
      deviation === DASH ? [] : term("deviation", deviation),
      resolution(claim),
      number("statistic", claim.statistic),
      number("p-value", claim.p_value),
      num(claim.alpha_share) > 0 ? term("false-alarm share", readable(claim.alpha_share)) : [],
      term("samples", num(claim.samples).toLocaleString("en")),
      term("time", seconds(claim.seconds)),
      fields,
    ),
  );
}
