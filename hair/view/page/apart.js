// How far two runs of one scene are apart.

const NOTICED = [0.1, 1, 10]; // per cent

function longestStrand(motion) {
  const first = motion.frame(0), { starts } = motion;
  let longest = 0;
  for (let s = 0; s + 1 < starts.length; ++s) {
    let along = 0;
    for (let i = starts[s] + 1; i < starts[s + 1]; ++i) along += distance(motion.scale, first, i - 1, first, i);
    longest = Math.max(longest, along);
  }
  return longest;
}

// A value for each frame that both have: the largest distance of a point from the other run's. Null: they
// have other points.
function seriesApart(one, other) {
  if (one.points !== other.points || String(one.strands) !== String(other.strands)) return null;
  const strand = longestStrand(one), whole = (strand || length(one.size)) / 100;
  const values = one.times.map((_, k) => (k < other.frames ? distancesApart(one, other, k).reduce((most, far) => Math.max(most, far), 0) / whole : null));
  return { name: "apart", unit: strand ? "% of the longest strand" : "% of the scene", values };
}

// Lets a reader go to the first frame that differs by more than a share. seek(time). Returns what does so.
function offerDifferences(apart, times, seek) {
  const label = document.createElement("label"), select = document.createElement("select"), none = "they never do";
  select.add(new Option("...", ""));
  for (const limit of NOTICED) {
    const k = apart.values.findIndex((value) => value > limit);
    select.add(new Option(`${limit} %: ${k < 0 ? none : `${few(times[k])} s`}`, k < 0 ? "" : times[k]));
  }
  const go = (time) => { if (time !== "") seek(Number(time)); };
  select.addEventListener("change", () => go(select.value));
  label.append("differ by more than ", select);
  $("runs").append(label, " ");
  return (limit) => { select.selectedIndex = 1 + NOTICED.indexOf(limit); go(select.value); };
}
