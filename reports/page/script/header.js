// The head of the page: what ran, how it ended, and the outcome by method.

function runFacts(run) {
  const fact = (name, value) =>
    value === null || value === "" ? [] : [h("div", {}, h("dt", {}, name), h("dd", {}, value))];
  return h(
    "dl",
    { class: "facts" },
    fact("started", run.started.replace("T", " ").replace("Z", " UTC")),
    fact("size", claims.length || study?.several ? run.size : ""),
    fact("seed", run.seed),
    fact("false-alarm budget α", run.alpha === null ? "" : readable(run.alpha)),
    fact("threads", String(run.threads)),
    fact("wall clock", seconds(run.seconds)),
    fact("version", run.version),
    fact("selected", run.patterns),
    fact("shard", run.shards === 1 ? "" : `${run.shard} of ${run.shards}`),
    fact("state", run.finished ? "" : `unfinished: ${claims.length + mutants.length} verdicts so far`),
  );
}

function tallyCards() {
  const killed = mutants.filter((mutant) => mutant.killed).length;
  const card = (kind, value, label) =>
    h("li", { class: `card ${kind}` }, h("span", { class: "value" }, value), h("span", { class: "label" }, label));
  return h(
    "ul",
    { class: "cards" },
    countOutcomes(claims).map(([outcome, n]) =>
      card(
        n || outcome === "holds" ? outcome : "none",
        String(n),
        `${OUTCOMES[outcome].sign} ${OUTCOMES[outcome].many}`,
      ),
    ),
    card(killed === mutants.length ? "holds" : "refuted", `${killed}/${mutants.length}`, "mutants refuted"),
  );
}

/** The shares of the outcomes as a bar; the numbers stand beside it. */
const outcomeBar = (list) =>
  h(
    "span",
    { class: "bar", "aria-hidden": "true" },
    countOutcomes(list)
      .filter(([, n]) => n)
      .map(([outcome, n]) => h("span", { class: outcome, style: `flex-grow:${n}` })),
  );

function methodTable(chooseMethod) {
  const rows = [...d3.group(claims, (claim) => methodOf(claim.id))].map(([method, list]) => {
    const of = list.flatMap((claim) => mutantsOf.get(claim.id) ?? []);
    return [
      h("a", { href: "#verdicts", onclick: () => chooseMethod(method) }, method),
      outcomeBar(list),
      ...countOutcomes(list).map(([, n]) => (n ? String(n) : DASH)),
      `${of.filter((m) => m.killed).length}/${of.length}`,
      count(d3.sum(list, (c) => c.samples)),
      seconds(d3.sum(list, (c) => num(c.seconds))),
    ];
  });
  return dataTable(
    "Claims by method",
    ["method", "", ...Object.keys(OUTCOMES), "mutants refuted", "samples", "time"],
    rows,
    [2, 3, 4, 5, 6, 7],
  );
}

/** A plumb line: a cord, a bob, the ground. */
const mark = () =>
  svgElement(
    "svg",
    { class: "mark", viewBox: "0 0 24 40", width: 24, height: 40, "aria-hidden": "true" },
    svgElement("path", { d: "M12 0V22", class: "cord" }),
    svgElement("path", { d: "M7 22h10l-2 8-3 7-3-7z", class: "bob" }),
  );

/** Links to the sections; of several with one short title, to the first. */
function sectionLinks(sections) {
  const texts = sections.map((s) => s.dataset.short ?? s.querySelector("h2").textContent);
  return sections
    .map((s, i) => (texts[i] === texts[i - 1] ? null : h("li", {}, h("a", { href: `#${s.id}` }, texts[i]))))
    .filter(Boolean);
}

function pageHeader(title, sections) {
  return [
    h("header", {}, mark(), h("div", {}, h("h1", {}, title), runFacts(results.run))),
    h(
      "nav",
      { "aria-label": "Sections" },
      h("ul", {}, sectionLinks(sections)),
    ),
  ];
}
