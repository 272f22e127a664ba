#include "picture/page_text.h"

namespace lamella::picture {

namespace {

constexpr std::string_view text = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@title@</title>
<style>
  html, body { margin: 0; height: 100%; overflow: hidden; font: 14px/1.5 sans-serif; color: #1d242b; }
  canvas { width: 100%; height: 100%; display: block; touch-action: none; cursor: grab; }
  #panel { position: fixed; top: 12px; left: 12px; padding: 8px 12px; border-radius: 6px; background: #ffffffc8; }
  #panel label { display: block; }
  #legend span { display: inline-block; width: 0.9em; height: 0.9em; margin-right: 0.4em; border-radius: 2px; }
  #scale { display: none; width: 180px; margin-top: 6px; }
  #bar { height: 12px; border-radius: 2px; }
  #ends { display: flex; justify-content: space-between; }
  #player { position: fixed; bottom: 14px; left: 12px; right: 12px; display: none; gap: 10px; align-items: center; }
  #player input { flex: 1; }
  #message { position: fixed; top: 45%; width: 100%; text-align: center; }
</style>
</head>
<body>
<canvas id="canvas"></canvas>
<div id="panel">
  <label><input type="checkbox" id="films" checked> films</label>
  <label><input type="checkbox" id="lines" checked> borders and wires</label>
  <label><input type="checkbox" id="coloured"> colours of bodies</label>
  <div id="legend"></div>
  <div id="scale"><div>@field_title@</div><div id="bar"></div><div id="ends"><span></span><span></span></div></div>
</div>
<div id="player"><button id="play">play</button><input type="range" id="frame" min="0" value="0"><span id="time"></span></div>
<div id="message"></div>
<script>
"use strict";
const camera = @camera@;
const style = @style@;
const interference = @interference@;
const field = @field@;
const rate = @rate@;
const frames = @frames@;
)html"
                                  R"html(
function bytes(text) { return Uint8Array.from(atob(text), c => c.charCodeAt(0)); }
function floats(text) { return new Float32Array(bytes(text).buffer); }
const byId = id => document.getElementById(id);

// What a frame does not say is as in the one before.
for (let i = 1; i < frames.length; ++i) frames[i] = Object.assign({}, frames[i - 1], frames[i]);
for (const f of frames) {
  f.positions = floats(f.positions);
  f.normals = floats(f.normals);
  f.thickness = floats(f.thickness);
  f.regions = Float32Array.from(new Uint16Array(bytes(f.regions).buffer));
  f.tints = floats(f.tints);
  f.triangles = new Uint32Array(bytes(f.triangles).buffer);
  f.lines = floats(f.lines);
  if (f.tints.length === 0) f.tints = new Float32Array(f.positions.length / 3 * 4);
}

const canvas = byId("canvas");
const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
if (!gl) byId("message").textContent = "This page needs WebGL 2.";

const common = `#version 300 es
precision highp float;
uniform mat3 axes;
uniform vec3 eye;
uniform vec2 lens;
vec3 seen(vec3 p) { return axes * p - eye; }
vec4 project(vec3 v) { float w = -v.z; return vec4(lens * v.xy, w - 0.02, w); }
`;
const filmVertex = common + `
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float thickness;
layout(location = 3) in vec2 regions;
layout(location = 4) in vec4 tint;
out vec3 place; out vec3 facing; out float thick; flat out vec2 sides; out vec4 paint;
void main() {
  place = seen(position); facing = axes * normal; thick = thickness; sides = regions; paint = tint;
  gl_Position = project(place);
}`;
const filmFragment = common + `
in vec3 place; in vec3 facing; in float thick; flat in vec2 sides; in vec4 paint;
uniform sampler2D table;
uniform vec3 above, level, below;
uniform vec4 film;        // opacity, grazing, falloff, iridescence
uniform float mostThick, tintOpacity, coloured;
uniform vec3 bodies[64];
uniform float shown[64];
out vec4 light;
vec3 around(vec3 r) {
  return mix(mix(below, level, smoothstep(-0.85, 0.15, r.y)), above, smoothstep(-0.05, 0.95, r.y));
}
float lamp(vec3 r, vec3 at) { return smoothstep(0.965, 0.985, dot(r, normalize(at))); }
vec3 root(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)); }
void main() {
  int front = int(sides.x), behind = int(sides.y);
  bool seenFront = front > 0 && front < 64 && shown[front] > 0.5;
  bool seenBehind = behind > 0 && behind < 64 && shown[behind] > 0.5;
  if ((front > 0 || behind > 0) && !seenFront && !seenBehind) discard;
  vec3 viewer = -normalize(place);
  vec3 n = dot(facing, facing) > 0.0 ? normalize(facing) : viewer;
  bool fromFront = dot(n, viewer) >= 0.0;
  if (!fromFront) n = -n;
  float cosine = min(dot(n, viewer), 1.0);
  float mirror = mix(film.x, film.y, pow(1.0 - cosine, film.z));
  vec3 hue = mix(vec3(1.0), texture(table, vec2(thick / mostThick, cosine)).rgb * 3.0, film.w);
  vec3 r = reflect(-viewer, n);
  vec3 glow = mirror * hue * around(r) + 0.35 * (lamp(r, vec3(-0.55, 0.62, 0.56)) + 0.5 * lamp(r, vec3(0.8, 0.1, 0.55)));
  float clear = 1.0 - mirror;
  vec4 tint = paint;
  if (coloured > 0.5) {
    int near = fromFront ? (behind > 0 ? behind : front) : (front > 0 ? front : behind);
    tint = near > 0 && near < 64 ? vec4(bodies[near], 1.0) : vec4(0.0);
  }
  float cover = max(tintOpacity, coloured > 0.5 ? 0.4 : 0.0) * tint.a;
  glow = mix(glow, glow * tint.rgb, 0.6 * tint.a) + cover * clear * (0.6 + 0.4 * n.y) * tint.rgb;
  clear *= 1.0 - cover;
  // Blending works on what the screen shows: the film's own colour there, as far as it covers.
  float covers = clamp(1.0 - clear, 0.02, 1.0);
  light = vec4(root(glow / covers) * covers, covers);
}`;
)html"
                                  R"html(
const lineVertex = common + `
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float radius;
layout(location = 3) in vec3 colour;
out vec3 paint; out float across;
void main() {
  vec3 a = seen(from), b = seen(to);
  vec3 side = cross(b - a, a + b);
  side = dot(side, side) > 1e-12 ? normalize(side) : vec3(1.0, 0.0, 0.0);
  float s = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 along = dot(b - a, b - a) > 1e-12 ? normalize(b - a) : vec3(0.0, 1.0, 0.0);
  vec3 end = (gl_VertexID & 2) == 0 ? a - radius * along : b + radius * along;
  across = s; paint = colour;
  gl_Position = project(end + s * radius * side);
}`;
const lineFragment = common + `
in vec3 paint; in float across;
out vec4 light;
void main() { light = vec4(pow(paint * (1.15 - 0.7 * across * across), vec3(1.0 / 2.2)), 1.0); }`;

function program(vertex, fragment) {
  const result = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(result, shader);
  }
  gl.linkProgram(result);
  if (!gl.getProgramParameter(result, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(result));
  const places = new Map();
  return { id: result, at: name => {
    if (!places.has(name)) places.set(name, gl.getUniformLocation(result, name));
    return places.get(name);
  } };
}
const films = program(filmVertex, filmFragment);
const lines = program(lineVertex, lineFragment);

function attribute(location, data, numbers) {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(location);
  gl.vertexAttribPointer(location, numbers, gl.FLOAT, false, 0, 0);
}
function upload(f) {
  f.filmArray = gl.createVertexArray();
  gl.bindVertexArray(f.filmArray);
  attribute(0, f.positions, 3);
  attribute(1, f.normals, 3);
  attribute(2, f.thickness, 1);
  attribute(3, f.regions, 2);
  attribute(4, f.tints, 4);
  f.order = gl.createBuffer();
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, f.order);
  f.sorted = new Uint32Array(f.triangles.length);
  f.lineArray = gl.createVertexArray();
  gl.bindVertexArray(f.lineArray);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, f.lines, gl.STATIC_DRAW);
  for (const [location, numbers, offset] of [[0, 3, 0], [1, 3, 12], [2, 1, 24], [3, 3, 28]]) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, numbers, gl.FLOAT, false, 40, offset);
    gl.vertexAttribDivisor(location, 1);
  }
  gl.bindVertexArray(null);
}

