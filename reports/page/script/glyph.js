// The interval of a deviation against what could still hide, small enough for a line of a list.

const GLYPH = { width: 132, height: 16, reach: 2 }; // reach: the ends of the scale, in units of the resolution

function svgElement(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A band of ± resolution with the interval drawn over it; what leaves the scale ends in an arrow. Null when the
    verdict has no such numbers. */
function deviationGlyph(verdict) {
  const [low, high, resolution] = [num(verdict.deviation.low), num(verdict.deviation.high), num(verdict.resolution)];
  if (![low, high, resolution].every(Number.isFinite) || !(resolution > 0)) return null;
  const { width, height, reach } = GLYPH,
    middle = height / 2,
    margin = 6;
  const clamp = (x) => Math.min(Math.max(x / resolution, -reach), reach);
  const x = (value) => width / 2 + (clamp(value) / reach) * (width / 2 - margin);
  const arrow = (at, direction) =>
    svgElement("path", { d: `M${at},${middle}l${-5 * direction},-5v10z`, class: "interval-arrow" });
  const text = `deviation ${interval(verdict.deviation)}, band ±${readable(resolution)}`;
  const left = x(low),
    right = Math.max(x(high), x(low) + 2);
  return svgElement(
    "svg",
    {
      class: `glyph ${verdict.outcome}`,
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
      role: "img",
      "aria-label": text,
    },
    svgElement("title", {}, text),
    svgElement("rect", {
      x: x(-resolution),
      y: 1,
      width: x(resolution) - x(-resolution),
      height: height - 2,
      class: "band",
    }),
    svgElement("line", { x1: width / 2, x2: width / 2, y1: 1, y2: height - 1, class: "zero" }),
    svgElement("rect", { x: left, y: middle - 2, width: right - left, height: 4, class: "interval" }),
    ...(low < -reach * resolution ? [arrow(margin - 4, -1)] : []),
    ...(high > reach * resolution ? [arrow(width - margin + 4, 1)] : []),
  );
}
