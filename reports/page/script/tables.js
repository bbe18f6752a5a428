// Mutants, errata, differences: tables.

const killBadge = (mutant) => (mutant.killed ? badge("holds", "refuted") : badge("refuted", "lives"));

function mutantSection() {
  const living = mutants.filter((mutant) => !mutant.killed);
  const rows = [...living, ...mutants.filter((mutant) => mutant.killed)];
  return section(
    "mutants",
    "Mutants",
    `A mutant is a subject with a known defect that its claim must refute. ${mutants.length - living.length} of ${mutants.length} were refuted${living.length ? "; the living come first" : ""}.`,
    dataTable(
      "Mutants",
      ["outcome", "mutant", "defect", "deviation", "samples", "time"],
      rows.map((mutant) => [
        killBadge(mutant),
        h(
          "span",
          { class: "id" },
          claimLink(mutant.of),
          h("wbr"),
          mutant.id.startsWith(mutant.of) ? mutant.id.slice(mutant.of.length) : ` ← ${mutant.id}`,
        ),
        mutant.defect,
        deviationGlyph(mutant) ?? DASH,
        count(mutant.samples),
        seconds(mutant.seconds),
      ]),
      [4, 5],
    ),
  );
}

function errataSection() {
  return section(
    "errata",
    "Errata of sources",
    "Statements of the literature that are wrong, what is right instead, and the claim that shows it.",
    dataTable(
      "Errata",
      ["source", "as printed", "correct", "shown by"],
      results.errata.map((e) => {
        const claim = claimById.get(e.claim);
        return [
          h("span", {}, cited(e.source)),
          e.printed,
          e.correct,
          h("span", {}, claim ? badge(claim.outcome) : null, " ", claimLink(e.claim)),
        ];
      }),
    ),
  );
}

const idList = (title, ids) =>
  ids.length
    ? [
        h("h3", {}, `${title} (${ids.length})`),
        h(
          "ul",
          { class: "ids" },
          ids.map((id) => h("li", {}, claimLink(id))),
        ),
      ]
    : [];

function differencesSection() {
  const { run, differences: d } = against;
  const changed = (title, list) =>
    list.length
      ? dataTable(
          title,
          ["id", "before", "now"],
          list.map((c) => [claimLink(c.id), badge(c.before), badge(c.after)]),
        )
      : null;
  const same = Object.values(d).every((list) => !list.length);
  return section(
    "differences",
    "Differences",
    `Against the ${run.size} run of ${run.started.replace("T", " ").replace("Z", " UTC")}, seed ${run.seed}, version ${run.version}.`,
    same ? h("p", {}, "No outcome changed; the same claims and mutants.") : null,
    d.not_asked
      ? h("p", { class: "note" }, `Compared is what both runs were asked for: ${plural(d.not_asked, "other verdict")} left out.`)
      : null,
    changed("Claims with another outcome", d.claims),
    changed("Mutants with another outcome", d.mutants),
    idList("Added claims", d.added),
    idList("Removed claims", d.removed),
    idList("Added mutants", d.added_mutants),
    idList("Removed mutants", d.removed_mutants),
  );
}
