// What can be seen: each view is a function from a pixel to colour bytes, drawn once into an image of the picture's size.

/** [IEC 61966-2-1] as a table over linear values from 0 to 1. */
const srgb = (() => {
  const table = new Uint8ClampedArray(4097);
  for (let i = 0; i < table.length; ++i) {
    const v = i / 4096;
    table[i] = Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  }
  return (linear) => table[Math.round(4096 * Math.min(1, Math.max(0, linear)))];
})();

const NOT_A_NUMBER = [255, 0, 255];

/** Blue below 0, red above, grey at 0; clipped at ±1. */
function diverging(value) {
  if (Number.isNaN(value)) return NOT_A_NUMBER;
  const t = Math.min(1, Math.abs(value));
  const end = value < 0 ? [20, 90, 200] : [200, 30, 20];
  return end.map((c) => Math.round(235 + t * (c - 235)));
}

const mean = (numbers) => numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
const allChannels = (x, y) => channels.map((_, c) => numbersAt(x, y, c));
const strongest = (numbers) => numbers.reduce((worst, x) => (Math.abs(x) > Math.abs(worst) ? x : worst), 0);

/** The picture's mean, the scale of the difference. */
const brightness = mean(found.channels.map((c) => Math.abs(num(c.mean.b)))) || 1;

function radiance(side) {
  return (x, y, { exposure }) => {
    const i = (y * width + x) * channels.length;
    const gain = 2 ** exposure;
    const of = (c) => pictures[side][i + (channels.length === 3 ? c : 0)];
    if (Number.isNaN(of(0))) return NOT_A_NUMBER;
    return [srgb(gain * of(0)), srgb(gain * of(1)), srgb(gain * of(2))];
  };
}

/** z of tiles, as an array over pixels of the channel that differs most. */
const tileScores = (() => {
  let scores = null;
  return () => {
    if (scores) return scores;
    scores = new Float32Array(width * height);
    for (const t of found.tiles)
      for (let y = t.y; y < t.y + t.height; ++y)
        for (let x = t.x; x < t.x + t.width; ++x) {
          const i = y * width + x;
          if (Math.abs(num(t.z)) > Math.abs(scores[i])) scores[i] = num(t.z);
        }
    return scores;
  };
})();

const Z_RANGE = 5;

const VIEWS = {
  a: { label: () => `a: ${nameOf("a")}`, colour: radiance("a") },
  b: { label: () => `b: ${nameOf("b")}`, colour: radiance("b") },
  difference: {
    label: (state) => `a − b, ±${readable(brightness / 2 ** state.exposure)}`,
    legend: true,
    colour: (x, y, { exposure }) =>
      diverging((mean(allChannels(x, y).map((n) => n.difference)) / brightness) * 2 ** exposure),
  },
  z: {
    label: () => `z of pixels, ±${Z_RANGE}`,
    legend: true,
    colour: (x, y) => diverging(strongest(allChannels(x, y).map((n) => n.z)) / Z_RANGE),
  },
  tiles: {
    label: () => `z of tile means, ±${Z_RANGE}`,
    legend: true,
    colour: (x, y) => diverging(tileScores()[y * width + x] / Z_RANGE),
  },
};

/** An image of a view, kept until the exposure is another. */
const imageOf = (() => {
  const kept = new Map();
  return (name, state) => {
    const old = kept.get(name);
    if (old && old.exposure === state.exposure) return old.image;
    const image = h("canvas", { width, height });
    const context = image.getContext("2d");
    const pixels = context.createImageData(width, height);
    for (let y = 0, i = 0; y < height; ++y)
      for (let x = 0; x < width; ++x, i += 4) {
        const [r, g, b] = VIEWS[name].colour(x, y, state);
        pixels.data[i] = r;
        pixels.data[i + 1] = g;
        pixels.data[i + 2] = b;
        pixels.data[i + 3] = 255;
      }
    context.putImageData(pixels, 0, 0);
    kept.set(name, { exposure: state.exposure, image });
    return image;
  };
})();
