// Puts the page together from what the run has.

function overviewSection(chooseMethod) {
  return section("overview", "Outcome", null, introduction(), tallyCards(), methodTable(chooseMethod));
}

/** #claim=id opens that claim; #section needs help only at the start, when the section was not there yet. */
function followHash(openClaim) {
  const hash = decodeURIComponent(location.hash.slice(1));
  if (hash.startsWith("claim=")) openClaim?.(hash.slice("claim=".length));
  else if (hash) document.getElementById(hash)?.scrollIntoView();
}

function show(title, sections, openClaim) {
  document.getElementById("top").replaceWith(...pageHeader(title, sections));
  document.getElementById("main").replaceChildren(...sections);
  addEventListener("hashchange", () => followHash(openClaim));
  followHash(openClaim);
}

function build() {
  if (study) return show(study.several || study.renders ? study.title : `Study: ${study.title}`, studySections().filter(Boolean));
  const convergence = allSeries.length ? convergenceSection() : null;
  const verdicts = claims.length ? verdictSection((integrand) => convergence?.show(integrand)) : null;
  const sections = [
    verdicts ? overviewSection(verdicts.chooseMethod) : null,
    against ? differencesSection() : null,
    verdicts?.element,
    convergence?.element,
    allSeries.length ? workSection().element : null,
    allStability.length ? stabilitySection() : null,
    mutants.length ? mutantSection() : null,
    results.errata?.length ? errataSection() : null,
    sourcesSection([...claims, ...(results.errata ?? [])].map((one) => one.source)),
  ].filter(Boolean);
  show(claims.length ? "Plumb: verification report" : "Plumb: convergence", sections, verdicts?.open);
}

build();
