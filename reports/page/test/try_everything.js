// Run inside the page by html_test.cpp: tries every control, and tells the page around it what it saw.
const change = (control, type) => control.dispatchEvent(new Event(type));

function look() {
  saw.sections = all("section")
    .map((e) => e.id)
    .join(" ");
  saw.plots = all(".plot svg").length;
  saw.width = document.documentElement.clientWidth;
  saw.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  saw.clamped = all(".note").some((e) => e.textContent.includes("2 confidence bounds at or below 0"));
  saw.statements = all(".states")
    .map((e) => e.textContent)
    .join(" ");
  saw.bands = all(".headlines .band").filter((e) => Number(e.getAttribute("width")) > 2).length;
  saw.deadLinks = all('a[href^="#"]').filter(
    (e) => !e.hash.startsWith("#claim=") && !document.getElementById(decodeURIComponent(e.hash.slice(1))),
  ).length;
  saw.escaped = all(".statement").some((e) => e.textContent.includes("<script>alert(1)"));
}

async function downloadAll() {
  const blobs = [];
  URL.createObjectURL = (blob) => {
    blobs.push(blob);
    return "#";
  };
  all(".buttons button")
    .filter((button) => /CSV|SVG/.test(button.textContent))
    .forEach((button) => button.click());
  const [csv, svg] = await Promise.all(blobs.map((blob) => blob.text()));
  if (!svg) return;
  saw.csvRows = csv.trim().split("\r\n").length;
  const root = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  saw.svg = `${root.tagName}, ${root.querySelectorAll("path").length > 5 ? "drawn" : "empty"}, ${svg.includes("var(") ? "needs the page" : "alone"}`;
}

async function chooseEverything() {
  for (const select of all("select"))
    for (const option of [...select.options].reverse()) {
      select.value = option.value;
      change(select, "change");
      await settled();
    }
  all("details").forEach((details) => {
    details.open = true;
  });
  all("input[type=checkbox]").forEach((box) => {
    box.click();
    box.click();
  });
}

async function find() {
  const search = document.querySelector("input[type=search]");
  if (!search) return;
  search.value = "torus UNBIASED";
  change(search, "input");
  saw.found = all("details.claim").length;
  location.hash = "#claim=mis/balance/corners";
  await settled();
  saw.opened = document.activeElement.textContent;
}

(async () => {
  await settled();
  look();
  await downloadAll();
  await chooseEverything();
  await find();
  saw.wrongNumbers = all("section, svg").some((e) => /NaN|undefined|\[object/.test(e.textContent));
  saw.plotsAfter = all(".plot svg").length;
  parent.postMessage(saw, "*");
})();
