// Plots over the time of the motion. All plots have the same time axis; a click goes to that time.

const PLOT = { left: 64, right: 8, top: 8, bottom: 20 };

function rangeOf(lists) {
  let low = Infinity, high = -Infinity;
  for (const values of lists)
    for (const value of values)
      if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
  if (low > high) return [0, 1];
  return high > low ? [low, high] : [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
}

function drawCurves(canvas, name, runs, series, duration) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const range = rangeOf(series.filter((one) => one).map((one) => one.values));
  const pen = canvas.getContext("2d"), style = getComputedStyle(canvas), inside = width - PLOT.left - PLOT.right;
  const x = (t) => PLOT.left + (inside * t) / (duration || 1);
  const y = (value) => PLOT.top + ((height - PLOT.top - PLOT.bottom) * (range[1] - value)) / (range[1] - range[0]);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.font = `12px ${style.fontFamily}`;
  pen.fillStyle = style.color;
  pen.textAlign = "right";
  pen.fillText(few(range[1]), PLOT.left - 6, PLOT.top + 10);
  pen.fillText(few(range[0]), PLOT.left - 6, height - PLOT.bottom);
  pen.fillText(`${few(duration)} s`, width - PLOT.right, height - 5);
  pen.textAlign = "left";
  pen.fillText("0", PLOT.left, height - 5);
  pen.strokeStyle = style.borderTopColor;
  pen.strokeRect(PLOT.left, PLOT.top, inside, height - PLOT.top - PLOT.bottom);
  series.forEach((one, run) => {
    if (!one) return;
    pen.beginPath();
    let open = false;
    one.values.forEach((value, k) => {
      if (value === null) { open = false; return; }
      open ? pen.lineTo(x(runs[run].times[k]), y(value)) : pen.moveTo(x(runs[run].times[k]), y(value));
      open = true;
    });
    pen.strokeStyle = `rgb(${RUNS[run].map((c) => Math.round(255 * c)).join(" ")})`;
    pen.setLineDash(run === 0 ? [] : [6, 3]);
    pen.lineWidth = 1.75;
    pen.stroke();
    pen.setLineDash([]);
    if (runs[run].blow_up) {
      pen.fillStyle = "rgb(217 26 26)";
      pen.fillText("broke", Math.min(x(runs[run].duration) + 3, width - 40), PLOT.top + 12);
      pen.fillStyle = style.color;
    }
  });
}

// runs: motions; seek(time). The curves are drawn again only when they have changed; the line at the present
// time moves.
function makePlot(name, runs, seek) {
  const [figure, caption, frame, canvas, moment] = ["figure", "figcaption", "div", "canvas", "i"].map((tag) => document.createElement(tag));
  figure.className = "plot";
  const series = () => runs.map((motion) => motion.series.find((one) => one.name === name));
  const unit = series().find((one) => one)?.unit;
  caption.textContent = name + (unit ? `, ${unit}` : "");
  canvas.setAttribute("role", "img");
  frame.append(canvas, moment);
  figure.append(caption, frame);
  const inside = () => canvas.clientWidth - PLOT.left - PLOT.right;
  let duration = 0, drawn = "";
  const go = (event) => {
    if (event.buttons === 1) seek((duration * (event.offsetX - PLOT.left)) / inside());
  };
  canvas.addEventListener("pointerdown", go);
  canvas.addEventListener("pointermove", go);
  return {
    figure,
    draw(time, whole, dark) {
      if (canvas.clientWidth === 0) return;
      duration = whole;
      const now = [canvas.clientWidth, window.devicePixelRatio, dark, duration, ...runs.map((run) => run.times.length)].join(" ");
      if (now !== drawn) {
        drawCurves(canvas, name, runs, series(), duration);
        canvas.setAttribute("aria-label", `${name} over time. ${series().filter((one) => one).map(wordsOfSeries).join("; ")}`);
        drawn = now;
      }
      moment.style.transform = `translateX(${PLOT.left + (inside() * time) / (duration || 1)}px)`;
    },
  };
}
