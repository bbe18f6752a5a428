// Numbers and words as a reader wants them.

const THIN = "\u2009",
  MINUS = "\u2212",
  DASH = "–";

/** JSON has no NaN and no infinities: null, "inf" and "-inf" stand for them (docs/json.md). */
function num(value) {
  if (value === null || value === undefined) return NaN;
  if (value === "inf") return Infinity;
  if (value === "-inf") return -Infinity;
  return value;
}

const superscript = (text) => [...text].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("");

/** Three significant digits, 1.23×10⁻⁵ outside [0.001, 100000). */
function readable(value, digits = 3) {
  const x = num(value);
  if (typeof x !== "number") return String(x);
  if (Number.isNaN(x)) return DASH;
  if (!Number.isFinite(x)) return x > 0 ? "∞" : MINUS + "∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e-3 && size < 1e5) return String(Number(x.toPrecision(digits))).replace("-", MINUS);
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  return `${String(Number(mantissa)).replace("-", MINUS)}×10${superscript(String(Number(exponent)))}`;
}

/** 1234567 as 1.23 M */
function count(value) {
  let x = num(value);
  if (!Number.isFinite(x)) return readable(x);
  if (x < 1e4) return String(Math.round(x));
  for (const unit of ["k", "M", "G", "T"]) if ((x /= 1000) < 999.5) return `${Number(x.toPrecision(3))}${THIN}${unit}`;
  return readable(num(value));
}

function seconds(value) {
  const x = num(value);
  if (!Number.isFinite(x)) return DASH;
  if (x >= 0.1 || x === 0) return `${x.toFixed(x < 10 ? 2 : 1)}${THIN}s`;
  return x >= 1e-5 ? `${readable(x * 1e3, 3)}${THIN}ms` : `${readable(x * 1e6, 3)}${THIN}µs`;
}

/** An interval as [low, high]; one-sided and empty of information in words. */
function interval({ low, high }) {
  const [a, b] = [num(low), num(high)];
  if (Number.isFinite(a) && Number.isFinite(b)) return `[${readable(a)}, ${readable(b)}]`;
  if (Number.isFinite(b)) return `at most ${readable(b)}`;
  if (Number.isFinite(a)) return `at least ${readable(a)}`;
  return DASH;
}

const plural = (n, one, many = one + "s") => `${n} ${n === 1 ? one : many}`;

/** The method of a claim is the first part of its id: reweighting/torus/unbiased → reweighting. */
const methodOf = (id) => id.split("/")[0];
