// The live page: it shows the results of a running process (hair/live/runner.h), and controls it.

const WORDS_WAIT = 1000; // ms between words that follow the motion
const PLOTS_WAIT = 250; // ms between plots, which grow
const HAND_WAIT = 33; // ms between two commands of the hand
const AGAIN_WAIT = 1500; // ms until hair that broke in the hand starts anew
const KEPT_FRAMES = 1800; // of a motion that the hand leads without an end
const NAMES_OF_ENDS = { finished: "It is over", blow_up: "It blew up" };

// A motion that grows by a frame at a time.
function makeLiveMotion(told) {
  const frames = [], motion = makeMotion({ ...told, times: [], name: told.name }, [0, 0, 0], [1, 1, 1], (k) => frames[k]);
  const series = told.series.map((one) => ({ ...one, values: [] }));
  return Object.assign(motion, {
    series,
    add(frame) {
      frames.push(new Float32Array(bytesOfBase64(frame.last.data).buffer));
      motion.times.push(frame.time);
      motion.planes = frame.last.planes;
      series.forEach((one, i) => one.values.push(frame.values[i]));
      const lists = [frames, motion.times, ...series.map((one) => one.values)];
      if (frames.length > KEPT_FRAMES) for (const list of lists) list.shift();
    },
    clear() {
      for (const list of [frames, motion.times, ...series.map((one) => one.values)]) list.length = 0;
      motion.blow_up = null;
      motion.forget();
    },
  });
}

