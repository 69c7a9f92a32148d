// Draws motions with WebGL2: strands as ribbons, and all other objects.

const POINTS_OF_POSE = 4;
const SMOOTH_STRANDS = 100; // with software rendering, more strands get edges without smoothing

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

// Data of one run on the graphics card.
function uploadMotion(gl, motion) {
  const { triangles, share } = ribbonTriangles(motion.starts), ribbons = makeRibbons(motion.starts);
  return {
    motion,
    ribbons,
    count: triangles.length,
    share, // the part of `count` for one share of the strands
    corners: makeBuffer(gl, gl.ARRAY_BUFFER, ribbons.bytes, gl.DYNAMIC_DRAW),
    triangles: makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, triangles),
    colourBytes: new Uint8Array(4 * motion.points),
    coloured: "",
    sheets: motion.sheets.map((sheet) => {
      const triangles = sheetTriangles(sheet.rows, sheet.columns), points = sheet.rows * sheet.columns;
      return {
        ...sheet, points, count: triangles.length,
        vertices: makeBuffer(gl, gl.ARRAY_BUFFER, new Float32Array(3 * points), gl.DYNAMIC_DRAW),
        triangles: makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, triangles),
      };
    }),
    meshes: motion.meshes.map((mesh) => ({
      ...mesh,
      count: mesh.triangles.length,
      vertices: makeBuffer(gl, gl.ARRAY_BUFFER, new Float32Array(mesh.points)),
      triangles: makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.triangles)),
    })),
  };
}

// True with software rendering.
function drawnByProgram() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render|software/i.test(name);
}

// Throws an Error if the browser has no WebGL2.
function makeDrawing(canvas, strands) {
  // With software rendering, smooth edges take five times as long.
  const smooth = strands <= SMOOTH_STRANDS || !drawnByProgram();
  const gl = canvas.getContext("webgl2", { antialias: smooth, alpha: false });
  if (!gl) throw new Error("no WebGL2");
  const programs = { ribbons: makeProgram(gl, RIBBONS), rods: makeProgram(gl, RODS), surfaces: makeProgram(gl, SURFACES), planes: makeProgram(gl, PLANES) };
  const sphere = sphereMesh();
  const directions = makeBuffer(gl, gl.ARRAY_BUFFER, sphere.directions);
  const sphereTriangles = makeBuffer(gl, gl.ELEMENT_ARRAY_BUFFER, sphere.triangles);
  const corners = makeBuffer(gl, gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));

  const use = (program) => { gl.useProgram(program.program); return program.at; };
  const attribute = (location, buffer, count, kind, stride, offset) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, kind, true, stride, offset);
  };
  const noAttributes = () => { for (let i = 0; i < 2; ++i) gl.disableVertexAttribArray(i); };
  const place = (places, index) => places.subarray(3 * index, 3 * index + 3);

  // Transparent things hide nothing behind them.
  const beginGlass = () => {
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
  };
  const endGlass = () => {
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  };

  const ribbons = (held, scene, places, few) => {
    if (held.count === 0) return;
    const { motion } = held, focal = canvas.height / 2 / Math.tan(scene.fieldOfView / 2);
    const many = motion.strands.length > SMOOTH_STRANDS, thin = (many ? 0.5 : 1) * scene.pixels, wide = (focal * motion.width) / 2;
    // Strands that one stands for. If they are thinner together than a pixel, they are transparent.
    const each = motion.strands_in_all / motion.strands.length;
    const faint = many && each * wide < thin * length(subtract(scene.eye, scene.target));
    const eye = held.coloured.startsWith("own") ? normalized(subtract(scene.eye, scene.target)) : null;
    held.ribbons.lay(places, scene.camera, wide, thin, canvas.width / 2, canvas.height / 2, held.colourBytes, eye, faint ? each : 0);
    use(programs.ribbons);
    if (faint) beginGlass();
    attribute(0, held.corners, 3, gl.FLOAT, BYTES_OF_CORNER, 0);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, held.ribbons.bytes);
    attribute(1, held.corners, 4, gl.UNSIGNED_BYTE, BYTES_OF_CORNER, 12);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, held.triangles);
    gl.drawElements(gl.TRIANGLES, few ? held.share : held.count, gl.UNSIGNED_INT, 0);
    if (faint) endGlass();
    noAttributes();
  };

  const rods = (held, scene, places, paint) => {
    const { motion } = held, at = use(programs.rods);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    gl.uniform3fv(at.eye, scene.eye);
    attribute(0, directions, 3, gl.FLOAT, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, sphereTriangles);
    motion.rods.forEach((rod, i) => {
      gl.uniform3fv(at.a, place(places, motion.first_rod + 2 * i));
      gl.uniform3fv(at.b, place(places, motion.first_rod + 2 * i + 1));
      gl.uniform1f(at.radius, rod.radius);
      gl.uniform3fv(at.paint, paint || rod.colour);
      gl.drawElements(gl.TRIANGLES, sphere.triangles.length, gl.UNSIGNED_SHORT, 0);
    });
    noAttributes();
  };

  const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  const surfaces = (held, scene, places) => {
    const at = use(programs.surfaces);
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    gl.uniform3fv(at.eye, scene.eye);
    gl.uniformMatrix4fv(at.pose, false, IDENTITY);
    for (const sheet of held.sheets) {
      attribute(0, sheet.vertices, 3, gl.FLOAT, 0, 0);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, places.subarray(3 * sheet.first, 3 * (sheet.first + sheet.points)));
      gl.uniform3fv(at.paint, sheet.colour);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, sheet.triangles);
      gl.drawElements(gl.TRIANGLES, sheet.count, gl.UNSIGNED_INT, 0);
    }
    for (const mesh of held.meshes) {
      const [origin, ...ends] = Array.from({ length: POINTS_OF_POSE }, (_, i) => place(places, mesh.first + i));
      const axes = ends.map((end) => scaled(1 / mesh.reach, subtract(end, origin)));
      gl.uniformMatrix4fv(at.pose, false, new Float32Array([...axes[0], 0, ...axes[1], 0, ...axes[2], 0, ...origin, 1]));
      gl.uniform3fv(at.paint, mesh.colour);
      attribute(0, mesh.vertices, 3, gl.FLOAT, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles);
      gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
    }
    noAttributes();
  };

  const planes = (held, scene, k) => {
    const { motion } = held, at = use(programs.planes);
    beginGlass();
    gl.uniformMatrix4fv(at.camera, false, scene.camera);
    attribute(0, corners, 2, gl.FLOAT, 0, 0);
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
    endGlass();
  };

  const pixel = new Uint8Array(4);
  return {
    upload: (motion) => uploadMotion(gl, motion),
    wait: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel), // until all is drawn
    // scene: camera, eye, target, fieldOfView, pixels (of the screen for one of the page), background; runs:
    // held, k, between, and `tint`, which names the colours, writes them, and may have one for all rods. few:
    // of many strands a share is drawn
    draw(scene, runs, few) {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(...scene.background, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      for (const { held, k, between, tint } of runs) {
        recolour(held, tint); // it asks for other places
        const places = held.motion.places(k, between);
        surfaces(held, scene, places);
        rods(held, scene, places, tint.rods);
        ribbons(held, scene, places, few);
      }
      for (const { held, k } of runs) planes(held, scene, k);
    },
  };
}
