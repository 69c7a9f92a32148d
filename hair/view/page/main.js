// The page of a run: a moving picture, the measured values beneath it, and the run in words.

const SLOW = 1 / 25; // s; a picture that takes longer shows fewer strands while the view moves
const WORDS_WAIT = 250; // ms between words that follow the motion: a screen reader reads no faster

function show() {
  const runs = ["motion", "other"].filter($).map((id) => Object.assign(readMotion($(id).textContent), { name: $(id).dataset.name }));
  const lead = runs.reduce((one, other) => (other.duration > one.duration ? other : one)), { duration, frames } = lead;
  const framed = window !== top, clock = makeClock(duration, framed), orbit = makeOrbit(runs[0].camera), shown = runs.map(() => true);
  const apart = runs.length > 1 ? seriesApart(...runs) : null;
  if (apart) runs[0].series.push(apart);
  let dirty = true, seconds = 0; // seconds: from a picture of all strands to the next one
  const again = () => { dirty = true; };
  const seek = (time) => { clock.seek(time); again(); };
  const stage = makeStage(runs, orbit, (text) => told("note", text), again);
  const plots = [...new Set(runs.flatMap((run) => run.series.map((one) => one.name)))].map((name) => makePlot(name, runs, seek));
  $("plots").append(...plots.map((plot) => plot.figure));

  told("shows", [...new Set(runs.map((run) => run.shows))].join(". "));
  document.documentElement.classList.toggle("framed", framed);
  writeWords(runs);
  offerColours(runs, again);
  if (runs.length > 1)
    runs.forEach((run, i) => {
      const label = document.createElement("label"), box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true });
      box.addEventListener("change", () => { shown[i] = box.checked; again(); });
      label.append(box, ` ${run.name} (${i === 0 ? "blue" : "orange, dashed"})`);
      $("runs").append(label, " ");
    });

  const goApart = apart && offerDifferences(apart, runs[0].times, (time) => { clock.stop(); seek(time); });
  $("time").max = frames - 1;
  $("time").addEventListener("input", () => { clock.stop(); seek(lead.times[$("time").value]); });
  $("rate").addEventListener("change", () => { clock.rate = Number($("rate").value); });
  const toggle = () => { clock.playing ? clock.stop() : clock.play(); again(); };
  $("play").addEventListener("click", toggle);
  const step = (by) => {
    clock.stop();
    const { k } = frameAt(lead, clock.time + 1e-9);
    seek(lead.times[Math.max(0, Math.min(frames - 1, k + by))]);
  };
  followKeys({ " ": toggle, ",": () => step(-1), ".": () => step(1) }, orbit);

  let worded = -WORDS_WAIT, wordsOf = "";
  const writeMoment = (at, time, few) => {
    const { k } = frameAt(lead, time), now = `${k} ${few} ${clock.playing}`;
    if (now === wordsOf || (clock.playing && at - worded < WORDS_WAIT)) return;
    [worded, wordsOf] = [at, now];
    const words = wordsOfMoment(lead, k), broken = runs.find((run) => run.blow_up && time >= run.duration);
    $("time").value = k;
    $("time").setAttribute("aria-valuetext", words);
    told("play", clock.playing ? "Stop" : "Play");
    told("moment", words + (broken ? `. ${broken.name} broke here: ${broken.blow_up.text}` : "") + (few ? ". While the view moves, a third of the strands is shown" : ""));
    stage.label(`${runs.map((run) => run.name).join(" and ")}. ${words}. ${WORDS_OF_CAMERA_KEYS}, space plays and stops, comma and full stop go a frame back and on.`);
  };

  const draw = (at) => {
    const time = clock.now(at), dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const moves = at - orbit.moved < 300, few = moves && seconds > SLOW;
    const now = runs.map((run, i) => ({ run: i, ...frameAt(run, time) })).filter((one) => shown[one.run]);
    for (const one of now) one.tint = tintOf(runs, one.run, one.k);
    stage.draw(now, few, dark, moves || clock.playing);
    for (const plot of plots) plot.draw(time, duration, dark);
    writeMoment(at, time, few);
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
  // For tests: the parts of the page, and the number of pictures drawn.
  window.hairView = {
    runs, clock, seek, orbit, stage, apart, pictures: 0,
    // ImageData of one run as hair, of this size, as the camera is now
    pixels(run, time, width, height) {
      const now = { run, ...frameAt(runs[run], time) };
      const tint = { name: "picture", write: (bytes) => colourPoints(bytes, runs[run], now.k, "own", run, null) };
      const pixels = stage.pixels([{ ...now, tint }], matchMedia("(prefers-color-scheme: dark)").matches, width, height);
      again();
      return pixels;
    },
    places: () => { const { k, between } = frameAt(runs[0], clock.time); return [...runs[0].places(k, between)]; },
  };
  // An address ends in #apart=1 for the first difference of that size, in per cent, or in #time=0.5 (s).
  const [, wanted, number] = /^#(apart|time)=([\d.]+)$/.exec(location.hash) ?? [];
  if (wanted === "time") seek(Number(number));
  else if (wanted && goApart) goApart(Number(number));
  if (!wanted && !matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
  requestAnimationFrame(loop);
}

try {
  show();
} catch (error) {
  told("note", `This page can't show the run: ${error.message}`);
}
