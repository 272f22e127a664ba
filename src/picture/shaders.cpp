#include "picture/shaders.h"

namespace lamella::picture {

namespace {

constexpr const char* version = "#version 430 core\n";

// Camera of camera.h; `window` maps the picture's [-1, 1] to that of the tile being drawn.
constexpr const char* projection = R"glsl(
uniform mat3 axes;
uniform vec3 eye;
uniform vec4 lens;      // x and y scale, x and y shift
uniform vec2 depths;    // nearest, farthest
uniform float parallel;

vec3 seen_from_eye(vec3 p) { return axes * p - eye; }

vec4 project(vec3 v) {
  float n = depths.x;
  float f = depths.y;
  if (parallel > 0.5) return vec4(lens.xy * v.xy + lens.zw, (-2.0 * v.z - (f + n)) / (f - n), 1.0);
  float w = -v.z;
  return vec4(lens.xy * v.xy + lens.zw * w, ((f + n) * w - 2.0 * f * n) / (f - n), w);
}

// From a point towards the viewer.
vec3 to_viewer(vec3 v) { return parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : -normalize(v); }
)glsl";

// What surrounds the scene, in the viewer's directions: right, up, towards the viewer.
constexpr const char* studio = R"glsl(
uniform vec3 above;
uniform vec3 level;
uniform vec3 below;

const vec3 key_light = normalize(vec3(-0.55, 0.62, 0.56));
const vec3 fill_light = normalize(vec3(0.85, 0.10, 0.52));
const vec3 rear_light = normalize(vec3(0.42, 0.86, -0.26));

// A bright rectangle with soft edges in direction `at`, seen in direction r: its half width and height, and how far
// its edges fade, as tangents.
float soft_box(vec3 r, vec3 at, vec2 size, float softness) {
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), at));
  vec3 up = cross(at, right);
  vec2 place = abs(vec2(dot(r, right), dot(r, up)));
  vec2 inside = clamp(((size + softness) * dot(r, at) - place) * (0.5 / softness), 0.0, 1.0);
  inside *= inside * (3.0 - 2.0 * inside);
  return inside.x * inside.y;
}

vec3 surroundings(vec3 r) {
  vec3 low = mix(below, level, smoothstep(-0.85, 0.15, r.y));
  return mix(low, above, smoothstep(-0.05, 0.95, r.y));
}

float lamps(vec3 r) {
  return 1.3 * soft_box(r, key_light, vec2(0.17, 0.24), 0.06) +
         0.4 * soft_box(r, fill_light, vec2(0.07, 0.42), 0.06) +
         0.8 * soft_box(r, rear_light, vec2(0.45, 0.09), 0.08);
}
)glsl";

constexpr const char* film_vertex = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float bend;
layout(location = 3) in float thickness;
layout(location = 4) in vec4 vertex_tint;
out vec3 place;
out float curvature;
out vec3 facing;
out float nanometres;
out vec4 own_tint;

void main() {
  place = seen_from_eye(position);
  facing = axes * normal;
  curvature = bend;
  nanometres = thickness;
  own_tint = vertex_tint;
  gl_Position = project(place);
}
)glsl";

constexpr const char* film_fragment = R"glsl(
layout(early_fragment_tests) in;

in vec3 place;
in vec3 facing;
in float nanometres;
in float curvature;
in vec4 own_tint;

struct Tint {
  vec4 front;   // colour, strength
  vec4 behind;
};

layout(std430, binding = 0) buffer Lists { uint first[]; };
layout(std430, binding = 1) buffer Counter { uint used; };
layout(std430, binding = 2) buffer Fragments { uvec4 fragments[]; };
layout(std430, binding = 3) readonly buffer Tints { Tint tints[]; };

uniform uint row_length;
uniform uint capacity;
uniform uint first_triangle;
uniform float tinted;
uniform vec3 background;

uniform float opacity;
uniform float grazing;
uniform float falloff;
uniform float iridescence;
uniform sampler2D interference;  // by thickness and cosine
uniform float most_thick;
uniform float faceted;
uniform float vertex_tinted;
uniform float highlights;
uniform float tint_opacity;
uniform float haze;

