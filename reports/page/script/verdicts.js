// The list of verdicts: filters, one line a claim, its evidence behind the line.

const SORTS = {
  catalogue: { label: "as catalogued", by: null },
  outcome: { label: "worst first", by: (a, b) => severity(b) - severity(a) },
  seconds: { label: "slowest first", by: (a, b) => num(b.seconds) - num(a.seconds) },
  samples: { label: "most samples first", by: (a, b) => b.samples - a.samples },
};
const severity = (claim) => ["holds", "undecided", "refuted"].indexOf(claim.outcome);

const term = (name, ...value) => h("div", {}, h("dt", {}, name), h("dd", {}, ...value));
const number = (name, value, format = readable) => (Number.isNaN(num(value)) ? [] : term(name, format(value)));

/** A field of the evidence: numbers readable, long lists cut with the rest behind a click. */
function evidenceValue(value) {
  if (!Array.isArray(value)) return typeof value === "string" && !Number.isFinite(num(value)) && !/^-?inf$/.test(value) ? value : readable(value, 9);
  const text = value.map((x) => readable(x, 4));
  if (text.length <= 12) return text.join(", ");
  return h("details", {}, h("summary", {}, `${text.slice(0, 8).join(", ")}, … (${text.length} values)`), text.slice(8).join(", "));
}

function mutantLines(claim) {
  const list = mutantsOf.get(claim.id) ?? [];
  if (list.length === 0) return claim.no_mutant ? term("No mutant", claim.no_mutant) : [];
  return term("Mutants", h("ul", {}, list.map((mutant) =>
    h("li", {}, killBadge(mutant), ` ${mutant.id.replace(`${claim.id}/`, "")}: ${mutant.defect}`))));
}

function seriesLinks(claim, showSeries) {
  if (!claim.series?.length) return [];
  const links = [...d3.group(claim.series, (series) => series.integrand)].map(([integrand, list]) => h("li", {},
    h("a", { href: "#convergence", onclick: () => showSeries(integrand) }, `${list.map((s) => s.estimator).join("; ")} on ${integrand}`)));
  return term("Series", h("ul", {}, links));
}

/** What is still possible after `holds`; for the other outcomes, what the claim would have excluded. */
function resolution(claim) {
  const found = num(claim.resolution);
  return number(claim.outcome === "holds" ? "could still hide" : "to be excluded", found, (x) => (x === 0 ? "nothing" : `±${readable(x)}`));
}

function evidence(claim, showSeries) {
  const deviation = interval(claim.deviation);
  const fields = Object.entries(claim.evidence).map(([name, value]) => term(name.replaceAll("_", " "), evidenceValue(value)));
  return h("div", { class: "evidence" },
    h("dl", { class: "texts" }, term("Why", claim.reason || DASH), term("Source", claim.source), mutantLines(claim), seriesLinks(claim, showSeries)),
    h("dl", { class: "facts" },
      deviation === DASH ? [] : term("deviation", deviation), resolution(claim),
      number("statistic", claim.statistic), number("p-value", claim.p_value),
      num(claim.alpha_share) > 0 ? term("false-alarm share", readable(claim.alpha_share)) : [],
      term("samples", num(claim.samples).toLocaleString("en")), term("time", seconds(claim.seconds)), fields));
}

/** One claim: the line, and its evidence, which is made when it is first opened. */
function claimItem(claim, showSeries) {
  const item = h("details", { class: `claim ${claim.outcome}`, id: `claim-${slug(claim.id)}` },
    h("summary", {}, badge(claim.outcome),
      h("span", { class: "what" }, h("span", { class: "id" }, claim.id), h("span", { class: "statement" }, claim.statement)),
      h("span", { class: "kind" }, claim.kind), h("span", { class: "deviation" }, deviationGlyph(claim) ?? ""),
      h("span", { class: "number samples" }, count(claim.samples)), h("span", { class: "number time" }, seconds(claim.seconds))));
  item.addEventListener("toggle", () => { item.append(evidence(claim, showSeries)); }, { once: true });
  return item;
}

const unique = (list) => [...new Set(list)];
const withAll = (values, all) => [["", all], ...values.map((value) => [value, value])];

function verdictSection(showSeries) {
  const filter = { outcomes: new Set(Object.keys(OUTCOMES)), kind: "", method: "", text: "", sort: "catalogue" };
  const items = new Map(claims.map((claim) => [claim, claimItem(claim, showSeries)]));
  const list = h("div", { class: "claims" }), shown = h("p", { class: "note", role: "status" });
  const words = (claim) => [claim.id, claim.statement, claim.source, claim.reason].join(" ").toLowerCase();
  const passes = (claim) => filter.outcomes.has(claim.outcome) && (!filter.kind || claim.kind === filter.kind) &&
    (!filter.method || methodOf(claim.id) === filter.method) && filter.text.toLowerCase().split(/\s+/).every((word) => words(claim).includes(word));
  const refresh = () => {
    const chosen = claims.filter(passes), { by } = SORTS[filter.sort];
    if (by) chosen.sort(by);
    list.replaceChildren(...chosen.map((claim) => items.get(claim)));
    shown.textContent = `${chosen.length} of ${plural(claims.length, "claim")} shown`;
  };
  const set = (key) => (value) => { filter[key] = value; refresh(); };
  const outcomes = countOutcomes(claims).map(([outcome, n]) => checkbox(`${OUTCOMES[outcome].label} (${n})`, true, (on) => {
    on ? filter.outcomes.add(outcome) : filter.outcomes.delete(outcome); refresh(); }));
  const method = choice("Method", withAll(unique(claims.map((c) => methodOf(c.id))), "all"), set("method"));
  const search = h("input", { type: "search", placeholder: "words in id, statement, source", oninput: () => set("text")(search.value) });
  refresh();

  const element = section("verdicts", "Verdicts",
    "A claim holds when the interval of its deviation lies within what it promised to exclude: more than “not rejected”. The glyph shows that interval over the band ± what could still hide.",
    h("div", { class: "controls" }, h("fieldset", {}, h("legend", {}, "Outcome"), outcomes), method.element,
      choice("Kind", withAll(unique(claims.map((c) => c.kind)), "all"), set("kind")).element,
      choice("Order", Object.entries(SORTS).map(([key, sort]) => [key, sort.label]), set("sort")).element,
      h("label", { class: "control" }, h("span", {}, "Search"), search)),
    shown,
    h("div", { class: "claim-head", "aria-hidden": "true" }, ["outcome", "claim", "kind", "deviation", "samples", "time"].map((t) => h("span", {}, t))),
    list);
  return {
    element,
    chooseMethod: (name) => { method.select.value = filter.method = name; refresh(); },
    open: (id) => {
      const item = items.get(claimById.get(id));
      if (!item) return;
      if (!item.isConnected) list.append(item);
      item.open = true;
      item.scrollIntoView({ block: "start" });
      item.querySelector("summary").focus({ preventScroll: true });
    },
  };
}