const texture = gl.createTexture();
gl.bindTexture(gl.TEXTURE_2D, texture);
gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, interference.width, interference.height, 0, gl.RGBA, gl.UNSIGNED_BYTE,
              bytes(interference.bytes));
for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
                             [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
  gl.texParameteri(gl.TEXTURE_2D, name, value);

let axes = camera.axes.slice();
let eye = camera.eye.slice();
let now = 0;
const shown = new Float32Array(64).fill(1);

// Rotates about the picture's right, up and forward directions.
function turn(right, up) {
  const rotate = (i, j, angle) => {
    const c = Math.cos(angle), s = Math.sin(angle);
    for (let k = 0; k < 3; ++k) {
      const a = axes[3 * i + k], b = axes[3 * j + k];
      axes[3 * i + k] = c * a + s * b;
      axes[3 * j + k] = c * b - s * a;
    }
  };
  rotate(0, 2, right);
  rotate(1, 2, up);
}

// Films are blended from the farthest to the nearest: a counting sort by depth.
const buckets = new Uint32Array(65537);
function sort(f) {
  const count = f.triangles.length / 3;
  const depths = new Float32Array(count);
  let low = Infinity, high = -Infinity;
  for (let t = 0; t < count; ++t) {
    let sum = 0;
    for (let k = 0; k < 3; ++k) {
      const v = 3 * f.triangles[3 * t + k];
      sum += axes[6] * f.positions[v] + axes[7] * f.positions[v + 1] + axes[8] * f.positions[v + 2];
    }
    depths[t] = sum;
    low = Math.min(low, sum);
    high = Math.max(high, sum);
  }
  const scale = 65535 / Math.max(high - low, 1e-9);
  buckets.fill(0);
  for (let t = 0; t < count; ++t) ++buckets[1 + Math.floor((depths[t] - low) * scale)];
  for (let i = 1; i < 65537; ++i) buckets[i] += buckets[i - 1];
  for (let t = 0; t < count; ++t) {
    const at = 3 * buckets[Math.floor((depths[t] - low) * scale)]++;
    for (let k = 0; k < 3; ++k) f.sorted[at + k] = f.triangles[3 * t + k];
  }
  gl.bindVertexArray(f.filmArray);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, f.order);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, f.sorted, gl.DYNAMIC_DRAW);
}
)html"
                                  R"html(
