// Draws motions with WebGL2: strands as ribbons, and what is around them. Positions go to the card as they are in the file, a frame and
// the next one; the card finds what is between.

const BYTES_OF_POINT = 6, POINTS_OF_POSE = 4;

function sphereMesh() {
  const around = 20, half = 8, down = 2 * half + 1, directions = [], triangles = [];
  for (let row = 0; row <= down; ++row)
    for (let column = 0; column <= around; ++column) {
      // Both halves have a rim at the equator, where a rod's sides begin.
      const lower = row > half, theta = (Math.PI / 2) * ((lower ? row - 1 : row) / half), phi = (2 * Math.PI * column) / around;
      const z = lower ? Math.min(Math.cos(theta), -1e-6) : Math.max(Math.cos(theta), 0);
      directions.push(Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), z);
    }
  for (let row = 0; row < down; ++row)
    for (let column = 0; column < around; ++column) {
      const i = row * (around + 1) + column, j = i + around + 1;
      triangles.push(i, j, i + 1, i + 1, j, j + 1);
    }
  return { directions: new Float32Array(directions), triangles: new Uint16Array(triangles) };
}

function sheetTriangles(rows, columns) {
  const triangles = [];
  for (let row = 0; row + 1 < rows; ++row)
    for (let column = 0; column + 1 < columns; ++column) {
      const i = row * columns + column;
      triangles.push(i, i + columns, i + 1, i + 1, i + columns, i + columns + 1);
    }
  return new Uint32Array(triangles);
}

function makeBuffer(gl, kind, data, usage) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(kind, buffer);
  gl.bufferData(kind, data, usage || gl.STATIC_DRAW);
  return buffer;
}

// The card holds this of one run.
function uploadMotion(gl, motion) {
  const bytes = motion.points * BYTES_OF_POINT, strandPoints = motion.strands.reduce((sum, size) => sum + size, 0);
  return {
    motion,
    strandPoints,
    now: makeBuffer(gl, gl.ARRAY_BUFFER, bytes + BYTES_OF_POINT, gl.DYNAMIC_DRAW),
    next: makeBuffer(gl, gl.ARRAY_BUFFER, bytes + BYTES_OF_POINT, gl.DYNAMIC_DRAW),
    colours: makeBuffer(gl, gl.ARRAY_BUFFER, 4 * (strandPoints + 1), gl.DYNAMIC_DRAW),
    colourBytes: new Uint8Array(4 * (strandPoints + 1)),
    inBuffers: [-1, -1], // frames
    coloured: "",
    sheets: motion.sheets.map((sheet) => {
      const triangles = sheetTriangles(sheet.rows, sheet.columns);
      return { ...sheet, count: triangles.length, triangles: makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, triangles) };
    }),
    meshes: motion.meshes.map((mesh) => ({
      ...mesh,
      count: mesh.triangles.length,
      vertices: makeBuffer(gl, gl.ARRAY_BUFFER, new Float32Array(mesh.points)),
      triangles: makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.triangles)),
    })),
  };
}

