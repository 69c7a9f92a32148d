// The page: a picture that plays, what was measured beneath it, and the run in words.

const SLOW = 1 / 25; // s; a picture that takes longer shows fewer strands while the view moves

const $ = (id) => document.getElementById(id);
const told = (id, text) => { if ($(id).textContent !== text) $(id).textContent = text; };

function readRuns() {
  return ["motion", "other"].filter($).map((id) => ({ ...readMotion($(id).textContent), name: $(id).dataset.name }));
}

function chooseDrawing(canvas) {
  try {
    return makeDrawing(canvas);
  } catch (error) {
    told("note", "This browser shows no WebGL2: strands are drawn as plain lines.");
    return makeFlatDrawing(canvas);
  }
}

// A canvas that had a context of one kind gives none of another: a new one takes its place.
function replaceCanvas(canvas) {
  const fresh = canvas.cloneNode(false);
  canvas.replaceWith(fresh);
  return fresh;
}

function show() {
  const runs = readRuns(), duration = Math.max(...runs.map((run) => run.duration));
  const clock = makeClock(duration), orbit = makeOrbit(runs[0].camera);
  let canvas = $("picture"), drawing = chooseDrawing(canvas), held = runs.map(drawing.upload);
  const shown = runs.map(() => true);
  let seconds = 0, dirty = true; // seconds: from a picture of all strands to the next one

  const again = () => { dirty = true; };
  const seek = (time) => { clock.seek(time); again(); };
  const lists = [...new Set(runs.flatMap((run) => run.series.map((one) => one.name)))];
  const plots = lists.map((name) => makePlot(name, runs, duration, seek));
  $("plots").append(...plots.map((plot) => plot.figure));

  told("shows", runs[0].shows);
  runs.forEach((run, i) => {
    const list = document.createElement("ul");
    for (const sentence of wordsOfRun(run)) {
      const item = document.createElement("li");
      item.textContent = sentence;
      list.append(item);
    }
    const heading = document.createElement("h3");
    heading.textContent = run.name;
    $("words").append(...(runs.length > 1 ? [heading, list] : [list]));
    if (runs.length === 1) return;
    const label = document.createElement("label"), box = document.createElement("input");
    box.type = "checkbox";
    box.checked = true;
    box.addEventListener("change", () => { shown[i] = box.checked; again(); });
    label.append(box, ` ${run.name} (${i === 0 ? "blue" : "orange, dashed"})`);
    $("runs").append(label);
  });

  const same = runs.length > 1 && runs[0].points === runs[1].points;
  for (const [value, text] of [["run", "by run"], ["own", "as hair"], ["stretch", "by stretch: blue shorter, red longer than at first, full at 10 %"], ["strand", "by strand"], ["distance", "by distance from the other run, full at a tenth of the scene"]])
    if ((value !== "run" || runs.length > 1) && (value !== "distance" || same)) $("colour").add(new Option(text, value));

  const frames = runs[0].frames;
  $("time").max = frames - 1;
  $("time").addEventListener("input", () => { clock.stop(); seek(runs[0].times[$("time").value]); });
  $("rate").addEventListener("change", () => { clock.rate = Number($("rate").value); });
  $("colour").addEventListener("change", again);
  const toggle = () => { clock.playing ? clock.stop() : clock.play(); again(); };
  $("play").addEventListener("click", toggle);
  const step = (by) => {
    clock.stop();
    const { k } = frameAt(runs[0], clock.time + 1e-9);
    seek(runs[0].times[Math.max(0, Math.min(frames - 1, k + by))]);
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || ["SELECT", "INPUT"].includes(event.target.tagName)) return;
    const keys = { " ": toggle, ",": () => step(-1), ".": () => step(1) };
    if (event.key === " " && event.target.tagName === "BUTTON") return;
    if (keys[event.key]) keys[event.key]();
    else if (!turnByKey(event.key, orbit)) return;
    event.preventDefault();
  });

  const watch = () => {
    followPointers(canvas, orbit);
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      // A card may come back; if it does not within a second, plain lines take its place.
      const lost = canvas, wait = setTimeout(() => {
        if (canvas !== lost) return;
        canvas = replaceCanvas(lost);
        drawing = makeFlatDrawing(canvas);
        held = runs.map(drawing.upload);
        told("note", "The graphics card was lost: strands are drawn as plain lines.");
        watch();
        again();
      }, 1000);
      lost.addEventListener("webglcontextrestored", () => {
        clearTimeout(wait);
        drawing = makeDrawing(lost);
        held = runs.map(drawing.upload);
        again();
      }, { once: true });
    });
  };
  watch();

  const tint = (run, k) => {
    const way = $("colour").value, other = runs[1 - run] || null;
    // Colours that follow the motion are those of the frame.
    const moves = way === "stretch" || way === "distance" || (runs[run].blow_up && k >= runs[run].frames - 2);
    return { name: `${way} ${moves ? k : ""}`, write: (bytes) => colourPoints(bytes, runs[run], k, way, run, other) };
  };

  const draw = (at) => {
    const time = clock.now(at), ratio = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (width > 0 && (canvas.width !== width || canvas.height !== height)) { canvas.width = width; canvas.height = height; }
    const moves = at - orbit.moved < 300;
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const aspect = canvas.width / canvas.height;
    const scene = {
      camera: orbit.matrix(aspect), eye: orbit.eye(), target: orbit.target,
      fieldOfView: orbit.fieldOfView(aspect), pixels: ratio, background: dark ? [0.09, 0.1, 0.12] : [0.93, 0.94, 0.95],
    };
    const now = runs.map((run, i) => ({ held: held[i], run: i, ...frameAt(run, time) })).filter((one) => shown[one.run]);
    for (const one of now) one.tint = tint(one.run, one.k);
    const few = moves && seconds > SLOW;
    drawing.draw(scene, now, few);
    for (const plot of plots) plot.draw(time);
    const { k } = frameAt(runs[0], time);
    $("time").value = k;
    $("time").setAttribute("aria-valuetext", wordsOfMoment(runs[0], k));
    told("play", clock.playing ? "Stop" : "Play");
    const broken = runs.find((run) => run.blow_up && time >= run.duration);
    told("moment", wordsOfMoment(runs[0], k) + (broken ? `. ${broken.name} broke here: ${broken.blow_up.text}` : "") + (few ? ". While the view moves, a third of the strands is shown" : ""));
    canvas.setAttribute("aria-label", `${runs.map((run) => run.name).join(" and ")}. ${wordsOfMoment(runs[0], k)}. ${WORDS_OF_KEYS}`);
    return moves;
  };

  let moved = true, last = 0; // last: when it drew, ms; 0: it did not in the last turn
  const loop = (at) => {
    const draws = dirty || clock.playing || moved || at - orbit.moved < 400;
    if (draws && last > 0 && !moved) seconds = (at - last) / 1000;
    last = draws ? at : 0;
    if (draws) {
      dirty = false;
      moved = draw(at);
      ++window.hairView.pictures;
    }
    requestAnimationFrame(loop);
  };
  // For tests: where things are, and how many pictures were drawn.
  window.hairView = { runs, clock, seek, orbit, pictures: 0, frame: () => frameAt(runs[0], clock.time) };
  new ResizeObserver(again).observe(canvas);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
  requestAnimationFrame(loop);
}

try {
  show();
} catch (error) {
  told("note", `This page can't show the run: ${error.message}`);
}
