// The list of verdicts: filters, one line a claim, its evidence behind the line.

const SORTS = {
  catalogue: { label: "as catalogued", by: null },
  outcome: { label: "worst first", by: (a, b) => severity(b) - severity(a) },
  seconds: { label: "slowest first", by: (a, b) => num(b.seconds) - num(a.seconds) },
  samples: { label: "most samples first", by: (a, b) => b.samples - a.samples },
};
const severity = (claim) => ["holds", "undecided", "refuted"].indexOf(claim.outcome);

/** One claim: the line, and its evidence, which is made when it is first opened. */
function claimItem(claim, showSeries) {
  const cell = (name, ...content) => h("span", { class: name }, ...content);
  const summary = h(
    "summary",
    {},
    badge(claim.outcome),
    cell("what", cell("id", claim.id), cell("statement", claim.statement)),
    cell("kind", claim.kind),
    cell("deviation", deviationGlyph(claim) ?? ""),
    cell("number samples", count(claim.samples)),
    cell("number time", seconds(claim.seconds)),
  );
  const item = h("details", { class: `claim ${claim.outcome}`, id: `claim=${claim.id}` }, summary);
  item.addEventListener("toggle", () => item.append(evidence(claim, showSeries)), { once: true });
  return item;
}

/** Whether a claim is to be shown. */
function passes(filter, claim) {
  const words = [claim.id, claim.statement, claim.source, claim.reason].join(" ").toLowerCase();
  return (
    filter.outcomes.has(claim.outcome) &&
    (!filter.kind || claim.kind === filter.kind) &&
    (!filter.method || methodOf(claim.id) === filter.method) &&
    filter.text
      .toLowerCase()
      .split(/\s+/)
      .every((word) => words.includes(word))
  );
}

/** The controls of the list: they change `filter` and call `refresh`. */
function filterControls(filter, refresh) {
  const set = (key) => (value) => {
    filter[key] = value;
    refresh();
  };
  const any = (of) => [["", "all"], ...[...new Set(claims.map(of))].map((value) => [value, value])];
  const outcomes = countOutcomes(claims).map(([outcome, n]) =>
    checkbox(`${OUTCOMES[outcome].label} (${n})`, true, (on) => {
      on ? filter.outcomes.add(outcome) : filter.outcomes.delete(outcome);
      refresh();
    }),
  );
  const method = choice(
    "Method",
    any((claim) => methodOf(claim.id)),
    set("method"),
  );
  const kind = choice(
    "Kind",
    any((claim) => claim.kind),
    set("kind"),
  );
  const order = choice(
    "Order",
    Object.entries(SORTS).map(([key, sort]) => [key, sort.label]),
    set("sort"),
  );
  const search = h("input", {
    type: "search",
    placeholder: "words in id, statement, source",
    oninput: () => set("text")(search.value),
  });
  const element = h(
    "div",
    { class: "controls" },
    h("fieldset", {}, h("legend", {}, "Outcome"), outcomes),
    method.element,
    kind.element,
    order.element,
    h("label", { class: "control" }, h("span", {}, "Search"), search),
  );
  return {
    element,
    chooseMethod: (name) => {
      method.select.value = name;
      set("method")(name);
    },
  };
}

/** The claims of each method behind a line that says how they ended, open where not all is well or little is shown. */
function foldedByMethod(chosen, items) {
  const groups = [...d3.group(chosen, (claim) => methodOf(claim.id))];
  if (groups.length < 2) return chosen.map((claim) => items.get(claim));
  return groups.map(([method, list]) => {
    const counts = countOutcomes(list).filter(([, n]) => n);
    const words = counts.map(([outcome, n]) => badge(outcome, `${n} ${OUTCOMES[outcome].many}`));
    return h(
      "details",
      { class: "fold method", open: chosen.length <= 40 || counts.some(([outcome]) => outcome !== "holds") },
      h("summary", {}, h("b", {}, method), " ", words),
      list.map((claim) => items.get(claim)),
    );
  });
}

function verdictSection(showSeries) {
  const filter = { outcomes: new Set(Object.keys(OUTCOMES)), kind: "", method: "", text: "", sort: "catalogue" };
  const items = new Map(claims.map((claim) => [claim, claimItem(claim, showSeries)]));
  const list = h("div", { class: "claims" });
  const shown = h("p", { class: "note", role: "status" });
  const refresh = () => {
    const chosen = claims.filter((claim) => passes(filter, claim));
    const { by } = SORTS[filter.sort];
    if (by) list.replaceChildren(...chosen.sort(by).map((claim) => items.get(claim)));
    else list.replaceChildren(...foldedByMethod(chosen, items));
    shown.textContent = `${chosen.length} of ${plural(claims.length, "claim")} shown`;
  };
  const open = (id) => {
    const item = items.get(claimById.get(id));
    if (!item) return;
    if (!item.isConnected) list.append(item); // a filter hides it: the link counts more
    const fold = item.closest("details.fold");
    if (fold) fold.open = true;
    item.open = true;
    item.scrollIntoView({ block: "start" });
    item.querySelector("summary").focus({ preventScroll: true });
  };
  const controls = filterControls(filter, refresh);
  const headings = ["outcome", "claim", "kind", "deviation", "samples", "time"].map((text) => h("span", {}, text));
  refresh();
  const element = section(
    "verdicts",
    "Verdicts",
    "A claim holds when the interval of its deviation lies within what it promised to exclude: more than “not rejected”. The glyph shows that interval over the band ± what could still hide.",
    controls.element,
    shown,
    h("div", { class: "claim-head", "aria-hidden": "true" }, headings),
    list,
  );
  return { element, chooseMethod: controls.chooseMethod, open };
}
