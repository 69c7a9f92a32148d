// A point of a strand has a colour: its own, its strand's, by how far its segment is stretched, or by how far it is from the other run's.

const RUNS = [[0.0, 0.45, 0.7], [0.84, 0.37, 0.0]]; // of two runs, for readers who are colour-blind, too
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

// Colours that neighbours do not share.
function ofStrand(index) {
  const hue = (index * 0.618034) % 1;
  return [0, 1 / 3, 2 / 3].map((shift) => {
    const x = Math.abs(((hue + shift) % 1) * 6 - 3) - 1;
    return 0.25 + 0.6 * Math.max(0, Math.min(1, x));
  });
}

function distance(motion, frame, i, j) {
  let sum = 0;
  for (let axis = 0; axis < 3; ++axis) {
    const d = (motion.size[axis] * (frame[3 * i + axis] - frame[3 * j + axis])) / STEPS;
    sum += d * d;
  }
  return Math.sqrt(sum);
}

// The largest part by which a segment is longer or shorter than in the first frame.
const STRETCH_SHOWN = 0.1;

// Strands that stay when all are too many: the last share.
const SHARES = 3;

// Four bytes a point: its colour, and its strand's share, in steps of 255 / SHARES; 0 at a tip, where no segment begins. `other`: the other run's
// motion, or null.
function colourPoints(bytes, motion, k, way, run, other) {
  const starts = strandStarts(motion), now = motion.frame(k), first = motion.frame(0);
  const broken = motion.blow_up && k >= motion.frames - 2 ? motion.blow_up.strand : -1;
  const scene = length(motion.size);
  for (let s = 0; s + 1 < starts.length; ++s) {
    const strand = way === "strand" ? ofStrand(s) : way === "run" ? RUNS[run] : null;
    for (let i = starts[s]; i < starts[s + 1]; ++i) {
      const last = i + 1 === starts[s + 1], along = (i - starts[s]) / Math.max(1, starts[s + 1] - starts[s] - 1);
      let colour = strand;
      if (s === broken) {
        colour = BROKEN;
      } else if (way === "stretch") {
        const a = last ? i - 1 : i, rest = a < starts[s] ? 0 : distance(motion, first, a, a + 1);
        colour = divergent(rest > 0 ? (distance(motion, now, a, a + 1) / rest - 1) / STRETCH_SHOWN : 0);
      } else if (way === "distance" && other) {
        const theirs = other.point(Math.min(k, other.frames - 1), 0, i), mine = motion.point(k, 0, i);
        colour = sequential(length(subtract(mine, theirs)) / (0.1 * scene));
      }
      colour = colour || motion.root.map((c, axis) => c + (motion.tip[axis] - c) * along);
      for (let axis = 0; axis < 3; ++axis) bytes[4 * i + axis] = Math.round(255 * colour[axis]);
      bytes[4 * i + 3] = last ? 0 : (255 / SHARES) * (1 + (s % SHARES));
    }
  }
}
