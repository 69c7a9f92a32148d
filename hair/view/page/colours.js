// A point of a strand has a colour: its own, its strand's, one for the stretch of its segment, or one for its
// distance from the other run's point.

const RUNS = [[0.0, 0.45, 0.7], [0.84, 0.37, 0.0]]; // one for each run, also for colour-blind readers
const BROKEN = [0.85, 0.1, 0.1];

// From blue (shorter) through grey to red (longer); s from -1 to 1.
function divergent(s) {
  const t = Math.max(-1, Math.min(1, s)), far = Math.abs(t);
  const end = t < 0 ? [0.13, 0.4, 0.68] : [0.8, 0.12, 0.12];
  return end.map((c) => 0.62 * (1 - far) + c * far);
}

// From grey to yellow to red; s from 0 to 1.
function sequential(s) {
  const t = Math.max(0, Math.min(1, s));
  return t < 0.5 ? [0.6 + 0.6 * t, 0.6 + 0.3 * t, 0.6 - t] : [0.9, 0.75 - 1.2 * (t - 0.5), 0.1];
}

// Different colours for neighbours.
function ofStrand(index) {
  const hue = (index * 0.618034) % 1;
  return [0, 1 / 3, 2 / 3].map((shift) => {
    const x = Math.abs(((hue + shift) % 1) * 6 - 3) - 1;
    return 0.25 + 0.6 * Math.max(0, Math.min(1, x));
  });
}

// m, between point i of one frame and point j of another
function distance(scale, frame, i, other, j) {
  let sum = 0;
  for (let axis = 0; axis < 3; ++axis) {
    const d = scale[axis] * (frame[3 * i + axis] - other[3 * j + axis]);
    sum += d * d;
  }
  return Math.sqrt(sum);
}

// The stretch of a segment relative to the first frame, and the distance of two runs relative to the scene's
// size, that get the last colour.
const STRETCH_SHOWN = 0.1, DISTANCE_SHOWN = 0.1;

// Four bytes a point, the last one unused. `other`: the other run's motion, or null.
function colourPoints(bytes, motion, k, way, run, other) {
  const { starts, scale } = motion, now = motion.frame(k), first = motion.frame(0);
  const broken = motion.blow_up && k >= motion.frames - 2 ? motion.blow_up.strand : -1;
  const apart = way === "distance" && other ? distancesApart(motion, other, k) : null;
  const scene = length(motion.size);
  for (let s = 0; s + 1 < starts.length; ++s) {
    const strand = s === broken ? BROKEN : way === "strand" ? ofStrand(s) : way === "run" ? RUNS[run] : null;
    for (let i = starts[s]; i < starts[s + 1]; ++i) {
      let colour = strand;
      if (!colour && way === "stretch") {
        const a = i + 1 === starts[s + 1] ? i - 1 : i, rest = a < starts[s] ? 0 : distance(scale, first, a, first, a + 1);
        colour = divergent(rest > 0 ? (distance(scale, now, a, now, a + 1) / rest - 1) / STRETCH_SHOWN : 0);
      } else if (!colour && apart) {
        colour = sequential(apart[i] / (DISTANCE_SHOWN * scene));
      } else if (!colour) {
        const tone = 0.8 + 0.4 * ((s * 0.618034) % 1); // neighbours differ
        const along = (i - starts[s]) / Math.max(1, starts[s + 1] - starts[s] - 1);
        colour = motion.root.map((c, axis) => tone * (c + (motion.tip[axis] - c) * along));
      }
      for (let axis = 0; axis < 3; ++axis) bytes[4 * i + axis] = 255 * colour[axis];
    }
  }
}

// m, of each point in frame k, or in the other run's last one
function distancesApart(motion, other, k) {
  const mine = Float32Array.from(motion.places(k, 0)), theirs = other.places(Math.min(k, other.frames - 1), 0);
  const all = new Float32Array(motion.points);
  for (let i = 0; i < all.length; ++i) all[i] = distance([1, 1, 1], mine, i, theirs, i);
  return all;
}

// tint: a name of colours, and `write`, which writes them.
function recolour(held, tint) {
  if (held.coloured === tint.name) return;
  tint.write(held.colourBytes);
  held.coloured = tint.name;
}
