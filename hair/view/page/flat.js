// Draws strands without WebGL2: lines on a plain canvas.

const MOST_LINES = 400;

function makeFlatDrawing(canvas) {
  const pen = canvas.getContext("2d");
  const project = (camera, p) => {
    const w = camera[3] * p[0] + camera[7] * p[1] + camera[11] * p[2] + camera[15];
    if (w <= 0) return null;
    const x = camera[0] * p[0] + camera[4] * p[1] + camera[8] * p[2] + camera[12];
    const y = camera[1] * p[0] + camera[5] * p[1] + camera[9] * p[2] + camera[13];
    return [((x / w + 1) / 2) * canvas.width, ((1 - y / w) / 2) * canvas.height];
  };
  return {
    wait() {},
    upload: (motion) => ({ motion, coloured: "", colourBytes: new Uint8Array(4 * motion.points) }),
    draw(scene, runs) {
      pen.fillStyle = `rgb(${scene.background.map((c) => Math.round(255 * c)).join(" ")})`;
      pen.fillRect(0, 0, canvas.width, canvas.height);
      pen.lineWidth = 1.5 * scene.pixels;
      for (const { held, k, between, tint } of runs) {
        recolour(held, tint); // it asks for other places
        const { motion } = held, { starts } = motion, places = motion.places(k, between);
        const place = (i) => project(scene.camera, places.subarray(3 * i, 3 * i + 3));
        const every = Math.ceil(motion.strands.length / MOST_LINES);
        for (let s = 0; s + 1 < starts.length; s += every) {
          pen.beginPath();
          for (let i = starts[s]; i < starts[s + 1]; ++i) {
            const at = place(i);
            if (at) pen.lineTo(...at);
          }
          pen.strokeStyle = `rgb(${[...held.colourBytes.subarray(4 * starts[s], 4 * starts[s] + 3)].join(" ")})`;
          pen.stroke();
        }
        pen.strokeStyle = "rgb(128 128 128)";
        for (let i = 0; i < motion.rods.length; ++i) {
          const [a, b] = [0, 1].map((end) => place(motion.first_rod + 2 * i + end));
          if (!a || !b) continue;
          pen.beginPath();
          pen.moveTo(...a);
          pen.lineTo(b[0] + 0.01, b[1]);
          pen.stroke();
        }
      }
    },
  };
}
