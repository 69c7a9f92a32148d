// The motion of a run, as hair/view/motion.h writes it.

const STEPS = 65535; // of a coordinate, from the box's low side to its high side

// Positions are whole numbers from 0 to STEPS, three for each point, frame after frame.
function readMotion(text) {
  const motion = JSON.parse(text);
  const bytes = atob(motion.data);
  const data = new Uint8Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) data[i] = bytes.charCodeAt(i);
  const positions = new Uint16Array(data.buffer); // the lowest byte first, as in every browser's memory
  const size = motion.high.map((high, axis) => high - motion.low[axis]);
  const numbers = 3 * motion.points;
  return {
    ...motion,
    size,
    frames: motion.times.length,
    duration: motion.times[motion.times.length - 1],
    frame: (k) => positions.subarray(k * numbers, (k + 1) * numbers),
    // m, of a point at a time between two frames
    point(k, between, index) {
      const now = this.frame(k), next = this.frame(Math.min(k + 1, this.frames - 1));
      return [0, 1, 2].map((axis) => {
        const a = now[3 * index + axis], b = next[3 * index + axis];
        return motion.low[axis] + (size[axis] * (a + (b - a) * between)) / STEPS;
      });
    },
  };
}

// The frame at or before a time, and the part of the way to the next one.
function frameAt(motion, time) {
  const times = motion.times;
  let k = 0;
  for (let step = 1 << 20; step > 0; step >>= 1)
    if (k + step < times.length && times[k + step] <= time) k += step;
  if (k + 1 >= times.length) return { k, between: 0 };
  return { k, between: Math.min(1, (time - times[k]) / (times[k + 1] - times[k])) };
}

// The first point of each strand, and one more at the end.
function strandStarts(motion) {
  const starts = [0];
  for (const size of motion.strands) starts.push(starts[starts.length - 1] + size);
  return starts;
}
