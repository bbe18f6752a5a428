// What the program wrote into the page: the verdict, and both pictures as floats.

const found = JSON.parse(document.getElementById("data").textContent);

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

const floatsOf = (base64) => new Float32Array(bytesOf(base64).buffer);

/** Upper halves of floats, as floats. */
function upperHalvesOf(base64) {
  const halves = new Uint16Array(bytesOf(base64).buffer);
  const floats = new Float32Array(halves.length);
  const bits = new Uint32Array(floats.buffer);
  for (let i = 0; i < halves.length; ++i) bits[i] = halves[i] << 16;
  return floats;
}

const { width, height } = found;
const channels = found.pixels.channels;
const pictures = { a: floatsOf(found.pixels.a), b: floatsOf(found.pixels.b) };
const deviation = upperHalvesOf(found.pixels.deviation);
delete found.pixels;

/** a, b, a − b, its standard deviation and their ratio z, of one channel of a pixel. */
function numbersAt(x, y, channel) {
  const i = (y * width + x) * channels.length + channel;
  const [a, b, sd] = [pictures.a[i], pictures.b[i], deviation[i]];
  const difference = a - b;
  return { a, b, difference, sd, z: difference === 0 ? 0 : difference / sd };
}

/** Whose name a side goes by. */
const nameOf = (side) => {
  const { files } = found[side];
  const short = files[0].split("/").pop();
  return files.length === 1 ? short : `${short} and ${files.length - 1} more`;
};

const tilesAt = (x, y) =>
  found.tiles.filter((t) => x >= t.x && x < t.x + t.width && y >= t.y && y < t.y + t.height);
