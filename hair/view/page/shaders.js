// The shader programs. Ribbons come in screen coordinates (ribbons.js).

const HEAD = "#version 300 es\nprecision highp float;\n";

const RIBBONS = {
  vertex: HEAD + `
layout(location = 0) in vec3 corner;
layout(location = 1) in vec4 paint;
out vec4 colour;
void main() {
  colour = paint;
  gl_Position = vec4(corner, 1.0);
}`,
  fragment: HEAD + `
in vec4 colour;
out vec4 pixel;
void main() { pixel = colour; }`,
};

// Balls, rods and capsules: a sphere whose halves are drawn apart.
const RODS = {
  vertex: HEAD + `
layout(location = 0) in vec3 direction;
uniform mat4 camera;
uniform vec3 a, b;
uniform float radius;
out vec3 place, normal;
void main() {
  vec3 axis = length(b - a) > 0.0 ? normalize(b - a) : vec3(0.0, 0.0, 1.0);
  vec3 x = normalize(abs(axis.z) < 0.9 ? cross(axis, vec3(0.0, 0.0, 1.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
  vec3 turned = x * direction.x + cross(axis, x) * direction.y + axis * direction.z;
  normal = turned;
  place = (direction.z < 0.0 ? a : b) + radius * turned;
  gl_Position = camera * vec4(place, 1.0);
}`,
  fragment: HEAD + `
uniform vec3 paint, eye;
in vec3 place, normal;
out vec4 pixel;
void main() {
  float bright = abs(dot(normalize(normal), normalize(eye - place)));
  pixel = vec4(paint * (0.45 + 0.55 * bright), 1.0);
}`,
};

// Cloth; and solids, which `pose` turns.
const SURFACES = {
  vertex: HEAD + `
layout(location = 0) in vec3 point;
uniform mat4 camera, pose;
out vec3 place;
void main() {
  place = (pose * vec4(point, 1.0)).xyz;
  gl_Position = camera * vec4(place, 1.0);
}`,
  // Each triangle has one brightness, by its direction.
  fragment: HEAD + `
uniform vec3 paint, eye;
in vec3 place;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  float bright = abs(dot(normal, normalize(eye - place)));
  pixel = vec4(paint * (0.45 + 0.55 * bright), 1.0);
}`,
};

// The ground and walls: a grid that fades.
const PLANES = {
  vertex: HEAD + `
layout(location = 0) in vec2 corner;
uniform mat4 camera;
uniform vec3 middle, along, across;
uniform float reach;
out vec2 place;
void main() {
  place = corner * 8.0;
  gl_Position = camera * vec4(middle + reach * (corner.x * along + corner.y * across), 1.0);
}`,
  fragment: HEAD + `
in vec2 place;
out vec4 pixel;
void main() {
  vec2 lines = abs(fract(place - 0.5) - 0.5) / fwidth(place);
  float grid = 1.0 - min(min(lines.x, lines.y), 1.0), far = length(place) / 8.0;
  pixel = vec4(0.5, 0.5, 0.5, (0.12 + 0.4 * grid) * max(0.0, 1.0 - far));
}`,
};

// Throws an Error with the driver's message.
function makeProgram(gl, sources) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, sources.vertex], [gl.FRAGMENT_SHADER, sources.fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
  const at = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
  for (let i = 0; i < count; ++i) {
    const name = gl.getActiveUniform(program, i).name;
    at[name] = gl.getUniformLocation(program, name);
  }
  return { program, at };
}
