// A run in words: for readers who can't see it, and for readers who ask for the picture's meaning.

// Three digits.
function few(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return Number(value).toExponential(2).replace("e+", "e");
  return String(Number(Number(value).toPrecision(3)));
}

function counted(count, word) {
  return count === 1 ? `1 ${word}` : `${count.toLocaleString("en")} ${word}s`;
}

function wordsOfSeries(series) {
  const finite = series.values.filter((value) => value !== null);
  if (finite.length === 0) return `${series.name}: no numbers`;
  const unit = series.unit ? " " + series.unit : "";
  return `${series.name}: ${few(finite[0])}${unit} at first, ${few(finite[finite.length - 1])}${unit} in the end, between ${few(Math.min(...finite))} and ${few(Math.max(...finite))}`;
}

function wordsOfEnding(motion) {
  if (motion.blow_up) return `It broke after ${few(motion.duration)} s: ${motion.blow_up.text}. The strand is red at the end.`;
  if (motion.ended === "interrupted") return `It was interrupted after ${few(motion.duration)} s.`;
  return `It ended as planned, after ${few(motion.duration)} s.`;
}

function wordsOfRun(motion) {
  const strands = motion.strands_in_all;
  const all = [`${counted(strands, "strand")}, ${counted(motion.frames, "frame")}. ${wordsOfEnding(motion)}`];
  if (motion.strands.length < strands)
    all.push(`${counted(motion.strands.length, "strand")} of them are shown.${motion.series.length > 0 ? "" : " Only they were computed, so there are no energies of all."}`);
  for (const series of motion.series) all.push(wordsOfSeries(series) + ".");
  return all;
}

function wordsOfMoment(motion, k) {
  const values = motion.series.filter((series) => series.values[k] !== null)
    .map((series) => `${series.name} ${few(series.values[k])}${series.unit ? " " + series.unit : ""}`);
  return `Frame ${k} of ${motion.frames - 1}, ${few(motion.times[k])} s${values.length > 0 ? ": " : ""}${values.join(", ")}`;
}