// Throws an Error where the browser has no WebGL2.
function makeDrawing(canvas) {
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
  if (!gl) throw new Error("no WebGL2");
  const programs = { ribbons: makeProgram(gl, RIBBONS), rods: makeProgram(gl, RODS), surfaces: makeProgram(gl, SURFACES), planes: makeProgram(gl, PLANES) };
  const sphere = sphereMesh();
  const directions = makeBuffer(gl, gl.ARRAY_BUFFER, sphere.directions);
  const sphereTriangles = makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, sphere.triangles);
  const corners = makeBuffer(gl, gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));

  const use = (program) => { gl.useProgram(program.program); return program.at; };
  const attribute = (location, buffer, count, kind, normalized, stride, offset, divisor) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, kind, normalized, stride, offset);
    gl.vertexAttribDivisor(location, divisor);
  };
  const noAttributes = () => { for (let i = 0; i < 6; ++i) gl.disableVertexAttribArray(i); };

  const fill = (held, k) => {
    const { motion } = held, frames = [k, Math.min(k + 1, motion.frames - 1)];
    if (held.inBuffers[1] === frames[0] && held.inBuffers[0] !== frames[0]) {
      [held.now, held.next] = [held.next, held.now];
      held.inBuffers = [held.inBuffers[1], held.inBuffers[0]];
    }
    [held.now, held.next].forEach((buffer, i) => {
      if (held.inBuffers[i] === frames[i]) return;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, motion.frame(frames[i]));
      held.inBuffers[i] = frames[i];
    });
  };

  const ribbons = (held, scene, between, few) => {
    const { motion } = held, at = use(programs.ribbons);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    gl.uniform3fv(at.low, motion.low);
    gl.uniform3fv(at.size, motion.size);
    gl.uniform2f(at.half_picture, canvas.width / 2, canvas.height / 2);
    gl.uniform1f(at.between, between);
    gl.uniform1f(at.width, motion.width / 2);
    gl.uniform1f(at.thin, (motion.strands.length > 300 ? 0.5 : 1) * scene.pixels);
    gl.uniform1f(at.focal, (canvas.height / 2) / Math.tan(scene.fieldOfView / 2));
    gl.uniform1f(at.least, (few ? SHARES - 0.5 : 0.5) / SHARES);
    if (held.strandPoints > 1) {
      attribute(0, held.now, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, 0, 1);
      attribute(1, held.now, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, BYTES_OF_POINT, 1);
      attribute(2, held.next, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, 0, 1);
      attribute(3, held.next, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, BYTES_OF_POINT, 1);
      attribute(4, held.colours, 4, gl.UNSIGNED_BYTE, true, 4, 0, 1);
      attribute(5, held.colours, 4, gl.UNSIGNED_BYTE, true, 4, 4, 1);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, held.strandPoints - 1);
    }
    noAttributes();
  };

  const rods = (held, scene, k, between) => {
    const { motion } = held, at = use(programs.rods);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    gl.uniform3fv(at.eye, scene.eye);
    attribute(0, directions, 3, gl.FLOAT, false, 0, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, sphereTriangles);
    motion.rods.forEach((rod, i) => {
      gl.uniform3fv(at.a, motion.point(k, between, motion.first_rod + 2 * i));
      gl.uniform3fv(at.b, motion.point(k, between, motion.first_rod + 2 * i + 1));
      gl.uniform1f(at.radius, rod.radius);
      gl.uniform3fv(at.paint, rod.colour);
      gl.drawElements(gl.TRIANGLES, sphere.triangles.length, gl.UNSIGNED_SHORT, 0);
    });
    noAttributes();
  };

  const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  const surfaces = (held, scene, k, between) => {
    const { motion } = held, at = use(programs.surfaces);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    gl.uniform3fv(at.eye, scene.eye);
    gl.uniformMatrix4fv(at.pose, false, IDENTITY);
    gl.uniform3fv(at.low, motion.low);
    gl.uniform3fv(at.size, motion.size);
    gl.uniform1f(at.between, between);
    for (const sheet of held.sheets) {
      attribute(0, held.now, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, sheet.first * BYTES_OF_POINT, 0);
      attribute(2, held.next, 3, gl.UNSIGNED_SHORT, true, BYTES_OF_POINT, sheet.first * BYTES_OF_POINT, 0);
      gl.uniform3fv(at.paint, sheet.colour);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, sheet.triangles);
      gl.drawElements(gl.TRIANGLES, sheet.count, gl.UNSIGNED_INT, 0);
    }
    gl.uniform3f(at.low, 0, 0, 0);
    gl.uniform3f(at.size, 1, 1, 1);
    gl.uniform1f(at.between, 0);
    for (const mesh of held.meshes) {
      const [origin, ...ends] = Array.from({ length: POINTS_OF_POSE }, (_, i) => motion.point(k, between, mesh.first + i));
      const axes = ends.map((end) => scaled(1 / mesh.reach, subtract(end, origin)));
      gl.uniformMatrix4fv(at.pose, false, new Float32Array([...axes[0], 0, ...axes[1], 0, ...axes[2], 0, ...origin, 1]));
      gl.uniform3fv(at.paint, mesh.colour);
      attribute(0, mesh.vertices, 3, gl.FLOAT, false, 0, 0, 0);
      attribute(2, mesh.vertices, 3, gl.FLOAT, false, 0, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles);
      gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
    }
    noAttributes();
  };

  const planes = (held, scene, k) => {
    const { motion } = held, at = use(programs.planes);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    attribute(0, corners, 2, gl.FLOAT, false, 0, 0, 0);
    for (const plane of motion.planes) {
      const from = plane.points.length > 3 ? 3 * k : 0;
      const point = plane.points.slice(from, from + 3), normal = plane.normals.slice(from, from + 3);
      const middle = subtract(scene.target, scaled(dot(subtract(scene.target, point), normal), normal));
      const along = normalized(Math.abs(normal[2]) < 0.9 ? cross(normal, [0, 0, 1]) : cross(normal, [1, 0, 0]));
      gl.uniform3fv(at.middle, middle);
      gl.uniform3fv(at.along, along);
      gl.uniform3fv(at.across, cross(normal, along));
      gl.uniform1f(at.reach, 2 * length(motion.size));
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    }
    noAttributes();
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  };

  return {
    upload: (motion) => uploadMotion(gl, motion),
    // scene: camera, eye, target, fieldOfView, pixels (of the screen for one of the page), background; runs: held, k, between, and `tint`, which
    // names the colours and writes them. few: of many strands a share is drawn
    draw(scene, runs, few) {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(...scene.background, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      for (const { held, k, between, tint } of runs) {
        fill(held, k);
        if (held.coloured !== tint.name) {
          tint.write(held.colourBytes);
          gl.bindBuffer(gl.ARRAY_BUFFER, held.colours);
          gl.bufferSubData(gl.ARRAY_BUFFER, 0, held.colourBytes);
          held.coloured = tint.name;
        }
        surfaces(held, scene, k, between);
        rods(held, scene, k, between);
        ribbons(held, scene, between, few);
      }
      for (const { held, k } of runs) planes(held, scene, k);
    },
  };
}
