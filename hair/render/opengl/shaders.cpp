#include "hair/render/opengl/shaders.h"

namespace hair {
namespace {

// Rasterisers round corners to their own grid, of 1/256 of a sample if they have one. All of them treat
// corners on this grid alike.
const std::string kOnGrid = R"(
uniform vec2 grid;  // steps in half the picture's width and height
vec4 on_grid(vec4 clip) {
  if (clip.w > 0.0) clip.xy = round(clip.xy / clip.w * grid) / grid * clip.w;
  return clip;
}
)";

// A strand's point becomes two vertices, half a width to either side, across the direction of view; in the
// last fifth the width falls. It is never less than half a sample, so that thin hair does not break up.
// seen_from is the eye, or the direction to the light with a 0.
const std::string kRibbonVertex = kOnGrid + R"(
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 tangent;
layout(location = 2) in vec2 along_tone;
uniform mat4 to_clip;
uniform vec4 seen_from;
uniform float half_width, half_sample;
out vec3 place, direction;
out vec3 along_tone_side;
void main() {
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 to_eye = seen_from.xyz - seen_from.w * at;
  vec3 across = cross(tangent, to_eye);
  float size = length(across);
  across = size > 0.0 ? across / size : vec3(1, 0, 0);
  float least = half_sample * (seen_from.w == 0.0 ? 1.0 : max(-at.z, 0.0));
  float width = half_width * min(5.0 * (1.0 - along_tone.x), 1.0);
  place = at + side * max(width, least) * across;
  direction = tangent;
  along_tone_side = vec3(along_tone, side);
  gl_Position = on_grid(to_clip * vec4(place, 1));
}
)";

// The part of the key light that passes. Hair: deep opacity maps, C. Yuksel and J. Keyser, "Deep Opacity
// Maps", Computer Graphics Forum 27(2), 2008: strands are counted in layers that begin where the light first
// meets hair, so that layers follow the hair's shape. Between layers, and between a map's texels, the count
// is interpolated. All other objects: a depth map.
const std::string kShadow = R"(
uniform mat4 to_light;
uniform float opacity;    // one strand's, in a texel that it meets
uniform vec4 layers;      // the ends of the layers, in the map's depth
uniform float bias, skip, away;  // against shadows on oneself: in depth, and along the normal
uniform sampler2D hair_depth, hair_count, solid_depth;
bool outside(vec2 map) {
  return any(lessThan(map, vec2(0.0))) || any(greaterThan(map, vec2(1.0)));
}
#ifdef HAIR_SHADOWS
float hairs_at(ivec2 texel, float depth) {
  texel = clamp(texel, ivec2(0), textureSize(hair_depth, 0) - 1);
  float behind = depth - skip - texelFetch(hair_depth, texel, 0).r;
  if (behind <= 0.0) return 0.0;
  vec4 count = texelFetch(hair_count, texel, 0), begin = vec4(0.0, layers.xyz);
  return dot(count - vec4(0.0, count.xyz), clamp((behind - begin) / (layers - begin), 0.0, 1.0));
}
#endif
float hairs_before(vec3 at) {
#ifdef HAIR_SHADOWS
  vec3 map = 0.5 + 0.5 * (to_light * vec4(at, 1)).xyz;
  if (outside(map.xy)) return 0.0;
  vec2 texels = map.xy * vec2(textureSize(hair_depth, 0)) - 0.5;
  ivec2 i = ivec2(floor(texels));
  vec2 f = fract(texels);
  return opacity * mix(mix(hairs_at(i, map.z), hairs_at(i + ivec2(1, 0), map.z), f.x),
                       mix(hairs_at(i + ivec2(0, 1), map.z), hairs_at(i + ivec2(1, 1), map.z), f.x), f.y);
#else
  return 0.0;
#endif
}
float past_solids(vec3 at) {
#ifdef SOLID_SHADOWS
  vec3 map = 0.5 + 0.5 * (to_light * vec4(at, 1)).xyz;
  if (outside(map.xy)) return 1.0;
  ivec2 last = textureSize(solid_depth, 0) - 1;
  vec2 texels = map.xy * vec2(last + 1);
  ivec2 i = ivec2(floor(texels));
  vec2 f = fract(texels);
  vec3 weights_x = vec3(1.0 - f.x, 1.0, f.x), weights_y = vec3(1.0 - f.y, 1.0, f.y);
  float lit = 0.0;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      ivec2 texel = clamp(i + ivec2(x, y) - 1, ivec2(0), last);
      if (texelFetch(solid_depth, texel, 0).r > map.z - bias) lit += weights_x[x] * weights_y[y];
    }
  }
  return lit / 4.0;
#else
  return 1.0;
#endif
}
)";