function look(p) {
  gl.useProgram(p.id);
  gl.uniformMatrix3fv(p.at("axes"), true, axes);
  gl.uniform3fv(p.at("eye"), eye);
  const aspect = canvas.width / canvas.height;
  const y = 1 / camera.slope * Math.min(1, aspect * 0.75 + 0.25);
  gl.uniform2f(p.at("lens"), y / aspect, y);
}
const toScreen = c => "rgb(" + c.map(x => Math.round(255 * Math.pow(x, 1 / 2.2))).join(",") + ")";

function draw() {
  const f = frames[now];
  if (!f.filmArray) upload(f);
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  if (byId("lines").checked && f.lines.length > 0) {
    look(lines);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    gl.bindVertexArray(f.lineArray);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, f.lines.length / 10);
  }
  if (byId("films").checked && f.triangles.length > 0) {
    sort(f);
    look(films);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    for (const name of ["above", "level", "below"]) gl.uniform3fv(films.at(name), style[name]);
    gl.uniform4f(films.at("film"), style.opacity, style.grazing, style.falloff, style.iridescence);
    gl.uniform1f(films.at("mostThick"), interference.mostThick);
    gl.uniform1f(films.at("tintOpacity"), style.tintOpacity);
    gl.uniform1f(films.at("coloured"), byId("coloured").checked ? 1 : 0);
    const colours = new Float32Array(192);
    style.bodies.slice(0, 63).forEach((c, b) => colours.set(c, 3 * (b + 1)));
    gl.uniform3fv(films.at("bodies"), colours);
    gl.uniform1fv(films.at("shown"), shown);
    gl.drawElements(gl.TRIANGLES, f.sorted.length, gl.UNSIGNED_INT, 0);
    gl.depthMask(true);
  }
  byId("time").textContent = frames.length > 1 ? "time " + f.time.toPrecision(4) : "";
}
let waiting = false;
function redraw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; draw(); });
}

