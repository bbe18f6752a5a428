// Citations as links to the bibliography (docs/sources.md), of which the page ends with the entries that it cites.

/** From what a source is cited as to its entry. */
const bibliography = new Map(
  document
    .getElementById("bibliography")
    .content.textContent.split("\n")
    .filter((line) => line.startsWith("| "))
    .map((line) => line.slice(2, -2).split(" | ")),
);

/** The source that a part of a citation, "Veach 1997, theorem 9.2", begins with. */
const sourceOf = (part) => [...bibliography.keys()].find((key) => /^$|^[^\w]/.test(part.trim().slice(key.length)) && part.trim().startsWith(key));

const CITATION = /\[([^[\]]+)\]/;
const citedParts = (text) => text.split(CITATION).flatMap((part, i) => (i % 2 ? part.split(";") : []));

/** A text whose citations are links. */
function cited(text) {
  const link = (part) => {
    const key = sourceOf(part);
    return key ? h("a", { href: `#source-${slug(key)}`, title: bibliography.get(key).replaceAll("*", "") }, part.trim()) : part.trim();
  };
  return text
    .split(CITATION)
    .map((part, i) => (i % 2 ? ["[", part.split(";").map((one, j) => [j ? "; " : "", link(one)]), "]"] : part));
}

/** "*Title*, place": every second piece between asterisks is set in italics. */
const entryOf = (key) => bibliography.get(key).split("*").map((text, i) => (i % 2 ? h("i", {}, text) : text));

/** The entry of a source that is cited whole, as a heading is: "[Owen 1997]". */
function entryOfWhole(text) {
  const key = sourceOf(text.replace(/^\[|\]$/g, ""));
  return key ? h("p", { class: "note" }, entryOf(key)) : null;
}

/** The entries that these texts cite, in the order of the bibliography; null where there is none. */
function sourcesSection(texts) {
  const keys = new Set(texts.flatMap(citedParts).map(sourceOf));
  const list = [...bibliography.keys()].filter((key) => keys.has(key));
  if (list.length === 0) return null;
  return section(
    "sources",
    "Sources",
    null,
    h("dl", { class: "texts sources" }, list.map((key) => h("div", { id: `source-${slug(key)}` }, h("dt", {}, key), h("dd", {}, entryOf(key))))),
  );
}
