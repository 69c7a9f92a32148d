// A camera that goes around a point: by dragging, by two fingers, by the wheel, and by keys.

const TURN = 0.08, STEEPEST = 1.5; // rad
const DRAG = 0.05; // a key's, in parts of the picture's height
const WORDS_OF_CAMERA_KEYS = "Arrow keys turn, plus and minus come nearer and go away, 0 goes back";

function makeOrbit(camera) {
  const offset = subtract(camera.eye, camera.target);
  const start = {
    distance: length(offset),
    yaw: Math.atan2(offset[1], offset[0]),
    pitch: Math.asin(offset[2] / (length(offset) || 1)),
    target: camera.target,
  };
  return {
    ...start,
    moved: 0, // when it last moved, ms
    reset() { Object.assign(this, start); this.touch(); },
    touch() { this.moved = performance.now(); },
    turn(yaw, pitch) {
      this.yaw += yaw;
      this.pitch = Math.max(-STEEPEST, Math.min(STEEPEST, this.pitch + pitch));
      this.touch();
    },
    approach(factor) {
      this.distance = Math.max(start.distance / 200, Math.min(start.distance * 20, this.distance * factor));
      this.touch();
    },
    eye() {
      const flat = Math.cos(this.pitch);
      return add(this.target, scaled(this.distance, [flat * Math.cos(this.yaw), flat * Math.sin(this.yaw), Math.sin(this.pitch)]));
    },
    // right, up: parts of the picture's height; the way of a point at the target, m
    way(right, up) {
      const view = lookAt(this.eye(), this.target, [0, 0, 1]);
      const metres = 2 * this.distance * Math.tan(camera.field_of_view / 2);
      return add(scaled(right * metres, [view[0], view[4], view[8]]), scaled(up * metres, [view[1], view[5], view[9]]));
    },
    shift(right, up) {
      this.target = subtract(this.target, this.way(right, up));
      this.touch();
    },
    // rad, of the height: a narrow picture shows as much as a wide one.
    fieldOfView(aspect) {
      return 2 * Math.atan(Math.tan(camera.field_of_view / 2) * Math.max(1, camera.aspect / aspect));
    },
    matrix(aspect) {
      const view = lookAt(this.eye(), this.target, [0, 0, 1]);
      return product(perspective(this.fieldOfView(aspect), aspect, this.distance / 100, this.distance * 50), view);
    },
  };
}

// `orbit.drag`, if it is there, takes a drag by parts of the picture's height, and returns true if the camera
// stays.
function followPointers(canvas, orbit) {
  const down = new Map();
  const spread = () => {
    const [a, b] = [...down.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  for (const name of ["pointerup", "pointercancel"])
    canvas.addEventListener(name, (event) => down.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const last = down.get(event.pointerId);
    if (!last) return;
    const dx = (event.clientX - last.x) / canvas.clientHeight, dy = (event.clientY - last.y) / canvas.clientHeight;
    const before = down.size === 2 ? spread() : 0;
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (down.size === 2) {
      orbit.approach(before / (spread() || 1));
      orbit.shift(dx / 2, -dy / 2);
    } else if (orbit.drag?.(dx, -dy)) {
      return;
    } else if (event.shiftKey || event.buttons === 2) {
      orbit.shift(dx, -dy);
    } else {
      orbit.turn(-4 * dx, 4 * dy);
    }
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    orbit.approach(Math.exp(0.001 * event.deltaY));
  }, { passive: false });
}

// True if the key was the camera's.
function turnByKey(key, orbit) {
  const way = { ArrowLeft: [-DRAG, 0], ArrowRight: [DRAG, 0], ArrowUp: [0, DRAG], ArrowDown: [0, -DRAG] }[key];
  if (way && orbit.drag?.(...way)) return true;
  const turns = {
    ArrowLeft: () => orbit.turn(-TURN, 0), ArrowRight: () => orbit.turn(TURN, 0),
    ArrowUp: () => orbit.turn(0, TURN), ArrowDown: () => orbit.turn(0, -TURN),
    "+": () => orbit.approach(0.9), "=": () => orbit.approach(0.9), "-": () => orbit.approach(1 / 0.9),
    0: () => orbit.reset(),
  };
  if (!turns[key]) return false;
  turns[key]();
  return true;
}
