// The programs that draw. A ribbon faces the eye, and is never thinner than `thin`.

const HEAD = "#version 300 es\nprecision highp float;\n";

const RIBBONS = {
  vertex: HEAD + `
layout(location = 0) in vec3 a0; // a segment's ends, in this frame
layout(location = 1) in vec3 b0;
layout(location = 2) in vec3 a1; // and in the next one
layout(location = 3) in vec3 b1;
layout(location = 4) in vec4 colourA; // its last number: 0 at a strand's tip, where no segment begins; else its strand's share
layout(location = 5) in vec4 colourB;
uniform mat4 camera;
uniform vec3 low, size;
uniform vec2 half_picture; // pixels
uniform float between, width, thin, focal, least; // m and pixels are halves of a ribbon's
out vec3 colour;
void main() {
  vec3 a = low + size * mix(a0, a1, between), b = low + size * mix(b0, b1, between);
  vec4 p = camera * vec4(a, 1.0), q = camera * vec4(b, 1.0);
  if (colourA.a < least || p.w <= 0.0 || q.w <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 way = (q.xy / q.w - p.xy / p.w) * half_picture;
  float way_length = length(way);
  vec2 across = way_length > 1e-6 ? vec2(-way.y, way.x) / way_length : vec2(1.0, 0.0);
  bool at_b = gl_VertexID > 1;
  vec4 end = at_b ? q : p;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  end.xy += side * max(thin, width * focal / end.w) * across / half_picture * end.w;
  gl_Position = end;
  float along = dot(normalize(b - a + 1e-12), vec3(0.48, -0.6, 0.64)); // light that falls along a hair is not seen
  colour = (at_b ? colourB.rgb : colourA.rgb) * (0.55 + 0.45 * sqrt(max(0.0, 1.0 - along * along)));
}`,
  fragment: HEAD + `
in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1.0); }`,
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

// Cloth, of two frames; and solids, which are turned by `pose`.
const SURFACES = {
  vertex: HEAD + `
layout(location = 0) in vec3 now;
layout(location = 2) in vec3 next;
uniform mat4 camera, pose;
uniform vec3 low, size;
uniform float between;
out vec3 place;
void main() {
  place = (pose * vec4(low + size * mix(now, next, between), 1.0)).xyz;
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

// Throws an Error with what the driver says.
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