const pointers = new Map();
canvas.addEventListener("pointerdown", e => {
  canvas.setPointerCapture(e.pointerId);
  pointers.set(e.pointerId, [e.clientX, e.clientY]);
});
canvas.addEventListener("pointermove", e => {
  const last = pointers.get(e.pointerId);
  if (!last) return;
  const dx = (e.clientX - last[0]) / canvas.clientHeight, dy = (e.clientY - last[1]) / canvas.clientHeight;
  pointers.set(e.pointerId, [e.clientX, e.clientY]);
  if (e.shiftKey || pointers.size > 1) {
    eye[0] -= 2 * dx * camera.slope * eye[2];
    eye[1] += 2 * dy * camera.slope * eye[2];
  } else {
    turn(4 * dx, -4 * dy);
  }
  redraw();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => pointers.delete(e.pointerId));
canvas.addEventListener("wheel", e => {
  e.preventDefault();
  eye[2] *= Math.exp(0.0012 * e.deltaY);
  redraw();
}, { passive: false });
canvas.addEventListener("dblclick", () => { axes = camera.axes.slice(); eye = camera.eye.slice(); redraw(); });
window.addEventListener("resize", redraw);
for (const id of ["films", "lines", "coloured"]) byId(id).addEventListener("change", redraw);

byId("coloured").checked = style.byRegion;
style.bodies.slice(0, 63).forEach((c, b) => {
  const label = document.createElement("label");
  const box = document.createElement("input");
  const patch = document.createElement("span");
  box.type = "checkbox";
  box.checked = true;
  box.addEventListener("change", () => { shown[b + 1] = box.checked ? 1 : 0; redraw(); });
  patch.style.background = toScreen(c);
  label.append(box, patch, "body " + (b + 1));
  byId("legend").append(label);
});

if (field) {
  byId("scale").style.display = "block";
  byId("bar").style.background = "linear-gradient(to right," + field.colours.map(toScreen).join(",") + ")";
  byId("ends").children[0].textContent = Number(field.low.toPrecision(4));
  byId("ends").children[1].textContent = Number(field.high.toPrecision(4));
}
if (frames.length > 1) {
  byId("player").style.display = "flex";
  byId("frame").max = frames.length - 1;
  const show = i => { now = i; byId("frame").value = i; redraw(); };
  byId("frame").addEventListener("input", () => show(Number(byId("frame").value)));
  const asked = parseInt(location.hash.slice(1));  // page.html#12 begins at frame 12
  if (asked >= 0 && asked < frames.length) show(asked);
  let timer = 0;
  byId("play").addEventListener("click", () => {
    byId("play").textContent = timer ? "play" : "stop";
    if (timer) { clearInterval(timer); timer = 0; return; }
    timer = setInterval(() => show((now + 1) % frames.length), 1000 / rate);
  });
}
canvas.style.background = "linear-gradient(" + toScreen(style.top) + "," + toScreen(style.bottom) + ")";
draw();
document.title += " ";  // a sign that the first picture stands
</script>
</body>
</html>
)html";

}  // namespace

std::string_view page_text() {
  return text;
}

}  // namespace lamella::picture