// J. T. Kajiya and T. L. Kay, "Rendering Fur with Three Dimensional Textures", SIGGRAPH 1989: a strand's
// reflection depends only on its direction. Two highlights, one shifted to the root and white, one to the tip
// and of the hair's colour, as found by S. R. Marschner et al., "Light Scattering from Human Hair Fibers"
// (SIGGRAPH 2003).
const std::string kRibbonFragment = R"(
in vec3 place, direction;
in vec3 along_tone_side;
uniform vec3 key_light, up, root_colour, tip_colour;
out vec4 colour;
float lobe(vec3 tangent, vec3 towards, vec3 half_way, float shift, float sharpness) {
  float cosine = dot(normalize(tangent + shift * towards), half_way);
  return pow(max(1.0 - cosine * cosine, 0.0), 0.5 * sharpness);
}
float diffuse(vec3 tangent, vec3 light) {
  float cosine = dot(tangent, light);
  return sqrt(max(1.0 - cosine * cosine, 0.0));
}
void main() {
  vec3 t = normalize(direction), eye = normalize(-place);
  float along = along_tone_side.x, tone = along_tone_side.y, side = along_tone_side.z;
  vec3 towards = normalize(eye - dot(eye, t) * t);
  vec3 own = mix(root_colour, tip_colour, along) * (1.0 + 0.3 * tone);
  float hairs = hairs_before(place);
  vec3 key = past_solids(place) * exp(-0.6 * hairs * vec3(0.85, 1.0, 1.15));
  float open = 0.3 + 0.7 * exp(-0.25 * hairs);
  float sky = 0.65 + 0.35 * dot(towards, up);
  vec3 half_way = normalize(key_light + eye);
  vec3 fill = normalize(vec3(0.8, 0.15, 0.5));
  vec3 body = own * (0.75 * key * diffuse(t, key_light) + open * (0.15 * diffuse(t, fill) + 0.35 * sky));
  vec3 shine = key * (0.22 * lobe(t, towards, half_way, -0.10 + 0.04 * tone, 90.0) +
                      1.1 * own * lobe(t, towards, half_way, 0.14 + 0.06 * tone, 20.0));
  colour = vec4(min((body + shine) * (1.0 - 0.3 * side * side), 1.0), 1);
}
)";

const std::string kMeshVertex = kOnGrid + R"(
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 paint;
uniform mat4 to_clip;
out vec3 place, facing;
out vec4 own;
void main() {
  place = at;
  facing = normal;
  own = paint;
  gl_Position = on_grid(to_clip * vec4(at, 1));
}
)";

// Both sides are visible. Ground fades away from the camera's target.
const std::string kMeshFragment = R"(
in vec3 place, facing;
in vec4 own;
uniform vec3 key_light, up;
out vec4 colour;
void main() {
  vec3 eye = normalize(-place), n = normalize(facing);
  n = dot(n, eye) < 0.0 ? -n : n;
  float hairs = hairs_before(place);
  float key = past_solids(place + away * n) * exp(-0.9 * hairs) * max((dot(n, key_light) + 0.1) / 1.1, 0.0);
  float sky = 0.6 + 0.4 * dot(n, up);
  float fill = max(dot(n, normalize(vec3(0.8, 0.15, 0.5))), 0.0);
  float shine = pow(max(dot(n, normalize(key_light + eye)), 0.0), 30.0);
  float open = 0.6 + 0.4 * exp(-0.3 * hairs);
  vec3 light = own.rgb * (0.95 * key + open * (0.42 * sky + 0.15 * fill)) + (1.0 - own.a) * 0.06 * key * shine;
  float there = 1.0 - own.a * smoothstep(0.5, 2.5, length(place - vec3(0, 0, -1)));
  colour = vec4(min(light, 1.0) * there, there);
}
)";

const std::string kNothing = "void main() {}\n";

// Each strand in a texel adds 1 to its layer and to those behind. Sums of small whole numbers are exact, in
// any order.
const std::string kCount = R"(
uniform sampler2D hair_depth;
uniform vec4 layers;
out vec4 count;
void main() {
  float behind = gl_FragCoord.z - texelFetch(hair_depth, ivec2(gl_FragCoord.xy), 0).r;
  count = vec4(lessThanEqual(vec4(behind), vec4(layers.xyz, 2.0)));
}
)";

const std::string kResolveVertex = R"(
void main() {
  gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 4.0 * float(gl_VertexID >> 1) - 1.0, 0, 1);
}
)";

// A pixel is the mean of the samples around its middle, weighted 1 3 3 1 in each direction, in linear light
// and before a background that gets lighter from the top down; then sRGB (IEC 61966-2-1).
const std::string kResolve = R"(
uniform sampler2D samples;
#ifdef FINE_HAIR
uniform sampler2D hair, hair_empty;
#endif
out vec4 pixel;
void main() {
  ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 1, last = textureSize(samples, 0) - 1;
  vec4 weights = vec4(1, 3, 3, 1) / 8.0;
  vec4 sum = vec4(0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      sum += weights[x] * weights[y] * texelFetch(samples, clamp(first + ivec2(x, y), ivec2(0), last), 0);
    }
  }
  float height = 2.0 * gl_FragCoord.y / float(last.y + 1);
  vec3 linear = sum.rgb + (1.0 - sum.a) * mix(vec3(0.72, 0.74, 0.77), vec3(0.36, 0.42, 0.50), height);
#ifdef FINE_HAIR
  vec4 layer = texelFetch(hair, ivec2(gl_FragCoord.xy), 0);
  vec3 background = linear - sum.rgb;
  linear = layer.rgb + layer.a * sum.rgb + texelFetch(hair_empty, ivec2(gl_FragCoord.xy), 0).r * background;
#endif
  vec3 encoded = mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear,
                     vec3(lessThan(linear, vec3(0.0031308))));
  pixel = vec4(encoded, 1);
}
)";

// In the order of Pass.
const ShaderPair kShaders[] = {{kRibbonVertex, kShadow + kRibbonFragment},
                               {kMeshVertex, kShadow + kMeshFragment},
                               {kRibbonVertex, kNothing},
                               {kRibbonVertex, kCount},
                               {kMeshVertex, kNothing},
                               {kResolveVertex, kResolve}};

}  // namespace

const ShaderPair& shaders_of(Pass pass) {
  return kShaders[static_cast<int>(pass)];
}

}  // namespace hair
