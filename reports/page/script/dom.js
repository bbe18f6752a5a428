// Elements, controls, downloads.

/** h("td", {class: "number"}, "12"): on… are listeners, everything else attributes; false and null are left out. */
function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return element;
}

const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");

function section(id, title, lead, ...children) {
  return h(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    h("h2", { id: `${id}-title` }, title),
    lead ? h("p", { class: "lead" }, lead) : null,
    ...children,
  );
}

/** A labelled <select>; `choices` are [value, text] pairs. */
function choice(label, choices, onchange) {
  const select = h(
    "select",
    { onchange: () => onchange(select.value) },
    choices.map(([value, text]) => h("option", { value }, text)),
  );
  return { element: h("label", { class: "control" }, h("span", {}, label), select), select };
}

function checkbox(label, checked, onchange) {
  const input = h("input", { type: "checkbox", checked, onchange: () => onchange(input.checked) });
  return h("label", { class: "check" }, input, label);
}

const button = (label, onclick, title) => h("button", { type: "button", onclick, title }, label);

/** A table; cells are text or elements, `numeric` the indices of columns aligned to the right. */
function dataTable(caption, headings, rows, numeric = []) {
  const kind = (i) => (numeric.includes(i) ? "number" : null);
  return h(
    "div",
    { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    h(
      "table",
      {},
      h("caption", {}, caption),
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          headings.map((text, i) => h("th", { scope: "col", class: kind(i) }, text)),
        ),
      ),
      h(
        "tbody",
        {},
        rows.map((row) =>
          h(
            "tr",
            {},
            row.map((cell, i) => h("td", { class: kind(i), "data-label": headings[i] }, cell)),
          ),
        ),
      ),
    ),
  );
}

function download(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  h("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** RFC 4180; numbers in full precision. */
function toCsv(headings, rows) {
  const cell = (value) => {
    const text = value === null || value === undefined ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [headings, ...rows].map((row) => row.map(cell).join(",")).join("\r\n") + "\r\n";
}

/** The plot as a file of its own: CSS variables resolved, the page's paper behind it. */
function toSvg(svg) {
  const style = getComputedStyle(svg);
  const copy = svg.cloneNode(true);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("style", `background:${style.getPropertyValue("--paper")};color:${style.color}`);
  const text = new XMLSerializer().serializeToString(copy);
  return text.replace(/var\((--[\w-]+)\)/g, (_, name) => style.getPropertyValue(name).trim() || "currentColor");
}
