// The canvas: it draws with WebGL2, or with plain lines if there is none, or if the card is lost for good.

const WAIT = 1000; // ms for a lost card to come back
const PICTURE = 20, MEASURED = 8, COARSEST = 0.4; // ms for a picture that moves; each eighth is measured
const PLAIN = "strands are drawn as plain lines.", LOST = "The graphics card was lost";

// motions: in the order of the runs; tell(text): a note for the reader; again(): asks for a picture.
function makeStage(motions, orbit, tell, again) {
  let canvas = document.getElementById("picture"), drawing = null, held = [], plain = false;
  const hold = () => { held = motions.map(drawing.upload); again(); };
  const strands = () => motions.reduce((sum, motion) => sum + motion.strands.length, 0);
  const exchange = (other) => { canvas.replaceWith(other); canvas = other; };
  // A canvas with a WebGL context can't draw plain lines: a new one replaces it.
  const drawPlainly = (why) => {
    plain = true;
    exchange(canvas.cloneNode(false));
    watch();
    drawing = makeFlatDrawing(canvas);
    tell(`${why}: ${PLAIN}`);
    hold();
  };
  const watch = () => {
    const watched = canvas;
    let wait = 0;
    followPointers(canvas, orbit);
    new ResizeObserver(again).observe(canvas);
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      wait = setTimeout(drawPlainly, WAIT, LOST);
    });
    canvas.addEventListener("webglcontextrestored", () => {
      clearTimeout(wait);
      if (canvas !== watched) exchange(watched);
      begin(LOST);
    });
  };
  // without: why there is no WebGL2, if there is none
  const begin = (without) => {
    try {
      drawing = makeDrawing(canvas, strands());
      plain = false;
      tell("");
      hold();
    } catch (error) {
      drawPlainly(without);
    }
  };
  const paint = (now, few, dark, width, height, ratio) => {
    if (width > 0 && (canvas.width !== width || canvas.height !== height)) { canvas.width = width; canvas.height = height; }
    const aspect = canvas.width / canvas.height;
    const scene = {
      camera: orbit.matrix(aspect), eye: orbit.eye(), target: orbit.target,
      fieldOfView: orbit.fieldOfView(aspect), pixels: ratio, background: dark ? [0.09, 0.1, 0.12] : [0.93, 0.94, 0.95],
    };
    drawing.draw(scene, now.map((one) => ({ ...one, held: held[one.run] })), few);
  };
  // Pictures that take long are coarser while things move.
  let coarse = 1, pictures = 0;
  const measure = (begun) => {
    drawing.wait();
    const times = Math.sqrt(PICTURE / (performance.now() - begun));
    if (times < 0.9 || times > 1.2) coarse = Math.max(COARSEST, Math.min(1, coarse * times));
  };
  watch();
  begin("This browser shows no WebGL2");
  return {
    hold, // after a motion became another one
    get plain() { return plain; },
    label(text) { if (canvas.getAttribute("aria-label") !== text) canvas.setAttribute("aria-label", text); },
    // now: run, k, between, tint; few: a share of the strands; moves: the next picture is another one
    draw(now, few, dark, moves) {
      const ratio = (window.devicePixelRatio || 1) * (moves ? coarse : 1), begun = performance.now();
      paint(now, few, dark, Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio), ratio);
      if (moves && ++pictures % MEASURED === 0) measure(begun);
    },
    // ImageData of a picture of this size
    pixels(now, dark, width, height) {
      paint(now, false, dark, width, height, 1);
      const copy = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      return copy.getImageData(0, 0, width, height);
    },
  };
}
