// Looks at pairs of pictures: each of them, a swipe, a blink, their difference or FLIP, enlarged together.

// Matplotlib's magma at 0, 1/8, ..., 1.
const MAGMA = [[0, 0, 4], [28, 16, 68], [79, 18, 123], [129, 37, 129], [181, 54, 122], [229, 80, 100], [251, 135, 97], [254, 194, 135], [252, 253, 191]];
const GAINS = [1, 4, 16], MOST_ZOOM = 32;
const MODES = { one: "1", other: "2", swipe: "s", difference: "d", flip: "f" };

function magma(value) {
  const at = Math.min(Math.max(value, 0), 1) * (MAGMA.length - 1), k = Math.min(Math.floor(at), MAGMA.length - 2);
  return MAGMA[k].map((low, i) => low + (MAGMA[k + 1][i] - low) * (at - k));
}

function layerOf({ width, height }, pixel) {
  const layer = Object.assign(document.createElement("canvas"), { width, height }), image = new ImageData(width, height);
  for (let i = 0; i < width * height; ++i) image.data.set([...pixel(i), 255], 4 * i);
  layer.getContext("2d").putImageData(image, 0, 0);
  return layer;
}

const element = (name, fields, ...inside) => {
  const made = Object.assign(document.createElement(name), fields);
  made.append(...inside);
  return made;
};