uint pack(vec3 v) {
  uvec3 q = uvec3(clamp(v, 0.0, 1.0) * 1023.0 + 0.5);
  return q.x | (q.y << 10) | (q.z << 20);
}

void main() {
  vec3 viewer = to_viewer(place);
  vec3 direction = faceted > 0.5 ? cross(dFdx(place), dFdy(place)) : facing;
  vec3 n = dot(direction, direction) > 0.0 ? normalize(direction) : viewer;  // degenerate facets have no normal
  // A lamp in a flat film would whiten the whole of it; highlights belong to what is curved.
  float shine = highlights * mix(0.15, 1.0, smoothstep(0.05, 0.5, curvature));
  float cosine = dot(n, viewer);
  if (cosine < 0.0) n = -n;
  cosine = min(abs(cosine), 1.0);
  vec3 r = reflect(-viewer, n);

  float mirror = mix(opacity, grazing, pow(1.0 - cosine, falloff));
  vec3 hue = vec3(1.0);
  if (iridescence > 0.0) {
    hue = mix(hue, textureLod(interference, vec2(nanometres / most_thick, cosine), 0.0).rgb, iridescence);
  }
  vec3 clear = vec3(1.0 - mirror);
  vec3 glow = mirror * hue * surroundings(r);
  vec3 sparkle = shine * (0.22 + 0.6 * mirror) * mix(vec3(1.0), hue, 0.5) * lamps(r);

  if (tinted + vertex_tinted > 0.5) {
    vec4 tint = own_tint;
    if (tinted > 0.5) {
      Tint facet = tints[first_triangle + uint(gl_PrimitiveID)];
      tint = gl_FrontFacing ? facet.front : facet.behind;
    }
    float cover = tint_opacity * tint.w;
    float lit = 0.62 + 0.38 * max(dot(n, key_light), 0.0);
    glow = mix(glow, glow * tint.rgb, 0.6 * tint.w) + cover * lit * clear * tint.rgb;
    clear *= (1.0 - cover) * mix(vec3(1.0), tint.rgb, 0.5 * tint.w);
  }
  glow += sparkle;
  float depth = -place.z;
  float far = haze * clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  glow = mix(glow, background * (1.0 - clear), far);

  uint slot = atomicAdd(used, 1u);
  if (slot < capacity) {
    uint pixel = uint(gl_FragCoord.y) * row_length + uint(gl_FragCoord.x);
    uint next = atomicExchange(first[pixel], slot);
    fragments[slot] = uvec4(floatBitsToUint(depth), next, pack(sqrt(glow * 0.25)), pack(clear));
  }
}
)glsl";

constexpr const char* mask_vertex = R"glsl(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)glsl";

constexpr const char* mask_fragment = R"glsl(
uniform usampler2D wanted;

void main() {
  if (texelFetch(wanted, ivec2(gl_FragCoord.xy), 0).r != 0u) discard;
  gl_FragDepth = 0.0;
}
)glsl";

constexpr const char* tube_vertex = R"glsl(
layout(location = 0) in vec4 from_radius;
layout(location = 1) in vec4 to_gloss;
layout(location = 2) in vec3 colour;
out vec3 place;
flat out vec3 from;
flat out vec3 to;
flat out float radius;
flat out vec3 paint;
flat out float gloss;

// The rectangle stands before the tube, across the line of sight to the tube's middle: whatever lies behind it
// is seen nearer to that line, hence inside.
void main() {
  from = seen_from_eye(from_radius.xyz);
  to = seen_from_eye(to_gloss.xyz);
  radius = from_radius.w;
  paint = colour;
  gloss = to_gloss.w;

  vec3 middle = 0.5 * (from + to);
  vec3 ahead = -to_viewer(middle);
  vec3 half_length = to - middle;
  vec3 side = cross(half_length, ahead);
  if (dot(side, side) < 1e-14) side = cross(abs(ahead.y) < 0.7 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), ahead);
  side = normalize(side);
  vec3 along = cross(ahead, side);
  float reach = abs(dot(half_length, along)) + radius;
  float nearer = abs(dot(half_length, ahead)) + radius;
  float s = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float u = (gl_VertexID & 2) == 0 ? -1.0 : 1.0;
  place = middle - nearer * ahead + u * reach * along + s * radius * side;
  gl_Position = project(place);
  gl_Position.z = 0.0;  // the rectangle may stand before the nearest depth; the shape sets its own
}
)glsl";

