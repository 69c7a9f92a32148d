// Controls of both pages, of a finished run and of a live one, and the text next to the picture.

const $ = (id) => document.getElementById(id);
const told = (id, text) => { if ($(id).textContent !== text) $(id).textContent = text; };

const WAYS = [
  ["run", "by run"], ["own", "as hair"], ["stretch", "by stretch: blue shorter, red longer than at first, full at 10 %"],
  ["strand", "by strand"], ["distance", "by distance from the other run, full at a tenth of the scene"],
];

function offerColours(runs, again) {
  const same = runs.length > 1 && runs[0].points === runs[1].points;
  for (const [value, text] of WAYS)
    if ((value !== "run" || runs.length > 1) && (value !== "distance" || same)) $("colour").add(new Option(text, value));
  $("colour").addEventListener("change", again);
}

function tintOf(runs, run, k) {
  const way = $("colour").value, motion = runs[run], other = runs[1 - run] || null;
  // The tint's name contains the frame if the colours depend on it.
  const moves = way === "stretch" || way === "distance" || (motion.blow_up && k >= motion.frames - 2);
  const rods = way === "run" && motion.strands.length === 0 ? RUNS[run] : null; // toys have no strands
  return { name: `${way} ${moves ? k : ""}`, rods, write: (bytes) => colourPoints(bytes, motion, k, way, run, other) };
}

// A list of sentences about each run; with several each has its name.
function writeWords(runs) {
  $("words").replaceChildren();
  for (const run of runs) {
    const heading = document.createElement("h3"), list = document.createElement("ul");
    heading.textContent = run.name;
    for (const sentence of wordsOfRun(run)) list.append(Object.assign(document.createElement("li"), { textContent: sentence }));
    $("words").append(...(runs.length > 1 ? [heading, list] : [list]));
  }
}

// keys: functions for " ", "," and "."; other keys are the camera's.
function followKeys(keys, orbit) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || ["SELECT", "INPUT"].includes(event.target.tagName)) return;
    if (event.key === " " && event.target.tagName === "BUTTON") return;
    if (keys[event.key]) keys[event.key]();
    else if (!turnByKey(event.key, orbit)) return;
    event.preventDefault();
  });
}
