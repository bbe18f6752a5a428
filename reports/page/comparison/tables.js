// The verdict in words and numbers.

const SIGNS = { holds: "✓", undecided: "?", refuted: "✕" };
const badgeOf = (outcome, text) =>
  h("span", { class: `badge ${outcome}` }, h("span", { "aria-hidden": "true" }, SIGNS[outcome]), ` ${text ?? outcome}`);
const OUTCOME_OF = { same: "holds", differs: "refuted" };
const stateBadge = (state) => badgeOf(OUTCOME_OF[state] ?? "undecided", state);
const percent = (part, whole) => (num(whole) === 0 ? DASH : `${readable((100 * num(part)) / Math.abs(num(whole)))} %`);

/** A reason of several clauses as a line that says what is so, and a list of what it rests on. */
function reasonParts(reason) {
  const [first, ...rest] = reason.split(/;\s+|\.\s+(?=[A-Z])/);
  return [h("p", { class: "lead" }, first), rest.length ? h("ul", { class: "reasons" }, rest.map((one) => h("li", {}, one))) : null];
}

function verdictSection() {
  const fact = (name, value) => h("div", {}, h("dt", {}, name), h("dd", {}, value));
  const s = found.settings;
  const tested = found.error_known
    ? [
        fact("tiles", `${plural(found.tiles.length / channels.length, "tile")}, edge ${s.tile}`),
        fact("α", readable(s.alpha)),
        fact("δ", `${readable(100 * s.delta)} % of the mean, ${readable(100 * s.tile_delta)} % of a tile`),
        fact("correlated neighbours", found.correlation.reach ? `to ${found.correlation.reach} pixels: variance × ${readable(found.correlation.inflation)}` : "none found"),
      ]
    : [];
  return h(
    "section",
    { id: "verdict", "aria-label": "Verdict" },
    h("div", { class: "verdict" }, h("h1", {}, "Are these estimates of the same picture?"), badgeOf(found.outcome)),
    reasonParts(found.reason),
    h(
      "dl",
      { class: "facts" },
      fact("a", found.a.files.join(", ")),
      fact("b", found.b.files.join(", ")),
      fact("size", `${width} × ${height}`),
      tested,
      fact("not finite", `${found.a.bad_pixels} and ${found.b.bad_pixels} pixels`),
    ),
  );
}

/** Means alone, where the error of a picture is unknown. */
const meanSection = () =>
  section(
    "channels",
    "Channels",
    "Each channel's mean over the picture.",
    dataTable(
      "Channels",
      ["channel", "mean a", "mean b", "a − b"],
      found.channels.map((c) => [c.channel, readable(c.mean.a, 5), readable(c.mean.b, 5), percent(c.mean.difference, c.mean.b)]),
      [1, 2, 3],
    ),
  );

function channelSection() {
  return section(
    "channels",
    "Channels",
    "Each channel's mean over the picture, and all its tiles together: a chi-square of their normal scores, which errors that are too large or too small betray.",
    dataTable(
      "Channels",
      ["", "channel", "mean a", "mean b", "a − b", "interval", "z", "chi-square / degrees", "p above", "p below"],
      found.channels.map((c) => [
        stateBadge(c.state),
        c.channel,
        readable(c.mean.a, 5),
        readable(c.mean.b, 5),
        percent(c.mean.difference, c.mean.b),
        interval(c.mean),
        readable(c.mean.z),
        `${readable(c.chi_square, 4)} / ${c.degrees}`,
        readable(c.upper_p),
        readable(c.lower_p),
      ]),
      [2, 3, 4, 5, 6, 7, 8, 9],
    ),
    h("p", { class: "note" }, `The squared t of a pixel, bounded, is ${readable(found.alike.ratio, 4)} in the mean, where independent errors have 1 or more (p of so small a value: ${readable(found.alike.p_value)}). Squared differences are ${readable(found.unlike.ratio, 4)} of what the variances say (p of so large a value: ${readable(found.unlike.p_value)}).`),
  );
}

function tileSection(zoomTo) {
  const most = 300;
  const order = [...found.differing, ...found.undecided];
  const rows = order.slice(0, most).map((index) => {
    const t = found.tiles[index];
    return [
      stateBadge(t.state),
      button(`(${t.x}, ${t.y})`, () => zoomTo(t), "show it"),
      t.channel,
      readable(t.a),
      readable(t.b),
      percent(t.difference, t.b),
      readable(t.z),
      readable(t.p_value),
      readable(t.skewness),
    ];
  });
  return section(
    "tiles",
    "Tiles",
    `${found.differing.length} of ${found.tiles.length} tile means differ, ${found.undecided.length} are not decided.${order.length > most ? ` The worst ${most} are listed.` : ""}`,
    rows.length
      ? h("div", { class: "tile-list" }, dataTable("Tiles, worst first", ["", "at", "channel", "mean a", "mean b", "a − b", "z", "p", "skewness at most"], rows, [3, 4, 5, 6, 7, 8]))
      : null,
  );
}

const errorSection = () =>
  section(
    "errors",
    "Errors",
    found.error_known
      ? "Of a against b over all pixels, the variance of b subtracted; intervals are 95 % ones over pixels. FLIP is of both images as they are, noise and all."
      : "Of a against b over all pixels: of both images as they are, noise and all.",
    dataTable(
      "Errors",
      ["measure", "value", "interval"],
      found.errors.map((e) => [e.name, readable(e.value, 4), interval(e)]),
      [1, 2],
    ),
  );
