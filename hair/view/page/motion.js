// The motion of a run, in the format of hair/view/motion.h.

const STEPS = 65535; // steps of a coordinate, from the box's low side to its high side

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

// A point's coordinate is low + scale * its number in its frame. frameOf(k): three numbers a point.
function makeMotion(told, low, scale, frameOf) {
  const starts = [0]; // the first point of each strand, and one more at the end
  for (const size of told.strands) starts.push(starts[starts.length - 1] + size);
  const places = new Float32Array(3 * told.points);
  let filled = [-1, 0];
  return {
    ...told,
    starts,
    size: told.high.map((high, axis) => high - told.low[axis]), // m, of all that happens
    scale,
    get frames() { return this.times.length; },
    get duration() { return this.times[this.times.length - 1]; },
    frame: frameOf,
    forget() { filled = [-1, 0]; }, // places of frames that are others now
    // m, of all points at a time between two frames. The next call writes over it.
    places(k, between) {
      if (filled[0] === k && filled[1] === between) return places;
      filled = [k, between];
      const now = frameOf(k), next = frameOf(Math.min(k + 1, this.frames - 1));
      for (let axis = 0; axis < 3; ++axis) {
        const from = low[axis], step = scale[axis];
        for (let i = axis; i < places.length; i += 3) places[i] = from + step * (now[i] + (next[i] - now[i]) * between);
      }
      return places;
    },
  };
}

function readMotion(text) {
  const told = JSON.parse(text);
  // The lowest byte comes first, as in every browser's memory.
  const numbers = new Uint16Array(bytesOfBase64(told.data).buffer), each = 3 * told.points;
  delete told.data;
  const scale = told.high.map((high, axis) => (high - told.low[axis]) / STEPS);
  return makeMotion(told, told.low, scale, (k) => numbers.subarray(k * each, (k + 1) * each));
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
