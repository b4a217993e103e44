// The camera: it looks at a point, about which it turns. Lengths are those of the page.

const camera = {};
const canvas = byId("view");
const aspect = () => Math.max(canvas.clientWidth, 1) / Math.max(canvas.clientHeight, 1);
const eyeOf = () => add(camera.target, scaled(camera.back, camera.distance));

/// Half the height of the picture at the target.
const halfHeight = () => (camera.parallel ? camera.half : camera.slope * camera.distance);

function orient(back, up) {
  camera.back = unit(back);
  camera.right = unit(cross(up, camera.back));
  if (norm(camera.right) < 0.5) camera.right = unit(cross([camera.back[1], camera.back[2], camera.back[0]], camera.back));
  camera.up = cross(camera.back, camera.right);
}

/// The nearest camera in the same direction that sees all points, with free space at the edges.
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
  if (c.parallel) camera.half = c.half_height / scene.radius;
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

/// x and y: in half heights of the picture, from its middle, to the right and up.
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

/// Pixels of the page; null behind the eye.
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

/// What is under the pointer stays there.
function zoom(factor, x, y) {
  const [u, v] = filmPoint(x, y), h = halfHeight() * (1 - factor);
  camera.target = add(camera.target, add(scaled(camera.right, u * h), scaled(camera.up, v * h)));
  camera.distance *= factor;
  camera.half *= factor;
}

/// The matrix of WebGL, column by column.
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

/// The view as a part of an address, and back.
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