constexpr const char* tube_fragment = R"glsl(
in vec3 place;
flat in vec3 from;
flat in vec3 to;
flat in float radius;
flat in vec3 paint;
flat in float gloss;
layout(location = 0) out vec4 light;

uniform vec3 background;
uniform float haze;

// The nearest hit of a ray with a ball, or -1.
float hit_ball(vec3 origin, vec3 ray, vec3 centre) {
  vec3 o = origin - centre;
  float b = dot(o, ray);
  float h = b * b - dot(o, o) + radius * radius;
  return h >= 0.0 ? -b - sqrt(h) : -1e30;
}

// The hit with the tube between its ends, and how far along it lies in y (0 to 1); x < -1e29 for none.
vec2 hit_side(vec3 origin, vec3 ray) {
  vec3 d = to - from;
  float dd = dot(d, d);
  if (dd < 1e-14) return vec2(-1e30, 0.0);
  vec3 o = origin - from;
  float rd = dot(ray, d);
  float od = dot(o, d);
  float a = dd - rd * rd;
  float b = dd * dot(o, ray) - od * rd;
  float c = dd * dot(o, o) - od * od - radius * radius * dd;
  float h = b * b - a * c;
  if (h < 0.0 || a < 1e-14) return vec2(-1e30, 0.0);
  float t = (-b - sqrt(h)) / a;
  float y = (od + t * rd) / dd;
  return y > 0.0 && y < 1.0 ? vec2(t, y) : vec2(-1e30, 0.0);
}

void main() {
  // Rays start on the rectangle, near the tube, to keep the precision of floats.
  vec3 ray = -to_viewer(place);
  vec2 side = hit_side(place, ray);
  float t = side.x;
  vec3 axis_point = mix(from, to, side.y);
  if (t < -1e29) {
    float first = hit_ball(place, ray, from);
    float second = hit_ball(place, ray, to);
    bool is_first = second < -1e29 || (first > -1e29 && first < second);
    t = is_first ? first : second;
    axis_point = is_first ? from : to;
  }
  if (t < -1e29) discard;
  vec3 v = place + t * ray;
  vec3 n = normalize(v - axis_point);

  float lit = 0.5 * max(dot(n, key_light), 0.0) + 0.16 * max(dot(n, fill_light), 0.0);
  vec3 ambient = surroundings(n);
  vec3 r = reflect(ray, n);
  float mirror = 0.05 + 0.55 * pow(1.0 - clamp(-dot(ray, n), 0.0, 1.0), 4.0);
  vec3 shine = mix(vec3(1.0), paint / max(max(paint.r, paint.g), max(paint.b, 0.05)), 0.5);
  vec3 shade = paint * (0.75 * ambient + 1.1 * lit) + gloss * shine * (mirror * surroundings(r) + 0.4 * lamps(r));
  float depth = -v.z;
  float far = haze * clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  light = vec4(mix(shade, background, far), 1.0);
  vec4 clip = project(v);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}
)glsl";

}  // namespace

ShaderPair film_shaders() {
  return {std::string(version) + projection + film_vertex,
          std::string(version) + projection + studio + film_fragment};
}

ShaderPair mask_shaders() {
  return {std::string(version) + mask_vertex, std::string(version) + mask_fragment};
}

ShaderPair tube_shaders() {
  return {std::string(version) + projection + tube_vertex,
          std::string(version) + projection + studio + tube_fragment};
}

}  // namespace lamella::picture
