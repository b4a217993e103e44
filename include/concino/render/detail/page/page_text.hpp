// The page of save_html, assembled from page/ by scripts/assemble_page.sh: change it there.
#pragma once

#include <array>
#include <string_view>

namespace concino::detail {

// clang-format off
/// The parts before the title, between title and data, and after the data.
inline constexpr std::string_view page_start = R"page(
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>)page";
inline constexpr std::string_view page_middle = R"page(</title>
<style>
:root { --paper: #ffffff; --ink: #1a1b1f; --soft: #5c5f68; --line: #d4d6dc; --box: #f6f7f9; --accent: #1c62b9; --veil: #ffffffc0; color-scheme: light; }
:root[data-theme="dark"] { --paper: #17181c; --ink: #eceef2; --soft: #a4a8b3; --line: #3b3e47; --box: #22242a; --accent: #7db4ff; --veil: #17181cc0;
color-scheme: dark; }
* { box-sizing: border-box; }
html, body { margin: 0; height: 100%; overflow: hidden; background: var(--paper); color: var(--ink);
font: 14px/1.4 system-ui, "DejaVu Sans", sans-serif; }
main { position: absolute; inset: 0 300px 0 0; }
body.closed main { right: 0; }
#view { width: 100%; height: 100%; display: block; touch-action: none; outline: none; cursor: grab; }
#view:focus-visible { box-shadow: inset 0 0 0 2px var(--accent); }
#marks, #texts { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; overflow: hidden; }
#marks .mark { fill: #ff3b30; fill-opacity: 0.35; stroke: #ff3b30; stroke-width: 2.5; stroke-linejoin: round; }
#marks .measure { stroke: var(--accent); stroke-width: 2; stroke-dasharray: 6 4; fill: none; }
#texts span { position: absolute; padding: 0 4px; border-radius: 3px; background: var(--paper); opacity: 0.88; white-space: nowrap;
unicode-bidi: isolate; max-width: 60%; overflow: hidden; text-overflow: ellipsis; }
#title { position: absolute; top: 10px; left: 14px; margin: 0; font-size: 18px; font-weight: 600; max-width: calc(100% - 28px);
overflow: hidden; text-overflow: ellipsis; white-space: nowrap; pointer-events: none; unicode-bidi: isolate; }
#message { position: absolute; left: 14px; bottom: 10px; margin: 0; color: var(--soft); max-width: calc(100% - 28px); pointer-events: none; }
#legend { position: absolute; left: 14px; top: 46px; margin: 0; display: grid; grid-template-columns: auto 1fr; gap: 6px; pointer-events: none; }
#legend[hidden] { display: none; }
#legend figcaption, #legend ul, #legend p { grid-column: 1 / -1; margin: 0; max-width: 40vw; overflow: hidden; text-overflow: ellipsis;
white-space: nowrap; unicode-bidi: isolate; }
#legend canvas { width: 16px; height: 200px; border: 1px solid var(--line); }
#legend .ticks { position: relative; height: 200px; min-width: 64px; }
#legend .ticks span { position: absolute; transform: translateY(-50%); white-space: nowrap; }
#legend .ticks span::before { content: ""; display: inline-block; width: 5px; height: 1px; margin-right: 4px; background: var(--ink);
vertical-align: middle; }
#legend ul { list-style: none; padding: 0; max-height: 50vh; }
#legend li i, #legend p i { display: inline-block; width: 12px; height: 12px; margin-right: 6px; vertical-align: -1px; }
#legend, #title:not(:empty), #message:not(:empty) { background: var(--veil); box-shadow: 0 0 0 5px var(--veil); border-radius: 2px; }
#toggle { position: absolute; top: 10px; right: 14px; z-index: 2; }
#panel { position: absolute; top: 0; right: 0; bottom: 0; width: 300px; padding: 0 14px 14px; overflow: auto; background: var(--box);
border-left: 1px solid var(--line); border-top: 48px solid var(--box); }
#panel[hidden] { display: none; }
#panel details { border-top: 1px solid var(--line); padding: 6px 0; }
#panel summary { font-weight: 600; cursor: pointer; padding: 2px 0; }
#panel fieldset { border: 1px solid var(--line); border-radius: 6px; margin: 6px 0; padding: 6px 8px; min-width: 0; }
#panel legend { padding: 0 4px; max-width: 100%; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; unicode-bidi: isolate; }
.row { display: flex; align-items: center; gap: 8px; margin: 4px 0; flex-wrap: wrap; }
.row > label:only-child { flex: 1; }
label { display: inline-flex; align-items: center; gap: 6px; }
.row input[type="range"] { flex: 1; min-width: 60px; width: 90px; }
.row select, .row input[type="text"] { flex: 1; min-width: 0; }
input, select, button { font: inherit; color: var(--ink); }
input[type="number"], input[type="text"], select { background: var(--paper); border: 1px solid var(--line); border-radius: 4px; padding: 2px 4px; }
input[type="number"] { width: 74px; appearance: textfield; }
input[type="number"]::-webkit-inner-spin-button { display: none; }
.fitted { flex-wrap: nowrap; }
.fitted input[type="number"] { flex: 1; min-width: 0; }
input[type="color"] { width: 32px; height: 24px; padding: 0; border: 1px solid var(--line); background: none; }
button { background: var(--paper); border: 1px solid var(--line); border-radius: 4px; padding: 3px 7px; cursor: pointer; }
button:hover { border-color: var(--accent); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
.soft { color: var(--soft); }
dl { display: grid; grid-template-columns: auto 1fr; gap: 2px 8px; margin: 6px 0; }
dt { color: var(--soft); unicode-bidi: isolate; overflow-wrap: anywhere; }
dd { margin: 0; overflow-wrap: anywhere; unicode-bidi: isolate; font-variant-numeric: tabular-nums; }
@media (max-width: 700px) {
#panel { top: auto; left: 0; width: auto; height: 45%; padding: 10px 14px; border-left: 0; border-top: 1px solid var(--line); }
main { inset: 0 0 45% 0; }
body.closed main { bottom: 0; }
#title, #message { max-width: calc(100% - 120px); }
#legend canvas, #legend .ticks { height: 130px; }
}
</style>
</head>
<body>
<main>
<canvas id="view" tabindex="0" aria-label="The scene in three dimensions. Arrow keys rotate it, plus and minus zoom, keys 1 to 6 look along the axes, P switches between perspective and orthographic, R resets, H lists all keys."></canvas>
<svg id="marks" aria-hidden="true"></svg>
<div id="texts" aria-hidden="true"></div>
<h1 id="title" dir="auto"></h1>
<figure id="legend" hidden></figure>
<p id="message" role="status" aria-live="polite"></p>
<noscript><p>This page draws its scene by a script. Allow scripts for it to see the scene.</p></noscript>
</main>
<button id="toggle" aria-controls="panel" aria-expanded="true" title="Show or hide the controls (C)">Controls</button>
<aside id="panel" aria-label="Controls"></aside>
)page";
inline constexpr std::array page_end = {
std::string_view(R"page(<script>
(() => {
"use strict";
const shaders = { surface_vert: `#version 300 es
in vec3 position;
uniform mat4 project;
uniform mat3 turn;
#ifdef PLACE
out vec3 place;
#endif
#ifdef SMOOTH
in vec3 normal;
out vec3 direction;
#endif
#ifdef BITS
in uint flags;
flat out uint bits;
#endif
#ifdef VALUES
in float value;
out float number;
#endif
#ifdef PAINT
in vec4 paint;
out vec4 painted;
#endif
#ifdef EDGES
out vec3 inside;
#endif
#ifdef SIDES
in vec3 sides;
flat out vec3 side_numbers;
#endif
#ifdef TEXTURE
in vec2 texture_place;
out vec2 uv;
#endif
#ifdef PICK
flat out int triangle;
#endif
void main() {
gl_Position = project * vec4(position, 1.0);
#ifdef PLACE
place = position;
#endif
#ifdef SMOOTH
direction = turn * normal;
#endif
#ifdef BITS
bits = flags;
#endif
#ifdef VALUES
number = value;
#endif
#ifdef PAINT
painted = paint;
#endif
#ifdef EDGES
int corner = gl_VertexID % 3;
inside = vec3(corner == 0, corner == 1, corner == 2);
#endif
#ifdef SIDES
side_numbers = sides;
#endif
#ifdef TEXTURE
uv = texture_place;
#endif
#ifdef PICK
triangle = gl_VertexID / 3;
#endif
}
`, surface_frag: `#version 300 es
precision highp float;
precision highp int;
uniform mat3 turn;
uniform bool parallel;
uniform vec3 eye;
out vec4 result;
#ifdef PLACE
in vec3 place;
#endif
#ifdef BITS
flat in uint bits;
#endif
#ifdef CUTS
uniform vec4 planes[4];
uniform int cuts;
float distance_to_cut() {
float nearest = 1e9;
for (int k = 0; k < 4; ++k) {
float gap = planes[k].w - dot(planes[k].xyz, place), step = fwidth(gap);
if ((cuts >> k & 1) == 0) continue;
if (gap <= 0.0) discard;
nearest = min(nearest, gap / max(step, 1e-9));
}
return nearest;
}
#endif
#ifdef PICK
flat in int triangle;
uniform int picking;
void main() {
#ifdef CUTS
distance_to_cut();
#endif
result = vec4(float(picking), float(triangle & 255), float(triangle >> 8 & 255), float(triangle >> 16 & 255)) / 255.0;
}
#else
uniform vec3 color, exposed_color, no_value, edge_color;
uniform float opacity, shine;
uniform sampler2D map;
vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 screen(vec3 c) {
vec3 a = sqrt(clamp(c, 0.0, 1.0)), b = sqrt(a);
return clamp(0.585122381 * a + 0.783140355 * b - 0.368262736 * sqrt(b), 0.0, 1.0);
}
float line_at(float x, float width) {
float w = max(fwidth(x), 1e-6);
return clamp(width * 0.5 + 0.5 - abs(fract(x) - 0.5) / w, 0.0, 1.0);
}
#if defined(VALUES) || defined(SIDES)
uniform vec2 knots[18];
uniform int num_knots;
uniform bool are_labels;
float position_of(float x) {
if (num_knots == 2) return mix(knots[0].y, knots[1].y, clamp((x - knots[0].x) / (knots[1].x - knots[0].x), 0.0, 1.0));
float t = knots[0].y;
for (int i = 0; i + 1 < num_knots; ++i) {
vec2 a = knots[i], b = knots[i + 1];
if (x >= a.x) t = b.x > a.x ? mix(a.y, b.y, clamp((x - a.x) / (b.x - a.x), 0.0, 1.0)) : mix(a.y, b.y, 0.5);
}
return t;
}
vec3 color_of(float x) {
if (abs(x) > 1e30) return no_value;
if (are_labels) return texelFetch(map, ivec2(int(mod(floor(x + 0.5), 256.0)), 0), 0).rgb;
return texture(map, vec2((position_of(x) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
#endif
#ifdef VALUES
in float number;
#ifdef LINES
uniform float bands, lines;
uniform vec2 band_widths;
vec3 color_of_surface() {
vec3 c = color_of(number);
float t = position_of(number), x = t * bands, w = max(fwidth(x), 1e-6), line = line_at(t * lines, 1.5);
if (abs(number) > 1e30) return c;
if (bands > 0.0) c = mix(c, vec3(1.0), clamp((min(band_widths.x, band_widths.y * w) - abs(fract(x) - 0.5)) / w + 0.5, 0.0, 1.0));
return lines > 0.0 ? mix(c, edge_color, line) : c;
}
#else
vec3 color_of_surface() { return color_of(number); }
#endif
#elif defined(PAINT)
in vec4 painted;
vec3 color_of_surface() { return linear(painted.rgb); }
#else
vec3 color_of_surface() { return (bits & 8u) != 0u ? exposed_color : color; }
#endif
#ifdef TEXTURE
in vec2 uv;
uniform int texture_kind;
uniform vec2 texture_size;
uniform vec3 texture_first, texture_second;
uniform sampler2D picture;
float mean_sign(float x) {
float w = max(fwidth(x), 1e-6);
vec2 ends = abs(mod(x + vec2(0.5, -0.5) * w, 2.0) - 1.0);
return w > 2.0 ? 0.0 : (ends.y - ends.x) / w;
}
vec3 with_texture(vec3 below) {
bool has_no_place = max(abs(uv.x), abs(uv.y)) > 1e30;
if (texture_kind == 3) {
vec4 t = texture(picture, vec2(uv.x, 1.0 - uv.y));
return has_no_place ? no_value : below * (1.0 - t.a) + t.rgb;
}
vec2 x = uv * texture_size.x;
if (texture_kind == 1) {
float share = 0.5 - 0.5 * mean_sign(x.x) * mean_sign(x.y);
below = mix(texture_first, texture_second, share);
} else below = mix(texture_first, below, (1.0 - line_at(x.x + 0.5, texture_size.y)) * (1.0 - line_at(x.y + 0.5, texture_size.y)));
return has_no_place ? no_value : below;
}
#endif
#ifdef SMOOTH
in vec3 direction;
vec3 normal_to_viewer() {
vec3 n = direction * inversesqrt(max(dot(direction, direction), 1e-12));
return gl_FrontFacing ? n : -n;
}
#else
vec3 normal_to_viewer() {
vec3 n = normalize(turn * cross(dFdx(place), dFdy(place)));
return dot(n, parallel ? vec3(0, 0, -1) : turn * (place - eye)) > 0.0 ? -n : n;
}
#endif
#ifdef BALL
uniform sampler2D ball;
vec3 light_at(vec3 n) { return texture(ball, n.xy * vec2(0.49, -0.49) + 0.5).rgb; }
#else
vec3 light_at(vec3 n) {
vec3 to_light = normalize(vec3(-0.55, 0.9, 0.75));
float light = 0.34 + 0.14 * n.y + 0.34 * max(n.z, 0.0) + 0.42 * max(dot(n, to_light), 0.0);
float x = max(dot(n, normalize(to_light + vec3(0, 0, 1))), 0.0), y = x * x * x * x, z = y * y * y;
return vec3(light + shine * 0.10 * z * z * z * y);
}
#endif
#ifdef EDGES
in vec3 inside;
uniform float edge_width;
#ifdef SIDES
flat in vec3 side_numbers;
#endif
void draw_edges(inout vec3 lit, inout float cover) {
vec3 slope = fwidth(inside);
for (int k = 0; k < 3; ++k) {
if ((bits >> k & 1u) == 0u) continue;
int opposite = (k + 2) % 3;
float drawn = clamp(edge_width * 0.5 + 0.5 - inside[opposite] / max(slope[opposite], 1e-9), 0.0, 1.0);
#ifdef SIDES
lit = mix(lit, color_of(side_numbers[k]), drawn);
#else
lit = mix(lit, edge_color, drawn * 0.6);
#endif
cover = max(cover, drawn * 0.6);
}
}
#endif
void main() {
#ifdef CUTS
float to_cut = distance_to_cut();
#endif
vec3 base = color_of_surface();
#ifdef TEXTURE
base = with_texture(base);
#endif
vec3 lit = base * light_at(normal_to_viewer());
float cover = opacity;
#ifdef EDGES
draw_edges(lit, cover);
#endif
#ifdef CUTS
if (to_cut < 3.0) lit = mix(lit, edge_color, clamp(2.0 - to_cut, 0.0, 1.0));
#endif
result = vec4(screen(lit) * cover, cover);
}
#endif
` };
const byId = (id) => document.getElementById(id);
const scene = JSON.parse(byId("scene").textContent);
const arrays = [...document.querySelectorAll("script[data-type]")];
const arrayTypes = { i1: Int8Array, u1: Uint8Array, u2: Uint16Array, u4: Uint32Array, f4: Float32Array, f8: Float64Array };
function numbersOf(k) {
if (k === undefined || k === null) return new Float32Array(0);
const { type, length } = arrays[k].dataset, text = arrays[k].textContent.trim();
const bytes = new Uint8Array(Number(length) * arrayTypes[type].BYTES_PER_ELEMENT);
const piece = 1 << 20;  // characters, a multiple of 4
for (let from = 0, to = 0; from < text.length; from += piece) {
const part = atob(text.slice(from, from + piece));
for (let i = 0; i < part.length; ++i) bytes[to++] = part.charCodeAt(i);
}
arrays[k].textContent = "";
return new arrayTypes[type](bytes.buffer);
}
function readArrays(named) {
const result = {};
for (const [name, k] of Object.entries(named)) result[name] = numbersOf(k);
return result;
}
function textOf(x) {
if (typeof x === "string") return x;
if (Number.isNaN(x)) return "not a number";
if (x === Infinity) return "infinite";
if (x === -Infinity) return "minus infinite";
return String(Number(x.toPrecision(9)));
}
function make(tag, attributes = {}, ...content) {
const e = document.createElement(tag);
for (const [name, value] of Object.entries(attributes)) {
if (name.startsWith("on")) e.addEventListener(name.slice(2), value);
else if (name in e && name !== "list") e[name] = value;
else e.setAttribute(name, value);
}
e.append(...content);
return e;
}
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const n = norm(a); return n > 0 ? scaled(a, 1 / n) : [0, 0, 0]; };
const mix = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
const at3 = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]];
function turned(v, axis, angle) {
const c = Math.cos(angle), s = Math.sin(angle);
return add(add(scaled(v, c), scaled(cross(axis, v), s)), scaled(axis, dot(axis, v) * (1 - c)));
}
const unitCoordinate = (x, k) => (x / 2 - scene.center[k] / 2) / scene.radius * 2;
const toUnit = (p) => [0, 1, 2].map((k) => unitCoordinate(p[k], k));
const toMesh = (p) => [0, 1, 2].map((k) => p[k] * scene.radius + scene.center[k]);
function trianglesOf(points) {
const n = points.length, result = [];
if (n === 3) return [[0, 1, 2]];
let normal = [0, 0, 0];
for (let i = 2; i < n; ++i) normal = add(normal, cross(sub(points[i - 1], points[0]), sub(points[i], points[0])));
const turn = (a, b, c) => dot(normal, cross(sub(points[b], points[a]), sub(points[c], points[a])));
const rest = points.map((_, i) => i);
while (rest.length > 3) {
const ear = rest.findIndex((b, i) => {
const a = rest[(i + rest.length - 1) % rest.length], c = rest[(i + 1) % rest.length];
return turn(a, b, c) > 0 && !rest.some((x) => x !== a && x !== b && x !== c &&
turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0);
});
const i = Math.max(ear, 0), m = rest.length;
result.push([rest[(i + m - 1) % m], rest[i], rest[(i + 1) % m]]);
rest.splice(i, 1);
}
result.push(rest);
return result;
}
const camera = {};
const canvas = byId("view");
const aspect = () => Math.max(canvas.clientWidth, 1) / Math.max(canvas.clientHeight, 1);
const eyeOf = () => add(camera.target, scaled(camera.back, camera.distance));
const halfHeight = () => (camera.parallel ? camera.half : camera.slope * camera.distance);
function orient(back, up) {
camera.back = unit(back);
camera.right = unit(cross(up, camera.back));
if (norm(camera.right) < 0.5) camera.right = unit(cross([camera.back[1], camera.back[2], camera.back[0]], camera.back));
camera.up = cross(camera.back, camera.right);
}
function frameScene(margin = 0.06) {
const high = [-Infinity, -Infinity], low = [Infinity, Infinity];
const steep = (camera.parallel ? 1 : camera.slope) * (1 - margin), slopes = [steep * aspect(), steep];
let nearest = -Infinity;
forEachPoint((p) => {
const z = dot(p, camera.back), depth = camera.parallel ? 0 : z;
nearest = Math.max(nearest, z);
[camera.right, camera.up].forEach((axis, k) => {
const x = dot(p, axis);
high[k] = Math.max(high[k], x + depth * slopes[k]);
low[k] = Math.min(low[k], x - depth * slopes[k]);
});
});
if (!(nearest > -Infinity)) { high.fill(1); low.fill(-1); nearest = 0; }
const radius = Math.max((high[0] - low[0]) / (2 * slopes[0]), (high[1] - low[1]) / (2 * slopes[1]));
const middle = add(scaled(camera.right, (high[0] + low[0]) / 2), scaled(camera.up, (high[1] + low[1]) / 2));
camera.target = middle;
if (camera.parallel) camera.half = radius > 0 ? radius : 1;
camera.distance = camera.parallel ? nearest + 2 : Math.max(radius, nearest + 1e-3);
}
function resetCamera() {
const c = scene.camera;
camera.parallel = c.parallel;
camera.slope = c.parallel ? Math.tan(Math.PI * 25 / 360) : c.half_height;
Object.assign(camera, { back: c.back, right: c.right, up: c.up, distance: 1, target: [0, 0, 0], half: 1 });
if (!c.fixed) return frameScene(c.margin);
const eye = toUnit(c.eye);
camera.distance = Math.max(dot(eye, c.back), 1e-3);
camera.target = sub(eye, scaled(c.back, camera.distance));
)page"),
std::string_view(R"page(if (c.parallel) camera.half = c.half_height / scene.radius;
const narrow = Math.max(1, 4 / 3 / aspect());  // a narrow screen shows no less to the left and right than a picture does
camera.half *= narrow;
camera.slope *= narrow;
}
function lookFrom(back, up) {
orient(back, up);
frameScene();
}
function switchPerspective() {
if (camera.parallel) camera.distance = camera.half / camera.slope;
else camera.half = camera.slope * camera.distance;
camera.parallel = !camera.parallel;
}
const filmPoint = (x, y) => {
const box = canvas.getBoundingClientRect();
return [(x - box.left - box.width / 2) / (box.height / 2), (box.top + box.height / 2 - y) / (box.height / 2)];
};
function rayThrough(x, y) {
const [u, v] = filmPoint(x, y), h = camera.parallel ? camera.half : camera.slope;
const offset = add(scaled(camera.right, u * h), scaled(camera.up, v * h));
return camera.parallel ? { origin: add(eyeOf(), offset), direction: scaled(camera.back, -1) }
: { origin: eyeOf(), direction: unit(sub(offset, camera.back)) };
}
function pixelOf(p) {
const d = sub(p, eyeOf()), away = -dot(d, camera.back);
if (!camera.parallel && away <= 1e-9) return null;
const size = (camera.parallel ? camera.half : camera.slope * away), half = canvas.clientHeight / 2;
return [canvas.clientWidth / 2 + dot(d, camera.right) / size * half, half - dot(d, camera.up) / size * half];
}
function rotate(dx, dy) {
const length = Math.hypot(dx, dy);
if (length === 0) return;
const axis = unit(add(scaled(camera.up, -dx), scaled(camera.right, -dy)));
const angle = length / Math.min(canvas.clientWidth, canvas.clientHeight) * Math.PI;
const eyeBack = turned(camera.back, axis, angle), up = turned(camera.up, axis, angle);
orient(eyeBack, up);
}
function pan(dx, dy) {
const step = 2 * halfHeight() / canvas.clientHeight;
camera.target = add(camera.target, add(scaled(camera.right, -dx * step), scaled(camera.up, dy * step)));
}
function zoom(factor, x, y) {
const [u, v] = filmPoint(x, y), h = halfHeight() * (1 - factor);
camera.target = add(camera.target, add(scaled(camera.right, u * h), scaled(camera.up, v * h)));
camera.distance *= factor;
camera.half *= factor;
}
function projection() {
const reach = scene.reach, eye = eyeOf(), middle = dot(eye, camera.back);
const far = Math.max(middle + reach, 1e-3), near = camera.parallel ? middle - reach : Math.max(middle - reach, far * 1e-4);
const h = camera.parallel ? camera.half : camera.slope, { right: r, up: u, back: b } = camera;
const x = 1 / (h * aspect()), y = 1 / h;
const row = (axis, s) => [axis[0] * s, axis[1] * s, axis[2] * s, -dot(axis, eye) * s];
const rows = [row(r, x), row(u, y)];
const depth = row(b, -1);  // the distance from the eye
if (camera.parallel) rows.push(depth.map((d, k) => 2 / (far - near) * d - (k === 3 ? (far + near) / (far - near) : 0)), [0, 0, 0, 1]);
else rows.push(depth.map((d, k) => (far + near) / (far - near) * d - (k === 3 ? 2 * far * near / (far - near) : 0)), depth);
return [0, 1, 2, 3].flatMap((column) => rows.map((r4) => r4[column]));
}
function viewText() {
const n = [...camera.target, ...camera.back, ...camera.up, camera.distance, camera.half, camera.slope].map((x) => Number(x.toPrecision(7)));
return `view=${n.join(",")},${camera.parallel ? 1 : 0}`;
}
function takeView(text) {
const n = (/view=([^&]*)/.exec(text)?.[1] ?? "").split(",").map(Number);
if (n.length !== 13 || !n.every(Number.isFinite) || !(n[9] > 0 && n[10] > 0 && n[11] > 0)) return false;
Object.assign(camera, { target: n.slice(0, 3), distance: n[9], half: n[10], slope: n[11], parallel: n[12] === 1 });
orient(n.slice(3, 6), n.slice(6, 9));
return true;
}
function inverted(count, starts, items, itemOf = (x) => x) {
const sizes = new Uint32Array(count + 1);
for (let i = 0; i < items.length; ++i) ++sizes[itemOf(items[i]) + 1];
for (let i = 0; i < count; ++i) sizes[i + 1] += sizes[i];
const next = sizes.slice(), lists = new Uint32Array(items.length);
if (!starts) for (let i = 0; i < items.length; ++i) lists[next[itemOf(items[i])]++] = i;
else for (let i = 0; i + 1 < starts.length; ++i) for (let k = starts[i]; k < starts[i + 1]; ++k) lists[next[itemOf(items[k])]++] = i;
return { starts: sizes, items: lists };
}
const listOf = (lists, i) => lists.items.subarray(lists.starts[i], lists.starts[i + 1]);
class Mesh {
constructor(data) {
const a = readArrays(data.arrays);
Object.assign(this, { isVolume: data.volume, crease: data.crease, points: a.points, edges: a.edges, polygonStarts: a.polygon_starts,
corners: a.corners, triangles: a.triangles, centroids: a.centroids, shown: a.shown, laidBare: a.laid_bare });
this.faces = data.volume ? { starts: a.poly_starts, items: a.poly_faces } : null;  // items: 2 * face + (0 if outward)
this.polyCorners = data.volume ? { starts: a.corner_starts, items: a.corner_verts } : { starts: a.polygon_starts, items: a.corners };
this.values = data.values.map((v) => ({ ...v, numbers: v.texts ? null : numbersOf(v.numbers) }));
this.numVerts = this.points.length / 3;
this.numPolygons = this.polygonStarts.length - 1;
this.numPolys = data.volume ? a.poly_starts.length - 1 : this.numPolygons;
this.units = new Float64Array(this.points.length);
for (let i = 0; i < this.points.length; ++i) this.units[i] = unitCoordinate(this.points[i], i % 3);
this.cache = {};
}
point(v) { return at3(this.units, v); }
cornersOf(polygon) { return this.corners.subarray(this.polygonStarts[polygon], this.polygonStarts[polygon + 1]); }
facesOf(poly) { return this.faces ? [...listOf(this.faces, poly)].map((x) => x >> 1) : []; }
once(name, compute) { return (this.cache[name] ??= compute()); }
get edgesOfVert() {
return this.once("edgesOfVert", () => inverted(this.numVerts, Uint32Array.from({ length: this.edges.length / 2 + 1 }, (_, i) => 2 * i),
this.edges));
}
get polygonsOfVert() {
return this.once("polygonsOfVert", () => inverted(this.numVerts, this.polygonStarts, this.corners));
}
get polysOfFace() {
return this.once("polysOfFace", () => inverted(this.numPolygons, this.faces.starts, this.faces.items, (x) => x >> 1));
}
cornerAt(poly, vert) {
const { starts, items } = this.polyCorners, i = starts.length ? items.subarray(starts[poly], starts[poly + 1]).indexOf(vert) : -1;
return i < 0 ? -1 : starts[poly] + i;
}
edgeBetween(a, b) {
for (const e of listOf(this.edgesOfVert, a)) if (this.edges[2 * e] === b || this.edges[2 * e + 1] === b) return e;
return -1;
}
polysOfPolygon(polygon) { return this.isVolume ? [...listOf(this.polysOfFace, polygon)] : [polygon]; }
polysOfVert(v) { return [...new Set([...listOf(this.polygonsOfVert, v)].flatMap((p) => this.polysOfPolygon(p)))]; }
vertsOfPoly(poly) {
return this.isVolume ? [...new Set(this.facesOf(poly).flatMap((f) => [...this.cornersOf(f)]))] : [...this.cornersOf(poly)];
}
edgesOfPolygon(polygon) {
const c = this.cornersOf(polygon);
return [...c].map((v, i) => this.edgeBetween(v, c[(i + 1) % c.length]));
}
polygonsOfEdge(e) {
const a = this.edges[2 * e], b = this.edges[2 * e + 1];
return [...new Set([...listOf(this.polygonsOfVert, a)])].filter((p) => {
const c = this.cornersOf(p), i = c.indexOf(a);
return c[(i + 1) % c.length] === b || c[(i + c.length - 1) % c.length] === b;
});
}
neighboursOf(poly) {
const beside = this.isVolume ? this.facesOf(poly).flatMap((f) => this.polysOfPolygon(f))
: this.edgesOfPolygon(poly).flatMap((e) => this.polygonsOfEdge(e));
return [...new Set(beside)].filter((p) => p !== poly);
}
get layers() {
return this.once("layers", () => {
const far = 0xffffffff, layer = new Uint32Array(this.numPolys).fill(far);
const isOuter = (p) => (this.isVolume ? this.facesOf(p).some((f) => this.polysOfPolygon(f).length === 1)
: this.edgesOfPolygon(p).some((e) => this.polygonsOfEdge(e).length === 1));
let front = [];
for (let p = 0; p < this.numPolys; ++p) if (this.hasPoly(p) && isOuter(p)) { layer[p] = 0; front.push(p); }
for (let k = 1; front.length; ++k) {
const next = [];
for (const p of front) for (const q of this.neighboursOf(p)) if (layer[q] === far) { layer[q] = k; next.push(q); }
front = next;
}
return layer;
});
}
hasPoly(p) {
const starts = this.isVolume ? this.faces.starts : this.polygonStarts;
return starts[p + 1] > starts[p];
}
isAbove(poly, n, offset) {
let below = true, above = true;
const look = (polygon) => {
for (let c = this.polygonStarts[polygon]; c < this.polygonStarts[polygon + 1]; ++c) {
const v = 3 * this.corners[c], x = n[0] * this.points[v] + n[1] * this.points[v + 1] + n[2] * this.points[v + 2];
below &&= x < offset;
above &&= x >= offset;
}
};
if (this.isVolume) for (let i = this.faces.starts[poly]; i < this.faces.starts[poly + 1]; ++i) look(this.faces.items[i] >> 1);
else look(poly);
if (below || above) return above;
return dot(n, at3(this.centroids, poly)) >= offset;
}
visiblePolys(rules) {
const mask = new Uint8Array(this.numPolys);
for (let p = 0; p < this.numPolys; ++p) {
let shown = this.hasPoly(p) && (!this.shown.length || this.shown[p] === 1);
if (shown && rules.layers > 0) shown = this.layers[p] >= rules.layers;
if (shown && rules.values) {
const x = rules.values.numbers[p];
shown = rules.values.labels ? rules.values.labels.has(x) : x >= rules.values.low && x <= rules.values.high;
}
for (const { n, offset } of rules.planes) shown &&= !this.isAbove(p, n, offset);
mask[p] = shown;
}
return mask;
}
visiblePolygons(mask) {
const found = { polygon: [], turned: [], bare: [], poly: [] };
const put = (polygon, turn, bare, poly) => {
found.polygon.push(polygon); found.turned.push(turn); found.bare.push(bare || this.laidBare[polygon] === 1); found.poly.push(poly);
};
if (!this.isVolume) {
for (let p = 0; p < this.numPolys; ++p) if (mask[p]) put(p, false, false, p);
return found;
}
const count = new Uint8Array(this.numPolygons), hidden = new Uint8Array(this.numPolygons), last = new Float64Array(this.numPolygons);
for (let p = 0; p < this.numPolys; ++p)
for (let i = this.faces.starts[p]; i < this.faces.starts[p + 1]; ++i) {
const x = this.faces.items[i], f = x >> 1;
if (mask[p]) { if (count[f] < 2) ++count[f]; last[f] = 2 * p + (x & 1); } else hidden[f] = 1;
}
for (let f = 0; f < this.numPolygons; ++f) if (count[f] === 1) put(f, last[f] % 2 === 1, hidden[f] === 1, Math.floor(last[f] / 2));
return found;
}
}
function crossSections(mesh, mask, n, offset) {
const heights = new Float64Array(mesh.numVerts);
for (let v = 0; v < mesh.numVerts; ++v) heights[v] = dot(n, at3(mesh.points, v)) - offset;
const points = [], sections = [], places = new Map();
const placeOf = (a, b) => {
const low = Math.min(a, b), high = Math.max(a, b), key = low * mesh.numVerts + high;
let i = places.get(key);
if (i === undefined) {
places.set(key, i = points.length);
points.push([low, high, heights[low] / (heights[low] - heights[high])]);
}
return i;
};
const crossed = (poly) => {
let above = false, below = false;
for (let k = mesh.faces.starts[poly]; k < mesh.faces.starts[poly + 1]; ++k) {
const f = mesh.faces.items[k] >> 1;
for (let c = mesh.polygonStarts[f]; c < mesh.polygonStarts[f + 1]; ++c) if (heights[mesh.corners[c]] < 0) below = true; else above = true;
}
return above && below;
};
const position = (i) => mix(mesh.point(points[i][0]), mesh.point(points[i][1]), points[i][2]);
for (let poly = 0; poly < mesh.numPolys; ++poly) {
if (!mask[poly] || !crossed(poly)) continue;
const next = new Map();
for (let k = mesh.faces.starts[poly]; k < mesh.faces.starts[poly + 1]; ++k) {
const x = mesh.faces.items[k], loop = mesh.cornersOf(x >> 1), crossings = [];
for (let i = 0; i < loop.length; ++i) {
const a = loop[i], b = loop[(i + 1) % loop.length];
const up = heights[a] < 0 && heights[b] >= 0, down = heights[a] >= 0 && heights[b] < 0;
if (up || down) crossings.push({ place: placeOf(a, b), up: up === ((x & 1) === 0) });
}
if (crossings.length > 2) {  // a polygon that is not convex: pairs along the line in which the plane meets it
const first = position(crossings[0].place);
let along = [0, 0, 0];
for (const c of crossings) { const d = sub(position(c.place), first); if (norm(d) > norm(along)) along = d; }
crossings.sort((c, d) => dot(along, position(c.place)) - dot(along, position(d.place)));
}
)page"),
std::string_view(R"page(for (let i = 0; i + 1 < crossings.length; i += 2) {
const [c, d] = crossings[i].up ? [crossings[i], crossings[i + 1]] : [crossings[i + 1], crossings[i]];
next.set(c.place, d.place);
}
}
while (next.size) {
const [first] = next.keys(), loop = [];
for (let at = first; at !== undefined && next.has(at); ) {
loop.push(at);
const to = next.get(at);
next.delete(at);
at = to;
}
if (loop.length > 2) sections.push({ poly, loop });
}
}
return { points, sections, position };
}
function areaOf(cut, n) {
let sum = [0, 0, 0];
for (const { loop } of cut.sections) {
const o = cut.position(loop[0]);
for (let i = 2; i < loop.length; ++i) sum = add(sum, cross(sub(cut.position(loop[i - 1]), o), sub(cut.position(loop[i]), o)));
}
return Math.abs(dot(sum, unit(n))) / 2;
}
function preparedPolygons(data) {
const a = readArrays(data.arrays), count = a.starts.length - 1, starts = a.starts;
const triangles = a.triangles.length ? a.triangles : Uint32Array.from({ length: a.corners.length }, (_, i) => i);
return { ...a, triangles, polygonOf: polygonsOfTriangles(starts, triangles), polys: null, elements: null, bare: a.exposed.length ? a.exposed : null, count };
}
function polygonsOfTriangles(starts, triangles) {
const corner = new Uint32Array(starts[starts.length - 1]);
for (let p = 0; p + 1 < starts.length; ++p) corner.fill(p, starts[p], starts[p + 1]);
const result = new Uint32Array(triangles.length / 3);
for (let t = 0; t < result.length; ++t) result[t] = corner[triangles[3 * t]];
return result;
}
function polygonsOfMesh(mesh, mask) {
const seen = mesh.visiblePolygons(mask), count = seen.polygon.length, starts = new Uint32Array(count + 1);
const own = mesh.once("triangles", () => {
if (!mesh.triangles.length) return null;
const of = polygonsOfTriangles(mesh.polygonStarts, mesh.triangles), first = new Uint32Array(mesh.numPolygons + 1);
for (const p of of) ++first[p + 1];
for (let p = 0; p < mesh.numPolygons; ++p) first[p + 1] += first[p];
return first;
});
let numTriangles = 0;
seen.polygon.forEach((p, i) => {
starts[i + 1] = starts[i] + mesh.polygonStarts[p + 1] - mesh.polygonStarts[p];
numTriangles += own ? own[p + 1] - own[p] : 1;
});
const corners = new Uint32Array(starts[count]), triangles = new Uint32Array(3 * numTriangles), polygonOf = new Uint32Array(numTriangles);
let t = 0;
for (let i = 0; i < count; ++i) {
const p = seen.polygon[i], from = mesh.polygonStarts[p], first = starts[i], n = starts[i + 1] - first, turn = seen.turned[i];
for (let k = 0; k < n; ++k) corners[first + (turn ? n - 1 - k : k)] = mesh.corners[from + k];
const put = (a, b, c) => {
polygonOf[t] = i;
triangles.set(turn ? [first + n - 1 - a, first + n - 1 - c, first + n - 1 - b] : [first + a, first + b, first + c], 3 * t++);
};
if (!own) put(0, 1, 2);
else for (let k = own[p]; k < own[p + 1]; ++k) put(mesh.triangles[3 * k] - from, mesh.triangles[3 * k + 1] - from, mesh.triangles[3 * k + 2] - from);
}
const list = { mesh, points: mesh.units, starts, corners, triangles, polygonOf, polys: seen.poly, elements: seen.polygon, bare: seen.bare, count };
list.normals = smoothNormals(list, mesh.crease);
return list;
}
function smoothNormals({ points, starts, corners, count }, crease) {
const own = new Float64Array(3 * count), angles = new Float64Array(corners.length), normals = new Float32Array(3 * corners.length);
for (let p = 0; p < count; ++p) {
const first = starts[p], last = starts[p + 1], o = 3 * corners[first];
let nx = 0, ny = 0, nz = 0;
for (let c = first; c < last; ++c) {
const v = 3 * corners[c], before = 3 * corners[c === first ? last - 1 : c - 1], after = 3 * corners[c + 1 === last ? first : c + 1];
const ax = points[before] - points[v], ay = points[before + 1] - points[v + 1], az = points[before + 2] - points[v + 2];
const bx = points[after] - points[v], by = points[after + 1] - points[v + 1], bz = points[after + 2] - points[v + 2];
const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
angles[c] = Math.atan2(Math.sqrt(x * x + y * y + z * z), ax * bx + ay * by + az * bz);
if (c < first + 2) continue;
const px = points[before] - points[o], py = points[before + 1] - points[o + 1], pz = points[before + 2] - points[o + 2];
const qx = points[v] - points[o], qy = points[v + 1] - points[o + 1], qz = points[v + 2] - points[o + 2];
nx += py * qz - pz * qy; ny += pz * qx - px * qz; nz += px * qy - py * qx;
}
const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
if (length > 0) { own[3 * p] = nx / length; own[3 * p + 1] = ny / length; own[3 * p + 2] = nz / length; }
}
const around = inverted(points.length / 3, null, corners);
const polygon = new Uint32Array(corners.length), cosine = Math.cos(crease * Math.PI / 180);
for (let p = 0; p < count; ++p) polygon.fill(p, starts[p], starts[p + 1]);
for (let c = 0; c < corners.length; ++c) {
const p = 3 * polygon[c], ring = listOf(around, corners[c]);
let x = 0, y = 0, z = 0;
if (ring.length <= 64) for (const d of ring) {
const q = 3 * polygon[d];
if (own[p] * own[q] + own[p + 1] * own[q + 1] + own[p + 2] * own[q + 2] < cosine) continue;
x += own[q] * angles[d]; y += own[q + 1] * angles[d]; z += own[q + 2] * angles[d];
}
const length = Math.sqrt(x * x + y * y + z * z);
const fits = length > 0;
normals[3 * c] = fits ? x / length : own[p];
normals[3 * c + 1] = fits ? y / length : own[p + 1];
normals[3 * c + 2] = fits ? z / length : own[p + 2];
}
return normals;
}
function polygonsOfCut(mesh, cut) {
const count = cut.sections.length, starts = [0], corners = [], triangles = [];
const points = new Float64Array(3 * cut.points.length);
cut.points.forEach((_, i) => points.set(cut.position(i), 3 * i));
for (const { loop } of cut.sections) {
const first = corners.length;
corners.push(...loop);
starts.push(corners.length);
for (const t of trianglesOf(loop.map((i) => at3(points, i)))) triangles.push(...t.map((k) => first + k));
}
const list = { mesh, points, starts: Uint32Array.from(starts), corners: Uint32Array.from(corners), triangles: Uint32Array.from(triangles),
polys: cut.sections.map((s) => s.poly), elements: null, bare: new Array(count).fill(true), between: cut.points, count };
list.polygonOf = polygonsOfTriangles(list.starts, list.triangles);
list.normals = new Float32Array(3 * corners.length);  // flat: the shader takes the plane of the triangle
return list;
}
function polygonsOfArrows(mesh, field, longest) {
const n = field.numbers.length / field.width, starts = [0], corners = [], points = [], polys = [];
let most = 0;
const length = (i) => Math.hypot(...field.numbers.subarray(field.width * i, field.width * i + field.width));
for (let i = 0; i < n; ++i) if (Number.isFinite(length(i))) most = Math.max(most, length(i));
const step = Math.max(1, Math.ceil(n / 20000));
for (let i = 0; i < n; i += step) {
const size = length(i) / most;
if (!(size > 1e-6 && size < Infinity)) continue;
const at = field.at === "vert" ? mesh.point(i) : toUnit(at3(mesh.centroids, i));
const v = field.numbers.subarray(field.width * i, field.width * i + field.width);
const along = unit([v[0], v[1], v[2] ?? 0].map((x) => x / most)), side = unit(cross(along, Math.abs(along[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]));
const tip = add(at, scaled(along, size * longest)), first = points.length / 3;
for (let k = 0; k < 3; ++k) points.push(...add(at, scaled(turned(side, along, k * 2 * Math.PI / 3), 0.08 * longest * Math.sqrt(size))));
points.push(...tip);
for (const t of [[0, 1, 3], [1, 2, 3], [2, 0, 3], [2, 1, 0]]) { corners.push(...t.map((k) => first + k)); starts.push(corners.length); polys.push(i); }
}
const list = { points: Float64Array.from(points), starts: Uint32Array.from(starts), corners: Uint32Array.from(corners),
triangles: Uint32Array.from(corners, (_, i) => i), polys, elements: null, bare: null, count: polys.length };
list.polygonOf = Uint32Array.from(polys, (_, i) => i);
list.normals = new Float32Array(3 * corners.length);
return list;
}
const noValue = 1e38;  // for the shader: infinite, or not a number
function rangeOf(numbers) {
let low = Infinity, high = -Infinity;
for (const x of numbers) if (Number.isFinite(x)) { if (x < low) low = x; if (x > high) high = x; }
return low <= high ? [low, high] : [0, 1];
}
const fraction = (x, [low, high]) => (high > low ? (x / 2 - low / 2) / (high / 2 - low / 2) : 0.5);
function placeOf(scale, x) {
let i = 1;
while (i + 1 < scale.length && x >= scale[i][0]) ++i;
const [a, b] = [scale[i - 1], scale[i]];
return a[1] + Math.min(1, Math.max(0, fraction(x, [a[0], b[0]]))) * (b[1] - a[1]);
}
const componentsOf = (field) => (field.width === 1 ? ["value"] : ["length", ...["x", "y", "z", "w"].slice(0, Math.min(field.width, 4))]);
function componentNumbers(field, component) {
if (field.width === 1) return field.numbers;
const n = field.numbers.length / field.width, result = new Float64Array(n), k = componentsOf(field).indexOf(component) - 1;
for (let i = 0; i < n; ++i) {
const v = field.numbers.subarray(field.width * i, field.width * (i + 1));
result[i] = k < 0 ? Math.hypot(...v) : v[k];
}
return result;
}
const labelOf = (x) => (x >= 0 && x < 2 ** 53 && Number.isInteger(x) ? x : NaN);
function cornerNumbers(list, at, numbers, range, labels) {
const result = new Float32Array(list.triangles.length);
const shaderNumber = labels ? (x) => (Number.isNaN(labelOf(x)) ? noValue : labelOf(x) % 20)
: (x) => (Number.isFinite(x) ? Math.max(-1e29, Math.min(1e29, fraction(x, range))) : noValue);
const perPolygon = at === "poly" ? list.polys : at === "face" ? list.elements : null, atCorners = at === "corner" && list.mesh;
const placeOf = (vert, p) => (atCorners ? list.mesh.cornerAt(list.polys[p], vert) : vert);
for (let i = 0; i < result.length; ++i) {
const c = list.triangles[i], p = list.polygonOf[Math.floor(i / 3)];
let x = NaN;
if (at === "polygon") x = numbers[p];
else if (at === "corner" && !atCorners) x = numbers[c];
else if (perPolygon) x = numbers[perPolygon[p]];
else if ((at === "vert" || atCorners) && list.between) {
const [v, w, t] = list.between[list.corners[c]], a = numbers[placeOf(v, p)], b = numbers[placeOf(w, p)];
x = t === 0 ? a : t === 1 ? b : a * (1 - t) + b * t;
} else if (at === "vert" || at === "point" || atCorners) x = numbers[placeOf(list.corners[c], p)];
result[i] = shaderNumber(x);
}
return result;
}
function sideNumbers(list, numberOfSide, range) {
const result = new Float32Array(3 * list.triangles.length);
for (let t = 0; t < list.triangles.length / 3; ++t)
for (let k = 0; k < 3; ++k) {
const c = list.triangles[3 * t + k], d = list.triangles[3 * t + (k + 1) % 3], x = numberOfSide(c, d);
const number = Number.isFinite(x) ? fraction(x, range) : noValue;
for (let j = 0; j < 3; ++j) result[9 * t + 3 * j + k] = number;
}
return result;
}
const exponentOf = (x) => (x === 0 ? 0 : Math.floor(Math.log10(Math.abs(x)) + 1e-9));
function roundStep(x) {
const power = 10 ** Math.floor(Math.log10(x));
return ([1, 2, 5].find((m) => x <= m * power * (1 + 1e-9)) ?? 10) * power;
}
function multiples(low, high, step) {
const values = [], first = Math.ceil(low / step - 1e-6), last = Math.floor(high / step + 1e-6);
if (last - first < 1000) for (let k = first; k <= last; ++k) values.push(Math.min(Math.max(k * step, low), high));
return values;
}
function tickText(x, step) {
const digits = Math.max(0, -exponentOf(step)), plain = x.toFixed(Math.min(digits, 100));
if (plain.length <= 7) return plain.replace("-", "−");
return x.toExponential(Math.max(0, Math.min(20, exponentOf(x) - exponentOf(step)))).replace(/\.?0*e/, "e").replace(/e([+-])(\d+)/, (_, sign, n) =>
`·10${sign === "-" ? "⁻" : ""}${[...n].map((d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]).join("")}`).replace("-", "−");
}
function roundTicks(low, high, count) {
const part = high / count - low / count, size = Math.max(Math.abs(low), Math.abs(high));
if (!(part > size * 1e-12) || part < 1e-300) return [[low / 2 + high / 2, textOf(Number((low / 2 + high / 2).toPrecision(6)))]];
const step = roundStep(part), finer = roundStep(0.4 * step), few = multiples(low, high, step), many = multiples(low, high, finer);
)page"),
std::string_view(R"page(const takesFew = few.length >= 2 && Math.abs(few.length - count) <= Math.abs(many.length - count);
return (takesFew ? few : many).map((x) => [x, tickText(x, takesFew ? step : finer)]);
}
function scaleTicks(scale, count) {
const low = scale[0][0], high = scale[scale.length - 1][0];
if (scale.length === 2 || !(high > low)) return roundTicks(low, high, count);
const valueAt = (place) => {
let a = 0, b = 1;
for (let k = 0; k < 60; ++k) { const m = (a + b) / 2; if (placeOf(scale, low * (1 - m) + high * m) < place) a = m; else b = m; }
return low * (1 - a) + high * a;
};
const ticks = [];
for (let k = 0; k <= count; ++k) {
const a = valueAt(Math.max(0, (k - 0.2) / count)), b = valueAt(Math.min(1, (k + 0.2) / count));
if (!(b - a > 1e-12 * Math.max(Math.abs(a), Math.abs(b)))) continue;
const power = 10 ** exponentOf(b - a);
for (const m of [10, 5, 2, 1]) {
const inside = multiples(a, b, m * power);
if (!inside.length) continue;
const x = inside[Math.floor(inside.length / 2)];
ticks.push([x, tickText(x, m * power)]);
break;
}
}
return ticks;
}
const slicing = { exact: false, direction: [1, 1, 1], planes: [0, 1, 2, 3].map(() => ({ on: false, keepsAbove: false, t: 0.5 })) };
function planeOf(k) {
const { t, keepsAbove } = slicing.planes[k], axis = k < 3 ? [0, 1, 2].map((i) => (i === k ? 1 : 0)) : unit(slicing.direction);
let low = Infinity, high = -Infinity;
for (const x of [scene.low[0], scene.high[0]]) for (const y of [scene.low[1], scene.high[1]]) for (const z of [scene.low[2], scene.high[2]]) {
const h = dot(axis, [x, y, z]);
low = Math.min(low, h); high = Math.max(high, h);
}
const offset = low * (1 - t) + high * t;
return keepsAbove ? { n: scaled(axis, -1), offset: -offset } : { n: axis, offset };
}
const planesOn = () => slicing.planes.flatMap((p, k) => (p.on && norm(planeOf(k).n) > 0 ? [{ k, ...planeOf(k) }] : []));
function unitPlane({ n, offset }) {
return [...n, (offset / 2 - dot(n, scene.center) / 2) / scene.radius * 2];
}
class Thing {
constructor(data, index) {
this.index = index;
this.name = data.name || `${data.mesh ? "mesh" : "object"} ${index + 1}`;
this.mesh = data.mesh ? new Mesh(data.mesh) : null;
this.prepared = this.mesh ? null : preparedPolygons(data);
this.data = data;
this.fields = this.mesh ? this.mesh.values : [];
if (data.values) this.fields = [{ name: data.values.name, at: data.values.at, width: 1, numbers: numbersOf(data.values.numbers), labels: data.look.labels }];
if (data.edge_values !== undefined) this.fields = [{ name: "values", at: "side", width: 1, numbers: numbersOf(data.edge_values) }];
if (data.field !== undefined) this.fields[data.field].labels = data.look.labels;
this.painted = data.colors ? { at: data.colors.at, rgb: numbersOf(data.colors.rgb) } : null;
if (data.look.map !== undefined) this.ownMap = numbersOf(data.look.map);
if (data.texture) {
const { picture, values, coordinates } = data.texture, field = this.fields[values];
this.texture = { ...data.texture, at: field ? field.at : "corner", numbers: field ? field.numbers : numbersOf(coordinates) };
if (picture) Object.assign(this.texture, { width: picture.width, height: picture.height, pixels: numbersOf(picture.pixels) });
}
if (data.ball !== undefined) this.ballPixels = numbersOf(data.ball);
this.reset();
}
reset() {
const look = this.data.look;
this.visible = true;
this.wire = look.edge_width > 0;
this.flat = false;
this.textured = Boolean(this.texture);
this.opacity = look.opacity;
this.color = look.color;
this.bands = look.isobands;
this.lines = look.isolines;
this.filter = { layers: 0, on: false, field: 0, low: 0, high: 1, labels: "" };
this.arrows = "";
this.component = "";
this.map = this.ownMap ? -1 : 0;
const field = this.mesh ? this.data.field : this.fields.length ? 0 : undefined;
this.chosen = this.painted ? "painted" : field === undefined ? "color" : String(field);
this.scale = look.scale;
if (this.field) this.baseRange = [look.scale[0][0], look.scale[look.scale.length - 1][0]];
}
get field() { return this.fields[Number(this.chosen)] ?? null; }
get isLabels() { return Boolean(this.field?.labels); }
get numbers() {
const f = this.field, c = this.component || componentsOf(f)[0];
if (this.kept?.f !== f || this.kept?.c !== c) this.kept = { f, c, numbers: componentNumbers(f, c) };
return this.kept.numbers;
}
get edgesHaveValues() { return this.field !== null && (this.field.at === "edge" || this.field.at === "side"); }
choose(name) {
this.chosen = name;
this.component = "";
this.fitRange();
if (this.edgesHaveValues) this.wire = true;
}
fitRange() { if (this.field) this.setRange(...rangeOf(this.numbers)); }
setRange(low, high) {
this.scale = [[low, 0], [Math.max(low, high), 1]];
this.baseRange = [low, Math.max(low, high)];
}
get mapColors() {
if (this.map < 0) return this.ownMap;
const few = scene.maps[this.map].colors, n = few.length / 3 - 1, all = new Uint8Array(768);
for (let i = 0; i < 256; ++i)
for (let c = 0; c < 3; ++c) {
const x = i / 255 * n, k = Math.min(Math.floor(x), n - 1);
all[3 * i + c] = Math.round(few[3 * k + c] + (x - k) * (few[3 * k + 3 + c] - few[3 * k + c]));
}
return all;
}
mask() {
const f = this.filter, field = this.polyFields[f.field], rules = { layers: f.layers, planes: slicing.exact ? [] : planesOn(), values: null };
if (f.on && field) {
const labels = f.labels.trim() ? new Set(f.labels.split(/[\s,;]+/).filter(Boolean).map(Number)) : null;
rules.values = { numbers: field.numbers, low: f.low, high: f.high, labels };
}
return this.mesh.visiblePolys(rules);
}
get polyFields() { return this.fields.filter((f) => f.at === "poly" && f.width === 1 && f.numbers); }
lists() {
if (!this.mesh) return [{ list: this.prepared, role: "surface" }];
const mask = this.mask(), result = [{ list: polygonsOfMesh(this.mesh, mask), role: "surface" }];
this.numShown = mask.reduce((n, x) => n + x, 0);
this.cutAreas = [];
if (slicing.exact && this.mesh.isVolume)
for (const { k, n, offset } of planesOn()) {
const cut = crossSections(this.mesh, mask, n, offset);
this.cutAreas.push(areaOf(cut, n) * scene.radius * scene.radius);
result.push({ list: polygonsOfCut(this.mesh, cut), role: "cut", plane: k });
}
if (this.arrows !== "") result.push({ list: polygonsOfArrows(this.mesh, this.fields[Number(this.arrows)], 0.12), role: "arrows" });
return result;
}
}
function forEachPoint(visit) {
for (const thing of things) {
if (!thing.visible) continue;
const all = thing.mesh ? thing.mesh.units : thing.prepared.points;
for (let i = 0; i < all.length; i += 3) if (Number.isFinite(all[i] + all[i + 1] + all[i + 2])) visit([all[i], all[i + 1], all[i + 2]]);
}
}
const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
let programs, pickBuffer, smoothBuffer;  // programs: by what they draw
const cameraChanges = { count: 0 };
function framebuffer(samples, width, height) {
const frame = gl.createFramebuffer(), buffers = [];
gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
for (const [format, place] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
const buffer = gl.createRenderbuffer();
buffers.push(buffer);
gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
}
return { frame, buffers, width, height };
}
function startDrawing() {
programs = new Map();
pickBuffer = framebuffer(0, 1, 1).frame;
smoothBuffer = null;
}
function programFor(names) {
const known = programs.get(names);
if (known) return known;
const program = gl.createProgram(), defines = names.split(" ").map((n) => `#define ${n}`).join("\n");
for (const [type, text] of [[gl.VERTEX_SHADER, shaders.surface_vert], [gl.FRAGMENT_SHADER, shaders.surface_frag]]) {
const s = gl.createShader(type);
gl.shaderSource(s, text.trim().replace("\n", `\n${defines}\n`));
gl.compileShader(s);
if (!gl.getShaderParameter(s, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(s));
gl.attachShader(program, s);
}
["position", "normal", "flags", "value", "paint", "sides", "texture_place"].forEach((name, i) => gl.bindAttribLocation(program, i, name));
gl.linkProgram(program);
if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
const made = { program, uniforms: {}, camera: -1 };
for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
const name = gl.getActiveUniform(program, i).name.replace(/\[0\]$/, "");
made.uniforms[name] = gl.getUniformLocation(program, name);
}
programs.set(names, made);
return made;
}
function usedProgram(names) {
const used = programFor(names), { program, uniforms: u } = used;
gl.useProgram(program);
if (used.camera === cameraChanges.count) return used;
used.camera = cameraChanges.count;
gl.uniformMatrix4fv(u.project, false, projection());
const { right: r, up, back: b } = camera;
gl.uniformMatrix3fv(u.turn, false, [r[0], up[0], b[0], r[1], up[1], b[1], r[2], up[2], b[2]]);
gl.uniform1i(u.parallel, camera.parallel ? 1 : 0);
gl.uniform3fv(u.eye, eyeOf());
const planes = new Float32Array(16);
for (const p of planesOn()) planes.set(unitPlane(p), 4 * p.k);
gl.uniform4fv(u.planes ?? null, planes);
["map", "ball", "picture"].forEach((name, i) => gl.uniform1i(u[name] ?? null, i));
return used;
}
class Part {
constructor(list, role, plane) {
Object.assign(this, { list, role, plane, count: list.triangles.length, array: gl.createVertexArray(), buffers: [] });
const n = this.count, position = new Float32Array(3 * n), normal = new Int8Array(4 * n), flags = new Uint8Array(4 * n);
const factor = list.normals instanceof Int8Array ? 1 : 127;
for (let i = 0; i < n; ++i) {
const t = i - i % 3, c = list.triangles[i], p = list.polygonOf[t / 3], v = 3 * list.corners[c];
let bits = list.bare && list.bare[p] && role !== "arrows" ? 8 : 0;
for (let k = 0; k < 3; ++k) {
const a = list.triangles[t + k], b = list.triangles[t + (k + 1) % 3];
if (b === a + 1 || (b === list.starts[p] && a + 1 === list.starts[p + 1])) bits |= 1 << k;
}
flags[4 * i] = bits;
for (let k = 0; k < 3; ++k) {
position[3 * i + k] = list.points[v + k];
normal[4 * i + k] = list.normals[3 * c + k] * factor;
}
}
gl.bindVertexArray(this.array);
this.attribute(0, position, 3, gl.FLOAT);
this.attribute(1, normal, 3, gl.BYTE, true, 4);
this.buffer(flags);
gl.enableVertexAttribArray(2);
gl.vertexAttribIPointer(2, 1, gl.UNSIGNED_BYTE, 4, 0);
gl.bindVertexArray(null);
}
buffer(numbers) {
const b = gl.createBuffer();
this.buffers.push(b);
gl.bindBuffer(gl.ARRAY_BUFFER, b);
gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
return b;
}
attribute(place, numbers, size, type, normalized = false, stride = 0) {
this.buffer(numbers);
gl.enableVertexAttribArray(place);
gl.vertexAttribPointer(place, size, type, normalized, stride, 0);
}
color(thing) {
gl.bindVertexArray(this.array);
for (const b of this.buffers.splice(3)) gl.deleteBuffer(b);
for (const place of [3, 4, 5, 6]) gl.disableVertexAttribArray(place);
const { list } = this, f = this.role === "arrows" ? null : thing.field;
if (f && thing.edgesHaveValues) {
const next = (c) => { const p = this.polygonOfCorner(c); return c + 1 === list.starts[p + 1] ? list.starts[p] : c + 1; };
const numberOf = (c, d) => {
if (next(c) !== d) return NaN;
return f.at === "side" ? f.numbers[c] : thing.numbers[thing.mesh.edgeBetween(list.corners[c], list.corners[d])];
};
if (this.role === "surface") this.attribute(5, sideNumbers(list, numberOf, thing.baseRange), 3, gl.FLOAT);
} else if (f) {
this.attribute(3, cornerNumbers(list, f.at, thing.numbers, thing.baseRange, thing.isLabels), 1, gl.FLOAT);
} else if (thing.chosen === "painted" && this.role === "surface") {
const { at, rgb } = thing.painted, bytes = new Uint8Array(4 * this.count);
for (let i = 0; i < this.count; ++i) {
const c = list.triangles[i], p = list.polygonOf[Math.floor(i / 3)];
const k = at === "corner" ? (list.mesh ? list.mesh.cornerAt(list.polys[p], list.corners[c]) : c) : at === "point" || at === "vert" ? list.corners[c] : at === "element" ? list.elements[p] : p;
)page"),
std::string_view(R"page(bytes.set(rgb.subarray(3 * k, 3 * k + 3), 4 * i);
}
this.attribute(4, bytes, 4, gl.UNSIGNED_BYTE, true);
}
if (thing.texture && this.role === "surface") this.attribute(6, texturePlaces(list, thing.texture), 2, gl.FLOAT);
gl.bindVertexArray(null);
}
polygonOfCorner(c) {
let low = 0, high = this.list.count;
while (high - low > 1) { const m = (low + high) >> 1; if (this.list.starts[m] <= c) low = m; else high = m; }
return low;
}
get coarse() {
if (this.coarseBuffers) return this.coarseBuffers;
const { list, count } = this, firstIn = new Int32Array(65 ** 3).fill(-1), moved = new Int32Array(list.points.length / 3).fill(-1);
const cell = (x) => Math.min(64, Math.max(0, Math.floor(32 * x + 32)));
const pointAt = (v) => {
const key = (cell(list.points[3 * v]) * 65 + cell(list.points[3 * v + 1])) * 65 + cell(list.points[3 * v + 2]);
return (firstIn[key] = firstIn[key] < 0 ? v : firstIn[key]);
};
const position = new Float32Array(3 * count), left = [], at = [0, 0, 0];
for (let i = 0; i < count; i += 3) {
for (let k = i; k < i + 3; ++k) {
const v = list.corners[list.triangles[k]];
if (moved[v] < 0) moved[v] = pointAt(v);
at[k - i] = moved[v];
for (let j = 0; j < 3; ++j) position[3 * k + j] = list.points[3 * moved[v] + j];
}
if (at[0] !== at[1] && at[1] !== at[2] && at[2] !== at[0]) left.push(i, i + 1, i + 2);
}
const [points, corners] = [gl.createBuffer(), gl.createBuffer()];
gl.bindVertexArray(null);
gl.bindBuffer(gl.ARRAY_BUFFER, points);
gl.bufferData(gl.ARRAY_BUFFER, position, gl.STATIC_DRAW);
gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, corners);
gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(left), gl.STATIC_DRAW);
return (this.coarseBuffers = { points, corners, count: left.length });
}
draw(isCoarse) {
const coarse = isCoarse ? this.coarse : null, place = (buffer) => {
gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
};
gl.bindVertexArray(this.array);
if (!coarse) return gl.drawArrays(gl.TRIANGLES, 0, this.count);
place(coarse.points);
gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, coarse.corners);
gl.drawElements(gl.TRIANGLES, coarse.count, gl.UNSIGNED_INT, 0);
place(this.buffers[0]);
}
free() {
for (const b of this.buffers) gl.deleteBuffer(b);
if (this.coarseBuffers) for (const b of [this.coarseBuffers.points, this.coarseBuffers.corners]) gl.deleteBuffer(b);
gl.deleteVertexArray(this.array);
}
}
function texturePlaces(list, { at, numbers }) {
const places = new Float32Array(2 * list.triangles.length);
for (let i = 0; i < list.triangles.length; ++i) {
const c = list.triangles[i], v = list.corners[c];
const k = at === "vert" ? v : list.mesh ? list.mesh.cornerAt(list.polys[list.polygonOf[Math.floor(i / 3)]], v) : c;
for (let j = 0; j < 2; ++j) places[2 * i + j] = Number.isFinite(numbers[2 * k + j]) ? numbers[2 * k + j] : noValue;
}
return places;
}
function pictureOf({ width, height, pixels, repeats }) {
const t = gl.createTexture(), channels = pixels.length / (width * height), rgba = new Uint8Array(4 * width * height).fill(255);
for (let i = 0; i < width * height; ++i) rgba.set(pixels.subarray(channels * i, channels * i + channels), 4 * i);
gl.bindTexture(gl.TEXTURE_2D, t);
gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
gl.generateMipmap(gl.TEXTURE_2D);
gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
const sharp = gl.getExtension("EXT_texture_filter_anisotropic");
if (sharp) gl.texParameterf(gl.TEXTURE_2D, sharp.TEXTURE_MAX_ANISOTROPY_EXT, Math.min(8, gl.getParameter(sharp.MAX_TEXTURE_MAX_ANISOTROPY_EXT)));
for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, axis, repeats ? gl.REPEAT : gl.CLAMP_TO_EDGE);
return t;
}
function textureOf(width, height, rgb, filter) {
const t = gl.createTexture();
gl.bindTexture(gl.TEXTURE_2D, t);
gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8, width, height, 0, gl.RGB, gl.UNSIGNED_BYTE, rgb);
for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, filter], [gl.TEXTURE_MAG_FILTER, filter], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
[gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(gl.TEXTURE_2D, name, value);
return t;
}
function sendThing(thing) {
for (const p of thing.parts ?? []) p.free();
thing.parts = thing.lists().map(({ list, role, plane }) => new Part(list, role, plane));
sendColors(thing);
thing.ball ??= thing.ballPixels ? textureOf(64, 64, thing.ballPixels, gl.LINEAR) : null;
thing.picture ??= thing.texture?.pixels ? pictureOf(thing.texture) : null;
}
function sendColors(thing) {
for (const p of thing.parts) p.color(thing);
sendMap(thing);
}
function sendMap(thing) {
if (thing.mapTexture) gl.deleteTexture(thing.mapTexture);
const palette = new Uint8Array(768);
if (thing.isLabels) palette.set(scene.labelColors);
thing.mapTexture = textureOf(256, 1, thing.isLabels ? palette : thing.mapColors, thing.isLabels ? gl.NEAREST : gl.LINEAR);
}
function drawPart(thing, part, pick) {
const look = thing.data.look, isArrow = part.role === "arrows", isSurface = part.role === "surface";
const cuts = slicing.exact ? planesOn().reduce((bits, { k }) => bits | (k === part.plane ? 0 : 1 << k), 0) : 0;
const hasValues = thing.field && !isArrow && !thing.edgesHaveValues, isPainted = thing.chosen === "painted" && isSurface;
const isFlat = thing.flat || !isSurface, hasEdges = thing.wire && !isArrow, hasSides = hasEdges && isSurface && thing.edgesHaveValues;
const texture = thing.textured && isSurface ? thing.texture : null;
const needed = pick ? { PICK: true, CUTS: cuts, PLACE: cuts } : { CUTS: cuts, PLACE: cuts || isFlat, SMOOTH: !isFlat, VALUES: hasValues,
PAINT: !hasValues && isPainted, LINES: hasValues && !thing.isLabels && thing.bands + thing.lines > 0, EDGES: hasEdges, SIDES: hasSides,
BITS: hasEdges || !(hasValues || isPainted), TEXTURE: texture, BALL: thing.ball };
const { program, uniforms: u } = usedProgram(Object.keys(needed).filter((name) => needed[name]).join(" "));
gl.uniform1i(u.cuts, cuts);
gl.uniform1i(u.picking, pick ? pick : 0);
if (!pick) {
gl.uniform1i(u.are_labels, thing.isLabels ? 1 : 0);
gl.uniform3fv(u.color, isArrow ? [0.02, 0.02, 0.025] : thing.color);
gl.uniform3fv(u.exposed_color, look.exposed_color);
gl.uniform3fv(u.no_value, look.no_value);
gl.uniform3fv(u.edge_color, look.edge_color);
const [low, high] = thing.field ? thing.baseRange : [0, 0];  // equal: all values are in the middle of the map
const knots = high > low ? thing.scale.slice(0, 18).map(([x, t]) => [Math.max(-1e29, Math.min(1e29, fraction(x, thing.baseRange))), t]) : [[0, 0], [1, 1]];
if (u.knots) gl.uniform2fv(u.knots, knots.flat());
gl.uniform1i(u.num_knots, knots.length);
gl.uniform1f(u.bands, thing.bands);
gl.uniform1f(u.lines, thing.lines);
gl.uniform2f(u.band_widths ?? null, look.band_width / 2, look.band_limit / 2 * canvas.height);
gl.uniform1f(u.edge_width, (look.edge_width || 1.3) * pixelScale());
gl.uniform1f(u.opacity, isArrow ? 1 : thing.opacity);
gl.uniform1f(u.shine, look.shine);
if (texture) {
gl.uniform1i(u.texture_kind, texture.kind);
gl.uniform2f(u.texture_size, texture.count, texture.width * pixelScale());
gl.uniform3fv(u.texture_first, texture.first);
gl.uniform3fv(u.texture_second, texture.second);
}
[thing.mapTexture, thing.ball, thing.picture].forEach((t, i) => {
gl.activeTexture(gl.TEXTURE0 + i);
gl.bindTexture(gl.TEXTURE_2D, t ?? null);
});
gl.activeTexture(gl.TEXTURE0);
}
part.draw(!pick && motion.level === 2 && isSurface && part.count > motion.manyCorners);
}
const paper = () => (document.documentElement.dataset.theme === "dark" ? [0.09, 0.094, 0.11] : [1, 1, 1]);
const pixelScale = () => Math.min(2, devicePixelRatio) * (motion.level === 2 ? 0.4 : 1);
function drawScene() {
const width = Math.max(1, Math.round(canvas.clientWidth * pixelScale())), height = Math.max(1, Math.round(canvas.clientHeight * pixelScale()));
if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
const isSmooth = motion.level === 0;  // four samples a pixel
if (isSmooth && (smoothBuffer?.width !== width || smoothBuffer.height !== height)) {
if (smoothBuffer) { gl.deleteFramebuffer(smoothBuffer.frame); smoothBuffer.buffers.forEach((b) => gl.deleteRenderbuffer(b)); }
smoothBuffer = framebuffer(Math.min(4, gl.getParameter(gl.MAX_SAMPLES)), width, height);
}
gl.bindFramebuffer(gl.FRAMEBUFFER, isSmooth ? smoothBuffer.frame : null);
gl.viewport(0, 0, width, height);
gl.clearColor(...paper(), 1);
gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
gl.enable(gl.DEPTH_TEST);
gl.disable(gl.CULL_FACE);
++cameraChanges.count;
const shown = things.filter((t) => t.visible), clear = (t) => t.opacity < 1;
gl.disable(gl.BLEND);
gl.depthMask(true);
for (const t of shown) for (const p of t.parts) if (!clear(t) || p.role === "arrows") drawPart(t, p);
gl.enable(gl.BLEND);
gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
gl.depthMask(false);
gl.enable(gl.CULL_FACE);
for (const side of [gl.FRONT, gl.BACK]) {  // what is behind first
gl.cullFace(side);
for (const t of shown) for (const p of t.parts) if (clear(t) && p.role !== "arrows") drawPart(t, p);
}
gl.disable(gl.CULL_FACE);
gl.depthMask(true);
if (isSmooth) {
gl.bindFramebuffer(gl.READ_FRAMEBUFFER, smoothBuffer.frame);
gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
gl.bindFramebuffer(gl.FRAMEBUFFER, null);
}
drawMarks();
}
const motion = { level: 0, moving: 0, rest: 0, slow: 0, fast: 0, pictures: 0, timer: 0, manyCorners: 60000 };
function redrawMoving() {
motion.level = motion.moving;
clearTimeout(motion.timer);
motion.timer = setTimeout(() => { Object.assign(motion, { level: motion.rest, timer: 0, slow: 0, fast: 0 }); redraw(); }, 300);
redraw();
}
function adaptTo(time) {
if (++motion.pictures < 3) return;
if (motion.level === 0 && time > 1000) motion.rest = 1;
if (!motion.timer) return;
motion.slow = time > 80 ? motion.slow + 1 : 0;
motion.fast = time < 25 ? motion.fast + 1 : 0;
if (motion.slow > 2 || time > 400) motion.moving = time > 400 ? 2 : Math.min(2, motion.moving + 1);
else if (motion.fast > 60) motion.moving = Math.max(0, motion.moving - 1);
else return;
motion.slow = motion.fast = 0;
}
let requested = false;
function redraw() {
if (requested) return;
requested = true;
requestAnimationFrame(() => {
requested = false;
followFingers();
if (!gl || gl.isContextLost()) return;
const begin = performance.now();
drawScene();
requestAnimationFrame(() => adaptTo(performance.now() - begin));
});
}
let picked = null;    // { thing, kind, index, point }
let measured = [];    // one or two points in units of the page
function triangleAt(x, y) {
const box = canvas.getBoundingClientRect();
gl.bindFramebuffer(gl.FRAMEBUFFER, pickBuffer);
gl.viewport(-Math.floor(x - box.left), Math.floor(y - box.top) + 1 - canvas.clientHeight, canvas.clientWidth, canvas.clientHeight);
gl.clearColor(0, 0, 0, 0);
gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
gl.enable(gl.DEPTH_TEST);
gl.disable(gl.BLEND);
++cameraChanges.count;
const candidates = things.filter((t) => t.visible).flatMap((thing) => thing.parts.filter((p) => p.role !== "arrows").map((part) => ({ thing, part })));
candidates.slice(0, 255).forEach(({ thing, part }, i) => drawPart(thing, part, i + 1));
const rgba = new Uint8Array(4);
gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
gl.bindFramebuffer(gl.FRAMEBUFFER, null);
return rgba[0] === 0 ? null : { ...candidates[rgba[0] - 1], triangle: rgba[1] + 256 * rgba[2] + 65536 * rgba[3] };
}
function pointOn({ part, triangle }, x, y) {
const { list } = part, [a, b, c] = [0, 1, 2].map((k) => at3(list.points, list.corners[list.triangles[3 * triangle + k]]));
const ray = rayThrough(x, y), n = cross(sub(b, a), sub(c, a)), slope = dot(n, ray.direction);
return slope === 0 ? a : add(ray.origin, scaled(ray.direction, dot(n, sub(a, ray.origin)) / slope));
}
const pixelDistance = (p, x, y) => {
const box = canvas.getBoundingClientRect(), q = pixelOf(p);
)page"),
std::string_view(R"page(return q ? Math.hypot(q[0] - (x - box.left), q[1] - (y - box.top)) : Infinity;
};
function nearestOnEdge(a, b, p) {
const d = sub(b, a), t = dot(d, d) > 0 ? Math.min(1, Math.max(0, dot(sub(p, a), d) / dot(d, d))) : 0;
return mix(a, b, t);
}
function pickAt(x, y, wanted = "any") {
const hit = triangleAt(x, y);
if (!hit) return null;
const { thing, part } = hit, { list } = part, mesh = thing.mesh, point = pointOn(hit, x, y), polygon = list.polygonOf[hit.triangle];
if (!mesh) return { thing, kind: "polygon", index: polygon, point };
const poly = list.polys[polygon];
if (!list.elements) return { thing, kind: "poly", index: poly, point };
const element = list.elements[polygon], verts = [...mesh.cornersOf(element)];
const nearest = (items, distance) => items.reduce((best, i) => (distance(i) < distance(best) ? i : best));
const vert = nearest(verts, (v) => pixelDistance(mesh.point(v), x, y));
const edges = mesh.edgesOfPolygon(element).filter((e) => e >= 0);
const ends = (e) => [mesh.point(mesh.edges[2 * e]), mesh.point(mesh.edges[2 * e + 1])];
const edgeDistance = (e) => pixelDistance(nearestOnEdge(...ends(e), point), x, y);
const edge = edges.length ? nearest(edges, edgeDistance) : -1;
if (wanted === "vert" || (wanted === "any" && pixelDistance(mesh.point(vert), x, y) < 7)) return { thing, kind: "vert", index: vert, point };
if (edge >= 0 && (wanted === "edge" || (wanted === "any" && edgeDistance(edge) < 4))) return { thing, kind: "edge", index: edge, point };
if (wanted === "face" && mesh.isVolume) return { thing, kind: "face", index: element, point };
return { thing, kind: "poly", index: poly, face: mesh.isVolume ? element : undefined, point };
}
const boundOf = (mesh, kind) => ({ vert: mesh.numVerts, edge: mesh.edges.length / 2, face: mesh.isVolume ? mesh.numPolygons : 0, poly: mesh.numPolys })[kind] ?? 0;
function hasElement(mesh, kind, i) {
if (!(Number.isInteger(i) && i >= 0 && i < boundOf(mesh, kind))) return false;
if (kind === "vert") return Number.isFinite(mesh.points[3 * i]);
if (kind === "edge") return mesh.edges[2 * i] !== mesh.edges[2 * i + 1];
return kind === "poly" ? mesh.hasPoly(i) : mesh.polygonStarts[i + 1] > mesh.polygonStarts[i];
}
function middleOf(mesh, kind, i) {
const verts = kind === "vert" ? [i] : kind === "edge" ? [...mesh.edges.subarray(2 * i, 2 * i + 2)] : kind === "poly" ? mesh.vertsOfPoly(i) : [...mesh.cornersOf(i)];
return scaled(verts.map((v) => mesh.point(v)).reduce(add), 1 / verts.length);
}
function goTo(thing, kind, index) {
if (!thing?.mesh || !hasElement(thing.mesh, kind, index)) return false;
picked = { thing, kind, index, point: middleOf(thing.mesh, kind, index) };
camera.target = picked.point;
return true;
}
function describe({ thing, kind, index, face, point }) {
const rows = [["object", thing.name], ["element", `${kind} ${index}`]], mesh = thing.mesh, few = (list) => {
const texts = [...list].slice(0, 24).map(String);
return texts.join(" ") + (list.length > 24 ? ` … ${list.length} in all` : list.length ? "" : "none");
};
if (!mesh) return [...rows, ["point", toMesh(point).map(textOf).join(", ")], ...valueRows(thing, "polygon", index, point)];
if (face !== undefined) rows.push(["face", String(face)]);
if (kind === "vert") {
rows.push(["position", at3(mesh.points, index).map(textOf).join(", ")]);
const edges = listOf(mesh.edgesOfVert, index);
rows.push(["verts beside it", few([...edges].map((e) => mesh.edges[2 * e] + mesh.edges[2 * e + 1] - index))], ["edges", few(edges)]);
rows.push(["polys", few(mesh.polysOfVert(index))]);
} else if (kind === "edge") {
const [a, b] = mesh.edges.subarray(2 * index, 2 * index + 2), polygons = mesh.polygonsOfEdge(index);
rows.push(["verts", `${a} ${b}`], ["length", textOf(norm(sub(mesh.point(a), mesh.point(b))) * scene.radius)]);
if (mesh.isVolume) rows.push(["faces", few(polygons)]);
rows.push(["polys", few([...new Set(polygons.flatMap((p) => mesh.polysOfPolygon(p)))])]);
} else if (kind === "face") rows.push(["verts", few(mesh.cornersOf(index))], ["polys", few(mesh.polysOfPolygon(index))]);
else {
rows.push(["verts", few(mesh.vertsOfPoly(index))], ["polys beside it", few(mesh.neighboursOf(index))]);
if (mesh.isVolume) rows.push(["faces", few(mesh.facesOf(index))]);
rows.push(["centroid", at3(mesh.centroids, index).map(textOf).join(", ")]);
}
return [...rows, ...valueRows(thing, kind, index)];
}
function valueRows(thing, kind, index) {
const textAt = (f, i) => (f.texts ? f.texts[i] : [...f.numbers.subarray(f.width * i, f.width * i + f.width)].map(textOf).join(", "));
const rows = thing.fields.filter((f) => f.at === kind || f.at === "mesh").map((f) => [f.name, textAt(f, f.at === "mesh" ? 0 : index)]);
if (!thing.mesh || (kind !== "poly" && kind !== "vert")) return rows;
const beside = kind === "poly" ? thing.mesh.vertsOfPoly(index) : thing.mesh.polysOfVert(index);
for (const f of thing.fields.filter((g) => g.at === "corner")) {
const texts = beside.slice(0, 24).map((x) => `${x}: ${textAt(f, kind === "poly" ? thing.mesh.cornerAt(index, x) : thing.mesh.cornerAt(x, index))}`);
rows.push([`${f.name}, by ${kind === "poly" ? "vert" : "poly"}`, texts.join("; ")]);
}
return rows;
}
function drawMarks() {
const svg = byId("marks"), shape = (name, attributes) => {
const e = document.createElementNS("http://www.w3.org/2000/svg", name);
for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
return e;
};
svg.replaceChildren();
const pixels = (points) => points.map(pixelOf).filter(Boolean);
const outline = (points, closed = true) => svg.append(shape(closed ? "polygon" : "polyline", { class: "mark", points: pixels(points).map((p) => p.join()).join(" ") }));
const dot2 = (p) => { const q = pixelOf(p); if (q) svg.append(shape("circle", { class: "mark", cx: q[0], cy: q[1], r: 5 })); };
if (picked?.thing.mesh) {
const { thing: { mesh }, kind, index } = picked, loop = (f) => [...mesh.cornersOf(f)].map((v) => mesh.point(v));
if (kind === "vert") dot2(mesh.point(index));
else if (kind === "edge") outline([0, 1].map((k) => mesh.point(mesh.edges[2 * index + k])), false);
else if (kind === "face" || !mesh.isVolume) outline(loop(index));
else for (const f of mesh.facesOf(index)) outline(loop(f));
} else if (picked) dot2(picked.point);
if (measured.length === 2) svg.append(shape("polyline", { class: "measure", points: pixels(measured).map((p) => p.join()).join(" ") }));
measured.forEach(dot2);
const texts = byId("texts");
while (texts.children.length < scene.labels.length) texts.append(make("span", { dir: "auto", textContent: scene.labels[texts.children.length].text }));
scene.labels.forEach(({ at }, i) => {
const p = pixelOf(toUnit(at)), e = texts.children[i];
e.hidden = !p;
if (p) e.style.transform = `translate(${p[0] + 8}px, ${p[1] - 24}px)`;
});
}
const panel = byId("panel");
function changed(what, thing) {
if (what === "polygons") for (const t of thing ? [thing] : things) if (t.mesh) sendThing(t);
if (what === "colors") sendColors(thing);
if (what === "map") sendMap(thing);
showLegend();
showAreas();
redraw();
}
const row = (...content) => make("div", { className: "row" }, ...content);
const fittedRow = (...content) => make("div", { className: "row fitted" }, ...content);
const labelled = (text, input) => make("label", {}, text, input);
const checkbox = (text, value, set) => make("label", {}, make("input", { type: "checkbox", checked: value, onchange: (e) => set(e.target.checked) }), text);
const slider = (text, value, low, high, step, set) => make("input", { type: "range", min: low, max: high, step, value, "aria-label": text,
oninput: (e) => set(Number(e.target.value)) });
const number = (text, value, set, step = "any") => make("input", { type: "number", step, value: Number.isFinite(value) ? Number(value.toPrecision(5)) : value, "aria-label": text,
onchange: (e) => { if (e.target.value !== "" && Number.isFinite(Number(e.target.value))) set(Number(e.target.value)); } });
const select = (text, choices, value, set) => {
const s = make("select", { "aria-label": text, onchange: (e) => set(e.target.value) }, ...choices.map(([v, name]) => make("option", { value: v, textContent: name, dir: "auto" })));
s.value = value;
return s;
};
const button = (text, press, title = "") => make("button", { type: "button", title, onclick: press }, text);
const section = (name, open, ...content) => make("details", { open }, make("summary", {}, name), ...content);
const byteOf = (x) => Math.round(255 * Math.min(1, Math.max(0, x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)));
const hexOf = (c) => `#${c.map((x) => byteOf(x).toString(16).padStart(2, "0")).join("")}`;
const linearOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
const nameOfField = (f) => (["vert", "edge", "face", "poly", "corner"].includes(f.at) ? `${f.name} (${f.at}s)` : f.name);
function thingControls(thing) {
const box = make("fieldset", { id: `thing${thing.index}` }), fill = () => box.replaceChildren(...content());
const content = () => {
const parts = [make("legend", { dir: "auto" }, thing.name),
row(checkbox("shown", thing.visible, (x) => { thing.visible = x; changed("view"); }),
checkbox("edges", thing.wire, (x) => { thing.wire = x; changed("view"); }),
checkbox("flat", thing.flat, (x) => { thing.flat = x; changed("view"); }),
...(thing.texture ? [checkbox("texture", thing.textured, (x) => { thing.textured = x; changed("view"); })] : [])),
row("opacity", slider(`opacity of ${thing.name}`, thing.opacity, 0, 1, 0.01, (x) => { thing.opacity = x; changed("view"); }))];
const numeric = thing.fields.map((f, i) => [String(i), nameOfField(f), f]).filter(([, , f]) => f.numbers && f.at !== "mesh");
const choices = [["color", "one colour"], ...(thing.painted ? [["painted", "own colours"]] : []), ...numeric];
parts.push(row("colours", select(`colours of ${thing.name}`, choices, thing.chosen, (v) => { thing.choose(v); fill(); changed("colors", thing); })));
if (thing.chosen === "color") parts.push(row(labelled("colour", make("input", { type: "color", value: hexOf(thing.color),
oninput: (e) => { thing.color = linearOf(e.target.value); changed("view"); } }))));
const f = thing.field;
if (f && f.width > 1) parts.push(row("show", select("component", componentsOf(f).map((c) => [c, c]), thing.component || componentsOf(f)[0],
(c) => { thing.component = c; thing.fitRange(); fill(); changed("colors", thing); })));
if (f && !f.labels) parts.push(...scaleControls(thing, fill));
const vectors = thing.fields.map((g, i) => [String(i), nameOfField(g), g]).filter(([, , g]) => g.numbers && (g.width === 2 || g.width === 3) && (g.at === "vert" || g.at === "poly") && g.numbers !== thing.texture?.numbers);
if (vectors.length) parts.push(row("arrows", select(`arrows of ${thing.name}`, [["", "none"], ...vectors], thing.arrows, (v) => { thing.arrows = v; changed("polygons", thing); })));
return parts;
};
fill();
return box;
}
function scaleControls(thing, fill) {
const maps = [...(thing.ownMap ? [["-1", "as in the program"]] : []), ...scene.maps.map((m, i) => [String(i), m.name])];
const low = thing.scale[0][0], high = thing.scale[thing.scale.length - 1][0];
const range = (a, b) => { thing.setRange(a, b); fill(); changed("colors", thing); };
return [row("map", select(`colour map of ${thing.name}`, maps, String(thing.map), (v) => { thing.map = Number(v); changed("map", thing); })),
fittedRow("from", number("lowest value", low, (x) => range(x, Math.max(x, high))), "to", number("highest value", high, (x) => range(Math.min(low, x), x)),
button("all", () => { thing.fitRange(); fill(); changed("colors", thing); }, "The range of all values")),
row("bands", number("white bands", thing.bands, (x) => { thing.bands = Math.max(0, Math.round(x)); changed("view"); }, 1),
"lines", number("iso-lines", thing.lines, (x) => { thing.lines = Math.max(0, Math.round(x)); changed("view"); }, 1))];
}
function planeControls(k) {
const p = slicing.planes[k], name = ["x", "y", "z", "any"][k];
)page"),
std::string_view(R"page(const redo = () => changed(slicing.exact && !things.some((t) => t.mesh?.isVolume) ? "view" : "polygons");
const value = make("output", { className: "soft", id: `offset${k}` });
const show = () => { const { offset } = planeOf(k); value.textContent = textOf(Math.abs(offset) < 1e-9 * scene.radius ? 0 : Number((p.keepsAbove ? -offset : offset).toPrecision(5))); };
show();
const parts = [fittedRow(checkbox(name, p.on, (x) => { p.on = x; redo(); }),
slider(`place of the cut along ${name}`, p.t, 0, 1, 0.001, (x) => { p.t = x; p.on = true; parts[0].querySelector("input").checked = true; show(); redo(); }),
value, checkbox("above", p.keepsAbove, (x) => { p.keepsAbove = x; redo(); }))];
if (k === 3) parts.push(fittedRow(...[0, 1, 2].map((i) => number(`direction ${"xyz"[i]}`, slicing.direction[i], (x) => { slicing.direction[i] = x; show(); redo(); })),
button("from view", () => { slicing.direction = camera.back.map((x) => Number(x.toPrecision(4))); showPanel(); redo(); }, "The direction to the viewer")));
return parts;
}
function filterControls(thing) {
const f = thing.filter, redo = () => changed("polygons", thing), fields = thing.polyFields;
const parts = [make("legend", { dir: "auto" }, thing.name),
row("layers peeled off", number(`layers peeled off ${thing.name}`, f.layers, (x) => { f.layers = Math.max(0, Math.round(x)); redo(); }, 1))];
if (fields.length) {
const fit = () => { [f.low, f.high] = rangeOf(fields[f.field].numbers); };
if (!f.on) fit();
const box = make("div"), fill = () => box.replaceChildren(
row(checkbox("only polys with", f.on, (x) => { f.on = x; redo(); }), select("value of polys", fields.map((g, i) => [String(i), g.name]), String(f.field), (v) => { f.field = Number(v); fit(); fill(); redo(); })),
fittedRow("from", number("lowest shown", f.low, (x) => { f.low = x; redo(); }), "to", number("highest shown", f.high, (x) => { f.high = x; redo(); })),
row("or labels", make("input", { type: "text", value: f.labels, placeholder: "1 2 5", "aria-label": "labels shown", onchange: (e) => { f.labels = e.target.value; f.on = f.on || f.labels !== ""; fill(); redo(); } })));
fill();
parts.push(box);
}
return make("fieldset", {}, ...parts);
}
function showAreas() {
const areas = things.flatMap((t) => t.cutAreas ?? []), hidden = things.filter((t) => t.mesh && t.numShown !== undefined);
const texts = hidden.map((t) => `${t.numShown} polys shown`);
if (areas.length) texts.push(`area of the cut: ${areas.map((a) => textOf(a)).join(", ")}`);
byId("areas")?.replaceChildren(texts.join("; "));
}
function showPicked() {
const box = byId("picked");
if (!box) return;
const rows = picked ? describe(picked) : [];
if (measured.length === 2) rows.push(["distance", textOf(norm(sub(measured[0], measured[1])) * scene.radius)]);
box.replaceChildren(...rows.flatMap(([name, value]) => [make("dt", { dir: "auto" }, name), make("dd", { dir: "auto" }, value)]));
const isolated = (text) => `\u2068${text.slice(0, 60)}\u2069`;  // its direction does not change that of the others
const values = picked ? valueRows(picked.thing, picked.kind, picked.index).slice(0, 4).map((r) => `, ${r.map(isolated).join(" ")}`) : [];
say(picked ? rows.slice(0, 2).map(([, value]) => isolated(value)).join(", ") + values.join("") : measured.length === 2 ? `${rows.at(-1)[0]} ${rows.at(-1)[1]}` : "");
}
function pickControls() {
const meshes = things.filter((t) => t.mesh);
if (!meshes.length) return [make("p", { className: "soft" }, "A click names the object. With inspect, a mesh also tells its elements and values.")];
const go = { thing: meshes[0], kind: "poly", index: 0 };
const jump = () => { if (goTo(go.thing, go.kind, go.index)) showPicked(); else say(`there is no ${go.kind} ${go.index}`); redo(); }, redo = redraw;
return [row("a click picks", select("what a click picks", [["any", "what is nearest"], ["vert", "verts"], ["edge", "edges"], ["face", "faces"], ["poly", "polys"]], wanted,
(v) => { wanted = v; })),
row(...(meshes.length > 1 ? [select("mesh", meshes.map((t, i) => [String(i), t.name]), "0", (v) => { go.thing = meshes[Number(v)]; })] : []),
select("kind of element", ["vert", "edge", "face", "poly"].map((k) => [k, k]), go.kind, (v) => { go.kind = v; }),
make("input", { type: "number", id: "goIndex", min: 0, step: 1, value: 0, "aria-label": "index of the element", oninput: (e) => { go.index = Number(e.target.value); },
onkeydown: (e) => { if (e.key === "Enter") jump(); } }), button("go", jump, "Shows this element")),
make("p", { className: "soft" }, "Shift and click measures a distance.")];
}
function viewControls() {
return [row(...["+x", "−x", "+y", "−y", "+z", "−z"].map((name, i) => button(name, () => press(String(i + 1)), `Looks along the axis (${i + 1})`))),
row(button("perspective", () => press("p"), "Perspective or orthographic (P)"), button("reset", () => press("r"), "The first view (R)"),
button("dark", () => press("d"), "Light or dark (D)")),
row(button("picture", () => press("s"), "Saves a PNG file (S)"), button("copy view", () => press("v"), "An address that shows this view (V)"))];
}
function showPanel() {
const meshes = things.filter((t) => t.mesh);
panel.replaceChildren(
section("Objects", true, ...(things.length ? things.map(thingControls) : [make("p", { className: "soft" }, "The scene is empty.")])),
...(meshes.length ? [section("Cuts", innerWidth > 700, row(select("kind of cut", [["", "whole polys"], ["exact", "cut exactly"]], slicing.exact ? "exact" : "",
(v) => { slicing.exact = v !== ""; changed("polygons"); })), ...[0, 1, 2, 3].flatMap(planeControls), make("p", { id: "areas", className: "soft" }), ...meshes.map(filterControls))] : []),
section("Inspect", true, ...pickControls(), make("dl", { id: "picked" })),
section("View", innerWidth > 700, ...viewControls()));
showAreas();
showPicked();
}
function showLegend() {
const box = byId("legend"), thing = things.find((t) => t.visible && t.field);
box.hidden = !thing;
if (!thing) return;
const f = thing.field, title = make("figcaption", { dir: "auto" }, f.width > 1 ? `${f.name}, ${thing.component || componentsOf(f)[0]}` : f.name);
if (thing.isLabels) {
const all = [...new Set(f.numbers)].map(labelOf).filter((x) => !Number.isNaN(x)).sort((a, b) => a - b).slice(0, 20);
const colorOf = (x) => `rgb(${[0, 1, 2].map((c) => scene.labelColors[3 * (x % 20) + c]).join()})`;
box.replaceChildren(title, make("ul", {}, ...all.map((x) => { const i = make("i"); i.style.background = colorOf(x); return make("li", {}, i, String(x)); })));
return;
}
const bar = make("canvas", { width: 1, height: 256 }), paint = bar.getContext("2d"), colors = thing.mapColors;
for (let y = 0; y < 256; ++y) { paint.fillStyle = `rgb(${colors.slice(3 * (255 - y), 3 * (256 - y)).join()})`; paint.fillRect(0, y, 1, 1); }
const ticks = scaleTicks(thing.scale, 6).map(([x, text]) => { const s = make("span", {}, text); s.style.top = `${100 - 100 * placeOf(thing.scale, x)}%`; return s; });
box.replaceChildren(title, bar, make("div", { className: "ticks" }, ...ticks));
if (thing.numbers.every(Number.isFinite)) return;
const grey = make("i");
grey.style.background = hexOf(thing.data.look.no_value);
box.append(make("p", {}, grey, "no finite value"));
}
const say = (text) => { byId("message").textContent = text; };
let wanted = "any";
const pointers = new Map();
let moved = 0, grip = null, button0 = 0, byTouch = false;
let lastTap = { time: -Infinity, x: 0, y: 0 };
canvas.addEventListener("contextmenu", (e) => e.preventDefault());
canvas.addEventListener("pointerdown", (e) => {
canvas.focus({ preventScroll: true });
try { canvas.setPointerCapture(e.pointerId); } catch { /* a pointer that is already gone */ }
pointers.set(e.pointerId, [e.clientX, e.clientY]);
button0 = e.button;
byTouch = e.pointerType === "touch";
if (pointers.size === 1) moved = 0;
grip = gripOf();
});
canvas.addEventListener("pointermove", (e) => {
const before = pointers.get(e.pointerId);
if (!before) return;
const dx = e.clientX - before[0], dy = e.clientY - before[1];
moved += Math.abs(dx) + Math.abs(dy);
pointers.set(e.pointerId, [e.clientX, e.clientY]);
if (pointers.size === 1) (button0 === 0 && !e.shiftKey ? rotate : pan)(dx, dy);
redrawMoving();
});
const release = (e) => {
followFingers();
const wasDown = pointers.delete(e.pointerId);
grip = gripOf();
if (!wasDown || e.type === "pointercancel") return;
if (moved >= (byTouch ? 12 : 5) || e.button !== 0 || pointers.size > 0) return;
const { clientX: x, clientY: y, timeStamp: time } = e;
if (byTouch && time - lastTap.time < 400 && Math.hypot(x - lastTap.x, y - lastTap.y) < 30) {
lastTap.time = -Infinity;
return center(x, y);
}
lastTap = { time, x, y };
click(x, y, e.shiftKey);
};
canvas.addEventListener("pointerup", release);
canvas.addEventListener("pointercancel", release);
canvas.addEventListener("wheel", (e) => {
e.preventDefault();
zoom(Math.exp(Math.max(-1, Math.min(1, e.deltaY * (e.deltaMode === 1 ? 0.05 : 0.0015)))), e.clientX, e.clientY);
redrawMoving();
}, { passive: false });
canvas.addEventListener("dblclick", (e) => { if (!byTouch) center(e.clientX, e.clientY); });
function gripOf() {
const [a, b] = [...pointers.values()];
return b ? { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, size: Math.hypot(a[0] - b[0], a[1] - b[1]) } : null;
}
function followFingers() {
if (!grip) return;
const now = gripOf();
pan(now.x - grip.x, now.y - grip.y);
if (grip.size > 0 && now.size > 0) zoom(grip.size / now.size, now.x, now.y);
grip = now;
}
function center(x, y) {
const hit = gl && triangleAt(x, y);
if (hit) camera.target = pointOn(hit, x, y);
redraw();
}
function click(x, y, measures) {
const found = gl && pickAt(x, y, wanted);
if (measures) {
if (found) measured = measured.length === 1 ? [measured[0], found.point] : [found.point];
if (measured.length === 1) say("Shift and click on another point");
} else {
picked = found;
measured = [];
}
if (!measures || measured.length === 2) showPicked();
redraw();
}
function setTheme(dark) {
document.documentElement.dataset.theme = dark ? "dark" : "light";
redraw();
}
function savePicture() {
if (!gl) return;
drawScene();
canvas.toBlob((blob) => {
const link = make("a", { href: URL.createObjectURL(blob), download: "picture.png" });
link.click();
setTimeout(() => URL.revokeObjectURL(link.href), 1000);
});
}
function copyView() {
location.hash = viewText();
const done = () => say("the address of this page now holds the view");
navigator.clipboard?.writeText(location.href).then(() => say("the address of this view is copied"), done) ?? done();
}
function press(key) {
const axes = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], box = canvas.getBoundingClientRect();
const middle = [box.left + box.width / 2, box.top + box.height / 2], axis = axes[Number(key) - 1];
if (axis) lookFrom(axis, Math.abs(dot(axis, scene.up)) > 0.9 ? [scene.up[2], scene.up[0], scene.up[1]].map((x) => -x) : scene.up);
else if (key === "p") switchPerspective();
else if (key === "r") { resetCamera(); picked = null; measured = []; showPicked(); }
else if (key === "d") setTheme(document.documentElement.dataset.theme !== "dark");
else if (key === "c") togglePanel();
else if (key === "s") savePicture();
else if (key === "v") copyView();
else if (key === "h") say("arrows rotate, Shift and arrows move, + and − zoom, 1 to 6 look along axes, P perspective, R reset, D dark, C controls, S picture, V copy the view, Esc nothing picked");
else if (key === "escape") { picked = null; measured = []; showPicked(); }
else if (key === "+" || key === "=") zoom(0.85, ...middle);
else if (key === "-") zoom(1 / 0.85, ...middle);
else return false;
redraw();
return true;
}
function togglePanel() {
panel.hidden = !panel.hidden;
document.body.classList.toggle("closed", panel.hidden);
byId("toggle").setAttribute("aria-expanded", String(!panel.hidden));
redraw();
}
document.addEventListener("keydown", (e) => {
if (e.ctrlKey || e.metaKey || e.altKey || /^(INPUT|SELECT|TEXTAREA|SUMMARY)$/.test(e.target.tagName)) return;
if (e.target.tagName === "BUTTON" && (e.key === "Enter" || e.key === " ")) return;
)page"),
std::string_view(R"page(const step = 24, arrow = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[e.key];
if (arrow) (e.shiftKey ? pan : rotate)(...arrow);
else if (!press(e.key.toLowerCase())) return;
e.preventDefault();
redraw();
});
byId("toggle").addEventListener("click", togglePanel);
addEventListener("resize", redraw);
addEventListener("hashchange", () => { if (takeView(location.hash)) redraw(); });
let things = [];
function start() {
const titleText = scene.title || "Scene";
document.title = titleText;
byId("title").textContent = scene.title;
const dark = scene.theme === "dark" || (scene.theme === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
document.documentElement.dataset.theme = dark ? "dark" : "light";
if (!gl) {
say("This browser has no WebGL 2, which the page needs to draw the scene. A current Firefox, Chrome, Edge or Safari has it.");
return;
}
for (const m of scene.maps) m.colors = numbersOf(m.colors);
scene.labelColors = numbersOf(scene.label_colors);
scene.reach = 1.2;
things = scene.objects.map((data, i) => new Thing(data, i));
startDrawing();
if (innerWidth <= 700) togglePanel();
resetCamera();
takeView(location.hash);
for (const t of things) sendThing(t);
showPanel();
showLegend();
redraw();
}
canvas.addEventListener("webglcontextlost", (e) => e.preventDefault());
canvas.addEventListener("webglcontextrestored", () => {
startDrawing();
for (const t of things) { t.ball = null; t.picture = null; t.mapTexture = null; t.parts = []; sendThing(t); }
redraw();
});
start();
window.concino = { scene, camera, slicing, things: () => things, press, rotate, pickAt, pixelOf, halfHeight, describe, goTo, changed, drawScene,
planeOf, setTheme, motion, redrawMoving, gl };
})();
</script>
</body>
</html>
)page")};
// clang-format on

}  // namespace concino::detail