function watchSimulation() {
  const runs = [];
  let orbit = null, stage = null, plots = [], going = true, over = false, dirty = false, whole = 0, usual = 0;
  let shown = -1; // a frame, or -1 for the newest
  const again = () => { dirty = true; };
  const state = (text) => told("state", text);
  const send = (command) => fetch("command", { method: "POST", body: command })
    .then((answer) => { if (!answer.ok) state("The server refused a command."); }, () => state("hairlab live has ended."));

  const settings = () => `${2 ** Number($("step-size").value)} ${10 ** Number($("stiffness").value)} ${$("wind").value} ${$("method").value}`.trim();
  let later = 0; // a restart of what broke
  const restart = () => { clearTimeout(later); send(`restart ${settings()}`); };

  // The hand: where it leads roots, m and rad from the start.
  let hand = [0, 0, 0], turn = 0, sends = 0;
  const sendHand = () => { sends = 0; send(`hand ${[...hand, turn].map((x) => x.toFixed(5)).join(" ")}`); };
  const drag = (right, up) => {
    if ($("drag").value === "root") hand = add(hand, orbit.way(right, up));
    else if ($("drag").value === "turn") turn += 4 * right;
    else return false;
    sends ||= setTimeout(sendHand, HAND_WAIT);
    return true;
  };
  const toggle = () => (over ? restart() : send(going ? "pause" : "go"));
  const step = () => send("step");
  const say = () => {
    told("step-words", usual > 0 ? `${few(usual * 2 ** Number($("step-size").value) * 1000)} ms` : "");
    told("stiffness-words", `${few(10 ** Number($("stiffness").value))} times`);
    told("wind-words", `${$("wind").value} m/s`);
  };
  $("play").addEventListener("click", toggle);
  $("step").addEventListener("click", step);
  $("restart").addEventListener("click", restart);
  for (const id of ["step-size", "stiffness", "wind"]) $(id).addEventListener("input", say);
  for (const id of ["step-size", "stiffness", "wind", "method"]) $(id).addEventListener("change", restart);
  $("rate").addEventListener("change", () => send(`rate ${$("rate").value}`));
  const show = (k) => { shown = k >= runs[0].frames - 1 ? -1 : k; again(); };
  $("time").addEventListener("input", () => show(Number($("time").value)));

  const begin = (message) => {
    const { motion: now } = message;
    if (runs.length === 0) {
      runs.push(makeLiveMotion(now));
      orbit = Object.assign(makeOrbit(now.camera), { drag });
      $("drag").disabled = !message.has_roots;
      stage = makeStage(runs, orbit, (text) => told("note", text), again);
      plots = now.series.map((one) => makePlot(one.name, runs, (time) => show(frameAt(runs[0], time).k)));
      $("plots").append(...plots.map((plot) => plot.figure));
      offerColours(runs, again);
      followKeys({ " ": toggle, ".": step, r: restart }, orbit);
      for (const method of message.methods) $("method").add(new Option(method.name, method.id));
      $("method").disabled = message.methods.length < 2;
      requestAnimationFrame(loop);
    } else if (runs[0].points !== now.points || runs[0].strands.length !== now.strands.length) {
      location.reload();
    }
    whole = message.whole;
    shown = -1;
    usual = message.step / 2 ** Number($("step-size").value);
    $("method").value = message.method;
    say();
  };

  const hearState = (message) => {
    going = message.going;
    over = Boolean(message.ended);
    told("play", over ? "Start anew" : going ? "Pause" : "Go on");
    Object.assign(runs[0], { blow_up: message.blow_up, ended: message.ended });
    state(message.ended ? `${NAMES_OF_ENDS[message.ended]}${message.blow_up ? `: ${message.blow_up.text}` : ""}.` : going ? "running" : `paused after step ${message.steps}`);
    if (message.ended) writeWords(runs);
    if (message.ended === "blow_up" && (hand.some(Boolean) || turn)) {
      clearTimeout(later);
      later = setTimeout(restart, AGAIN_WAIT);
    }
    again();
  };

  const hear = {
    began(message) {
      runs[0]?.clear();
      told("moment", "");
      $("words").replaceChildren();
      state(message.why ? `${message.why} Starting.` : "starting");
      const [times, stiffness, wind] = message.settings.split(" ").map(Number);
      $("step-size").value = Math.log2(times);
      $("stiffness").value = Math.log10(stiffness);
      $("wind").value = wind;
      [hand, turn] = [[0, 0, 0], 0];
    },
    start: begin,
    frame(message) { runs[0].add(message); again(); },
    state: hearState,
    trouble(message) { state(message.text); going = false; told("play", "Start anew"); over = true; },
  };
  const events = new EventSource("events");
  events.addEventListener("message", (event) => { const message = JSON.parse(event.data); hear[message.kind](message); });
  events.addEventListener("error", () => state(events.readyState === EventSource.CLOSED ? "The server refuses this page: too many of them are open, or the address is not whole." : "hairlab live does not answer: it has ended, or the machine is busy."));

  let worded = -WORDS_WAIT, plotted = -PLOTS_WAIT;
  const draw = (at) => {
    const [run] = runs, k = shown < 0 ? run.frames - 1 : shown, dark = matchMedia("(prefers-color-scheme: dark)").matches;
    stage.draw([{ run: 0, k, between: 0, tint: tintOf(runs, 0, k) }], false, dark, going);
    if (!going || at - plotted > PLOTS_WAIT) {
      plotted = at;
      for (const plot of plots) plot.draw(run.times[k], Math.max(whole, run.duration), dark);
    }
    $("time").max = run.frames - 1;
    $("time").value = k;
    const words = wordsOfMoment(run, k);
    $("time").setAttribute("aria-valuetext", words);
    told("moment", words + (shown < 0 ? "" : ". Newer frames are to its right"));
    if (going && at - worded < WORDS_WAIT) return; // a screen reader reads no faster
    worded = at;
    stage.label(`${words}. ${WORDS_OF_CAMERA_KEYS}, space plays and stops, full stop computes a step, r starts anew.`);
  };
  const loop = (at) => {
    if ((dirty || at - orbit.moved < 400) && runs[0].frames > 0) {
      dirty = false;
      draw(at);
      ++window.hairView.pictures;
    }
    requestAnimationFrame(loop);
  };
  // For tests.
  window.hairView = { runs, pictures: 0, get going() { return going; } };
}

watchSimulation();
