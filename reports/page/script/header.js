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

/** What was done, and what the words mean. */
function introduction() {
  const { run } = results;
  const what = run.patterns ? `the claims of ${run.patterns}` : "every claim";
  return h(
    "div",
    { class: "lead" },
    h("p", {}, `This run drew random numbers (seed ${run.seed}) until it could judge ${what}: ${plural(claims.length, "claim")} with ${plural(mutants.length, "mutant")}.`),
    h("p", {}, "A claim is a sentence about an estimator with a number δ: it holds only where a deviation as large as δ is excluded, at a risk of 1 %; it is refuted where the numbers contradict it; else it is undecided."),
    h("p", {}, "A mutant is a subject with a known defect that its claim must refute, so that a test which cannot fail shows itself."),
  );
}

/** The share of δ that a claim's interval leaves free: 1 where nothing can hide, 0 at δ itself; null without a δ. */
function roomLeft(claim) {
  const [low, high, delta] = [num(claim.deviation.low), num(claim.deviation.high), num(claim.resolution)];
  if (![low, high, delta].every(Number.isFinite) || !(delta > 0)) return null;
  return 1 - Math.max(Math.abs(low), Math.abs(high)) / delta;
}

/** A stroke for each claim at the room that it leaves to δ, which stands at the right; what is beyond stands there. */
function roomStrip(list) {
  const width = 132,
    height = 14,
    place = (room) => 2 + (1 - Math.max(room, 0)) * (width - 4);
  const rooms = list.map((claim) => [claim, roomLeft(claim)]).filter(([, room]) => room !== null);
  if (!rooms.length) return DASH;
  const [tightest, least] = d3.least(rooms, ([, room]) => room);
  const text = `${plural(rooms.length, "claim")} with a δ; the least room, ${Math.round(100 * Math.max(least, 0))} %, is left by ${tightest.id}`;
  return svgElement(
    "svg",
    { class: "room", width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": text },
    svgElement("title", {}, text),
    svgElement("path", { d: `M2,${height - 1}H${width - 2}M${width - 2},0V${height}`, class: "axis" }),
    ...rooms.map(([claim, room]) => svgElement("path", { d: `M${place(room).toFixed(1)},2V${height - 2}`, class: claim.outcome })),
  );
}

function methodTable(chooseMethod) {
  const rows = [...d3.group(claims, (claim) => methodOf(claim.id))].map(([method, list]) => {
    const of = list.flatMap((claim) => mutantsOf.get(claim.id) ?? []);
    return [
      h("a", { href: "#verdicts", onclick: () => chooseMethod(method) }, method),
      roomStrip(list),
      ...countOutcomes(list).map(([, n]) => (n ? String(n) : DASH)),
      `${of.filter((m) => m.killed).length}/${of.length}`,
      count(d3.sum(list, (c) => c.samples)),
      seconds(d3.sum(list, (c) => num(c.seconds))),
    ];
  });
  const table = dataTable(
    "Claims by method",
    ["method", "room left to δ", ...Object.keys(OUTCOMES), "mutants refuted", "samples", "time"],
    rows,
    [2, 3, 4, 5, 6, 7],
  );
  return h(
    "details",
    { class: "fold", open: rows.length <= 12 },
    h("summary", {}, `By method (${rows.length})`),
    h("p", { class: "note" }, "Each stroke is a claim: the further to the left, the more of its δ is left free; δ stands at the right end."),
    table,
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
