// Vectors of three numbers in double precision.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const n = norm(a); return n > 0 ? scaled(a, 1 / n) : [0, 0, 0]; };
const mix = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
const at3 = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]];

/// v turned about a unit axis.
function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(scaled(v, c), scaled(cross(axis, v), s)), scaled(axis, dot(axis, v) * (1 - c)));
}

/// From units of the mesh to those of the page, in which the middle of the scene is 0 and half its diagonal is 1, and back.
/// Halves cannot overflow.
const unitCoordinate = (x, k) => (x / 2 - scene.center[k] / 2) / scene.radius * 2;
const toUnit = (p) => [0, 1, 2].map((k) => unitCoordinate(p[k], k));
const toMesh = (p) => [0, 1, 2].map((k) => p[k] * scene.radius + scene.center[k]);

/// Triangles of a polygon in its plane, as places in it: ears are cut off one after the other.
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