// pairs: { name, scores, titles, load: () => a promise of two ImageData of one size }. The dialog shows one
// of them, and removes itself when it is closed.
function openViewer(pairs, first) {
  let at = first, both = null, layers = {}, errors = null, mode = "swipe", gain = 0, zoom = 1, left = 0, top = 0, cut = 0.5, cursor = null, held = false;
  const canvas = element("canvas", { tabIndex: 0 }), values = element("p", { className: "quiet" }), scores = element("p"), heading = element("h2");
  canvas.setAttribute("role", "img");
  const buttons = {}, controls = element("div", { className: "controls" });
  const add = (name, key, text, act) => {
    buttons[name] = element("button", { type: "button", onclick: () => { act(); canvas.focus(); } }, text, " ", element("kbd", {}, key));
    controls.append(buttons[name], " ");
  };
  const dialog = element("dialog", { className: "viewer" }, heading, scores, controls, canvas, values);
  dialog.setAttribute("aria-label", "Two pictures");

  const layer = (name) => {
    const key = name === "difference" ? `${name} ${gain}` : name, [a, b] = both.map((one) => one.data);
    if (name === "flip") errors ??= flip(...both);
    layers[key] ??= layerOf(both[0], {
      one: (i) => a.subarray(4 * i, 4 * i + 3),
      other: (i) => b.subarray(4 * i, 4 * i + 3),
      difference: (i) => [0, 1, 2].map((c) => GAINS[gain] * Math.abs(a[4 * i + c] - b[4 * i + c])),
      flip: (i) => magma(errors[i]),
    }[name]);
    return layers[key];
  };

  // One of the pictures' pixels is zoom x zoom of the screen's; left and top are whole ones.
  const within = (low, size, shown) => Math.round(Math.min(Math.max(low, 0), Math.max(0, size - shown / zoom)));
  const wordsOfMode = () => {
    const [one, other] = pairs[at].titles;
    return {
      one, other, swipe: `${one} to the left, ${other} to the right`,
      difference: `the difference, ${GAINS[gain]} times`,
      flip: `FLIP, 0 black to 1 pale yellow, ${PIXELS_PER_DEGREE} pixels a degree` + (errors ? `: ${(errors.reduce((sum, one) => sum + one, 0) / errors.length).toPrecision(3)} in the mean` : ""),
    }[mode];
  };
  const writeValues = () => {
    const { width, height } = both[0], [x, y] = cursor ?? [Math.floor(left + canvas.width / zoom / 2), Math.floor(top + canvas.height / zoom / 2)];
    const i = y * width + x, inside = x >= 0 && x < width && y >= 0 && y < height;
    const of = (image) => [...image.data.subarray(4 * i, 4 * i + 3)];
    values.textContent = !inside ? "" :
      `${x}, ${y}: ${pairs[at].titles.map((title, k) => `${title} ${of(both[k]).join(" ")}`).join("; ")}; apart ${of(both[0]).map((one, c) => Math.abs(one - of(both[1])[c])).join(" ")}` +
      (errors ? `; FLIP ${errors[i].toPrecision(3)}` : "") + `; enlarged ${zoom} times`;
  };
  const paint = () => {
    if (!both) return;
    const { width, height } = both[0], ratio = devicePixelRatio || 1, context = canvas.getContext("2d");
    Object.assign(canvas, { width: Math.round(canvas.clientWidth * ratio), height: Math.round(canvas.clientHeight * ratio) });
    left = within(left, width, canvas.width);
    top = within(top, height, canvas.height);
    context.imageSmoothingEnabled = false;
    const draw = (name, from, to) => {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, canvas.height);
      context.clip();
      context.drawImage(layer(name), -left * zoom, -top * zoom, width * zoom, height * zoom);
      context.restore();
    };
    const shown = Math.min(canvas.width, (width - left) * zoom), middle = Math.round(cut * shown);
    if (mode === "swipe") {
      draw(held ? "other" : "one", 0, middle);
      draw(held ? "one" : "other", middle, canvas.width);
      context.fillStyle = "#ff7a00";
      context.fillRect(middle - 1, 0, 2, canvas.height);
    } else {
      draw(held ? { one: "other", other: "one" }[mode] ?? "one" : mode, 0, canvas.width);
    }
    const words = wordsOfMode();
    heading.textContent = `${pairs[at].name}: ${words}`;
    scores.textContent = pairs[at].scores;
    canvas.setAttribute("aria-label", `${pairs[at].name}, ${words}. ${pairs[at].scores}`);
    for (const name of Object.keys(MODES)) buttons[name].setAttribute("aria-pressed", name === mode);
    writeValues();
  };
  const show = async (next) => {
    at = Math.min(Math.max(next, 0), pairs.length - 1);
    const wanted = at, loaded = await pairs[at].load(canvas.clientWidth, canvas.clientHeight);
    if (wanted !== at) return;
    const same = both && both[0].width === loaded[0].width && both[0].height === loaded[0].height;
    [both, layers, errors] = [loaded, {}, null];
    if (!same) zoom = Math.max(1, Math.min(Math.floor(canvas.clientWidth * devicePixelRatio / both[0].width), Math.floor(canvas.clientHeight * devicePixelRatio / both[0].height)));
    paint();
  };
  // The pixel below a place of the screen stays there.
  const enlarge = (by, x = canvas.width / 2, y = canvas.height / 2) => {
    const next = Math.min(Math.max(zoom + by, 1), MOST_ZOOM);
    left += x / zoom - x / next;
    top += y / zoom - y / next;
    zoom = next;
    paint();
  };
  const move = (x, y) => { left += x; top += y; paint(); };
  const place = (event) => {
    const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
    return [(event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio];
  };

  add("one", "1", pairs[at].titles[0], () => { mode = "one"; paint(); });
  add("other", "2", pairs[at].titles[1], () => { mode = "other"; paint(); });
  add("swipe", "s", "Swipe", () => { mode = "swipe"; paint(); });
  add("difference", "d", "Difference", () => { gain = mode === "difference" ? (gain + 1) % GAINS.length : gain; mode = "difference"; paint(); });
  add("flip", "f", "FLIP", () => { mode = "flip"; paint(); });
  add("larger", "+", "Larger", () => enlarge(1));
  add("smaller", "-", "Smaller", () => enlarge(-1));
  add("before", ",", "Before", () => show(at - 1));
  add("after", ".", "After", () => show(at + 1));
  buttons.blink = element("button", { type: "button" }, "Hold to blink ", element("kbd", {}, "b"));
  const blink = (is) => { held = is; paint(); };
  for (const [name, is] of [["pointerdown", true], ["pointerup", false], ["pointerleave", false]]) buttons.blink.addEventListener(name, () => blink(is));
  controls.append(buttons.blink, " ", element("button", { type: "button", onclick: () => dialog.close() }, "Close"));

  const keys = { 1: "one", 2: "other", s: "swipe", d: "difference", f: "flip", "+": "larger", "=": "larger", "-": "smaller", ",": "before", ".": "after" };
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  dialog.addEventListener("keydown", (event) => {
    event.stopPropagation(); // the page's own keys rest
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = steps[event.key], by = Math.max(1, Math.round(canvas.width / zoom / 16));
    if (step && event.shiftKey && mode === "swipe") { cut = Math.min(Math.max(cut + step[0] / 16, 0), 1); paint(); }
    else if (step) { cursor = null; move(by * step[0], by * step[1]); }
    else if (event.key === "b") { if (!event.repeat) blink(true); }
    else if (keys[event.key]) buttons[keys[event.key]].click();
    else return;
    event.preventDefault();
  });
  dialog.addEventListener("keyup", (event) => { if (event.key === "b") blink(false); });
  canvas.addEventListener("wheel", (event) => { event.preventDefault(); enlarge(event.deltaY < 0 ? 1 : -1, ...place(event)); }, { passive: false });
  let drags = null;
  canvas.addEventListener("pointerdown", (event) => { drags = [...place(event), left, top]; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", () => { drags = null; });
  canvas.addEventListener("pointermove", (event) => {
    const [x, y] = place(event);
    cursor = [Math.floor(left + x / zoom), Math.floor(top + y / zoom)];
    if (drags && mode === "swipe" && !event.shiftKey) cut = Math.min(Math.max(x / Math.min(canvas.width, (both[0].width - left) * zoom), 0), 1);
    else if (drags) [left, top] = [drags[2] + (drags[0] - x) / zoom, drags[3] + (drags[1] - y) / zoom];
    if (drags) paint();
    else if (both) writeValues();
  });
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  new ResizeObserver(paint).observe(canvas);
  canvas.focus();
  show(at);
  return dialog;
}

function pixelsOf(image, width, height) {
  const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

// The pictures that stand side by side in a page: a row has two, and the scores are in the line above them.
function watchPictures() {
  const rows = [...document.querySelectorAll(".pictures")].filter((row) => row.querySelectorAll("img").length > 1);
  const pairs = rows.map((row) => {
    const images = [...row.querySelectorAll("img")].slice(0, 2), [name, ...scores] = row.previousElementSibling.children;
    return {
      name: name.textContent,
      scores: scores.map((one) => one.textContent).join("; "),
      titles: [...row.querySelectorAll("figcaption")].slice(0, 2).map((one) => one.textContent.split(",")[0]),
      // A coarse picture makes the other one coarse, too.
      load: async () => {
        await Promise.all(images.map((one) => one.decode()));
        const [width, height] = ["naturalWidth", "naturalHeight"].map((side) => Math.min(...images.map((one) => one[side])));
        return images.map((one) => pixelsOf(one, width, height));
      },
    };
  });
  rows.forEach((row, k) => {
    row.previousElementSibling.append(element("button", { type: "button", onclick: () => openViewer(pairs, k) }, "Look closer"));
    row.addEventListener("click", (event) => { if (event.target.matches("img")) openViewer(pairs, k); });
  });
}

// Two runs of a page of hair/view: each frame is a pair, drawn at the window's size as the camera is now.
function watchRuns({ runs, apart, clock, pixels }) {
  const { times } = runs.reduce((one, other) => (other.duration < one.duration ? other : one));
  const pairs = [...times].map((time, k) => ({
    name: `${few(time)} s`,
    scores: apart ? `apart by up to ${few(apart.values[k])} ${apart.unit}` : "",
    titles: runs.map((run) => run.name),
    load: async (width, height) => runs.map((_, run) => pixels(run, time, width, height)),
  }));
  const here = () => Math.max(times.findLastIndex((time) => time <= clock.time + 1e-9), 0);
  const button = element("button", { type: "button", onclick: () => { clock.stop(); openViewer(pairs, here()); } }, "Look closer");
  document.getElementById("runs").append(button);
}

watchPictures();
if (window.hairView?.runs.length > 1) watchRuns(window.hairView);
