// Strands as ribbons that face the eye: two corners a point, two triangles a segment. They are calculated
// here and not on the card. With software rendering (SwiftShader, llvmpipe), an instance or a restarted strip
// takes ten times as long as a list of triangles.

const SHARES = 3; // parts of the strands: if all are too many, one is drawn
const LIGHT = [0.48, -0.6, 0.64]; // light along a hair is invisible
const FLOATS_OF_CORNER = 4, BYTES_OF_CORNER = 16; // x, y, z on the screen, -1 to 1; red, green, blue, opacity
const TAPER = 0.2; // the last part of a strand, over which its width falls to nothing
const FAINTEST = 0.2; // the opacity of strands that are far thinner than a pixel

const MATT = { white: 0, coloured: 0 };

// Highlights of hair, as in the pictures (hair/render/fine/hair_shading.h): white towards the root, and in
// the hair's colour towards the tip. cosine: between the strand and the direction half way from eye to light.
function highlights(cosine) {
  const root = cosine - 0.12, tip = cosine + 0.16, r2 = Math.max(0, 1 - root * root), t2 = Math.max(0, 1 - tip * tip);
  const t4 = t2 * t2, t8 = t4 * t4, r8 = r2 ** 8;
  return { white: 56 * r8 ** 6, coloured: 0.5 * t8 * t4 }; // 56: 0.22 of a byte's 255
}

// Corners 2 i and 2 i + 1 belong to point i. Every third strand comes first.
function ribbonTriangles(starts) {
  const strands = starts.length - 1, triangles = new Uint32Array(6 * Math.max(0, starts[strands] - strands));
  let at = 0, share = 0;
  for (let first = 0; first < SHARES; ++first) {
    for (let s = first; s < strands; s += SHARES)
      for (let i = starts[s]; i + 1 < starts[s + 1]; ++i) {
        const c = 2 * i;
        triangles.set([c, c + 1, c + 2, c + 2, c + 1, c + 3], at);
        at += 6;
      }
    if (first === 0) share = at;
  }
  return { triangles: triangles.subarray(0, at), share };
}

function makeRibbons(starts) {
  const points = starts[starts.length - 1], bytes = new ArrayBuffer(2 * points * BYTES_OF_CORNER);
  const corners = new Float32Array(bytes), paint = new Uint8Array(bytes);
  const x = new Float32Array(points), y = new Float32Array(points), z = new Float32Array(points), half = new Float32Array(points), trueHalf = new Float32Array(points);

  // Points behind the eye take the place of their strand's next point in front of it: their segments vanish.
  const project = (places, camera, wide, thin, width, height) => {
    const m = camera;
    for (let s = 0; s + 1 < starts.length; ++s) {
      let seen = -1;
      for (let i = starts[s]; i < starts[s + 1]; ++i) {
        const a = places[3 * i], b = places[3 * i + 1], c = places[3 * i + 2];
        const w = m[3] * a + m[7] * b + m[11] * c + m[15];
        if (w > 0) {
          x[i] = (width * (m[0] * a + m[4] * b + m[8] * c + m[12])) / w;
          y[i] = (height * (m[1] * a + m[5] * b + m[9] * c + m[13])) / w;
          z[i] = (m[2] * a + m[6] * b + m[10] * c + m[14]) / w;
          trueHalf[i] = (wide / w) * Math.min(1, (starts[s + 1] - 1 - i) / (TAPER * (starts[s + 1] - 1 - starts[s]) || 1));
          half[i] = Math.max(thin, trueHalf[i]);
          if (seen < 0) for (const list of [x, y, z, half, trueHalf]) list.fill(list[i], starts[s], i);
          seen = i;
        } else if (seen >= 0) {
          for (const list of [x, y, z, half, trueHalf]) list[i] = list[seen];
        }
      }
      if (seen < 0) z.fill(2, starts[s], starts[s + 1]); // behind all that is drawn
    }
  };

  return {
    bytes,
    // places: m; camera: a matrix; halves of a ribbon: `wide` over the distance, at least `thin`, pixels;
    // width, height: half the picture's, pixels; colours: four bytes a point; eye: the direction to it, for
    // highlights, or null for none; each: strands that one stands for; together thinner than `thin`, they
    // become transparent. 0: they never do
    lay(places, camera, wide, thin, width, height, colours, eye, each) {
      project(places, camera, wide, thin, width, height);
      const between = eye && normalized(add(LIGHT, eye));
      for (let s = 0; s + 1 < starts.length; ++s) {
        const first = starts[s], last = starts[s + 1] - 1;
        for (let i = first; i <= last; ++i) {
          const a = i > first ? i - 1 : i, b = i < last ? i + 1 : i;
          const right = x[b] - x[a], up = y[b] - y[a], far = Math.sqrt(right * right + up * up);
          const across = far > 1e-6 ? (-up * half[i]) / far : half[i], along = far > 1e-6 ? (right * half[i]) / far : 0;
          const to = 2 * FLOATS_OF_CORNER * i;
          corners[to] = (x[i] - across) / width;
          corners[to + 1] = (y[i] - along) / height;
          corners[to + 2] = corners[to + 6] = z[i];
          corners[to + 4] = (x[i] + across) / width;
          corners[to + 5] = (y[i] + along) / height;
          const dx = places[3 * b] - places[3 * a], dy = places[3 * b + 1] - places[3 * a + 1], dz = places[3 * b + 2] - places[3 * a + 2];
          const lit = LIGHT[0] * dx + LIGHT[1] * dy + LIGHT[2] * dz, square = dx * dx + dy * dy + dz * dz;
          const bright = 0.5 + 0.4 * (square > 0 ? Math.sqrt(Math.max(0, 1 - (lit * lit) / square)) : 1);
          const { white, coloured } = between && square > 0
            ? highlights((between[0] * dx + between[1] * dy + between[2] * dz) / Math.sqrt(square)) : MATT;
          const at = 2 * BYTES_OF_CORNER * i + 12;
          for (let c = 0; c < 3; ++c)
            paint[at + c] = paint[at + BYTES_OF_CORNER + c] = Math.min(255, (bright + coloured) * colours[4 * i + c] + white);
          paint[at + 3] = paint[at + BYTES_OF_CORNER + 3] = each > 0 ? 255 * Math.max(FAINTEST, Math.min(1, (each * trueHalf[i]) / half[i])) : 255;
        }
      }
    },
  };
}
