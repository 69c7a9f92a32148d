// LDR-FLIP of two pictures: Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020.

const PIXELS_PER_DEGREE = 67;
const SRGB = Float32Array.from({ length: 256 }, (_, i) => (i <= 10.31475 ? i / 255 / 12.92 : ((i / 255 + 0.055) / 1.055) ** 2.4));
// From linear red, green and blue to XYZ over white's, and back.
const TO_XYZ = [[0.43389539, 0.37624237, 0.18986224], [0.21263682, 0.71518298, 0.0721802], [0.01775242, 0.10946563, 0.87278195]];
const FROM_XYZ = [[3.08034199, -1.53739897, -0.54294302], [-0.9211784, 1.87592998, 0.04524841], [0.05288129, -0.20401121, 1.15112991]];
const times = (m, [a, b, c]) => m.map((row) => row[0] * a + row[1] * b + row[2] * c);

function gaussian(sigma, radius) {
  const kernel = Float32Array.from({ length: 2 * radius + 1 }, (_, i) => Math.exp(-0.5 * ((i - radius) / sigma) ** 2));
  const sum = kernel.reduce((a, b) => a + b);
  return kernel.map((weight) => weight / sum);
}

// The first or second derivative of a Gaussian, its weights of one sign scaled to the sum 1.
function derivative(second, sigma, radius) {
  const kernel = Float32Array.from({ length: 2 * radius + 1 }, (_, i) => {
    const at = (i - radius) / sigma;
    return (second ? at * at - 1 : -at) * Math.exp(-0.5 * at * at);
  });
  const sum = (sign) => kernel.reduce((all, one) => all + Math.max(0, sign * one), 0), positive = sum(1), negative = sum(-1);
  return kernel.map((weight) => weight / (weight > 0 ? positive : negative));
}

// A pixel beyond the border is the one at the border.
function filtered(plane, width, height, along, down) {
  const across = new Float32Array(plane.length), out = new Float32Array(plane.length), side = along.length >> 1, up = down.length >> 1;
  const wide = new Float32Array(width + 2 * side);
  for (let y = 0; y < height; ++y) {
    const row = across.subarray(y * width, (y + 1) * width);
    wide.fill(plane[y * width], 0, side);
    wide.set(plane.subarray(y * width, (y + 1) * width), side);
    wide.fill(plane[(y + 1) * width - 1], side + width);
    for (let i = 0; i < along.length; ++i)
      for (let x = 0; x < width; ++x) row[x] += along[i] * wide[x + i];
  }
  for (let y = 0; y < height; ++y)
    for (let j = 0; j < down.length; ++j) {
      const from = Math.min(Math.max(y + j - up, 0), height - 1) * width, to = y * width;
      for (let x = 0; x < width; ++x) out[to + x] += down[j] * across[from + x];
    }
  return out;
}

const labCurve = (t) => (t > (6 / 29) ** 3 ? Math.cbrt(t) : t / (3 * (6 / 29) ** 2) + 4 / 29);
// L*a*b* in which dark colours have less chroma.
function huntLab(x, y, z) {
  const [a, b, c] = [labCurve(x), labCurve(y), labCurve(z)], lightness = 116 * b - 16;
  return [lightness, 5 * lightness * (a - b), 2 * lightness * (b - c)];
}
const hyab = (a, b) => Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);
const LARGEST = hyab(huntLab(...times(TO_XYZ, [0, 1, 0])), huntLab(...times(TO_XYZ, [0, 0, 1]))) ** 0.7, KNEE = 0.4 * LARGEST;
function redistributed(difference) {
  const value = difference ** 0.7;
  return value < KNEE ? (0.95 / KNEE) * value : Math.min(1, 0.95 + ((value - KNEE) / (LARGEST - KNEE)) * 0.05);
}

// Terms a exp(-b f^2) of the eye's contrast sensitivity, for Y_y, C_x and C_z.
const CONTRAST = [[[1, 0.0047]], [[1, 0.0053]], [[34.1, 0.04], [13.5, 0.025]]];
function seen(plane, terms, width, height) {
  const sigma = (b) => (Math.sqrt(b / 2) / Math.PI) * PIXELS_PER_DEGREE, radius = Math.ceil(3 * sigma(0.04)), out = new Float32Array(plane.length);
  const integral = ([a, b]) => a * Math.sqrt(b / Math.PI), all = terms.reduce((sum, term) => sum + integral(term), 0);
  for (const term of terms) {
    const kernel = gaussian(sigma(term[1]), radius), share = integral(term) / all;
    filtered(plane, width, height, kernel, kernel).forEach((value, i) => { out[i] += share * value; });
  }
  return out;
}

// Returns what an eye takes from one picture: colours, edges and points.
function perceived({ data, width, height }) {
  const count = width * height, planes = [0, 1, 2].map(() => new Float32Array(count));
  for (let i = 0; i < count; ++i) {
    const [x, y, z] = times(TO_XYZ, [SRGB[data[4 * i]], SRGB[data[4 * i + 1]], SRGB[data[4 * i + 2]]]);
    planes[0][i] = 116 * y - 16;
    planes[1][i] = 500 * (x - y);
    planes[2][i] = 200 * (y - z);
  }
  const [bright, red, blue] = planes.map((plane, i) => seen(plane, CONTRAST[i], width, height)), colours = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const y = (bright[i] + 16) / 116;
    // Filtering can leave the colours that a screen shows.
    const shown = times(FROM_XYZ, [y + red[i] / 500, y, y - blue[i] / 200]).map((value) => Math.min(Math.max(value, 0), 1));
    colours.set(huntLab(...times(TO_XYZ, shown)), 3 * i);
  }
  const sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE, radius = Math.ceil(3 * sigma), smooth = gaussian(sigma, radius), light = planes[0].map((value) => (value + 16) / 116);
  const features = [false, true].map((second) => {
    const kernel = derivative(second, sigma, radius), other = filtered(light, width, height, smooth, kernel);
    return filtered(light, width, height, kernel, smooth).map((value, i) => Math.hypot(value, other[i]));
  });
  return { colours, features };
}

// ImageData of one size -> a number from 0 to 1 a pixel.
function flip(one, other) {
  const a = perceived(one), b = perceived(other);
  return Float32Array.from({ length: one.width * one.height }, (_, i) => {
    const colour = redistributed(hyab(a.colours.subarray(3 * i, 3 * i + 3), b.colours.subarray(3 * i, 3 * i + 3)));
    const feature = Math.max(...[0, 1].map((kind) => Math.abs(a.features[kind][i] - b.features[kind][i])));
    return colour ** (1 - Math.min(1, Math.sqrt(feature / Math.SQRT2)));
  });
}
