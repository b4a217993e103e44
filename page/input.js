// Mouse, touch and keys.

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

/// The middle of two fingers and their distance; null if there are fewer.
function gripOf() {
  const [a, b] = [...pointers.values()];
  return b ? { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, size: Math.hypot(a[0] - b[0], a[1] - b[1]) } : null;
}
/// Moves and zooms as two fingers did since the last picture. Their events come one after the other.
function followFingers() {
  if (!grip) return;
  const now = gripOf();
  pan(now.x - grip.x, now.y - grip.y);
  if (grip.size > 0 && now.size > 0) zoom(grip.size / now.size, now.x, now.y);
  grip = now;
}

/// Moves what is at a pixel to the middle.
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

/// What a key does; false if it does nothing.
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
  const step = 24, arrow = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[e.key];
  if (arrow) (e.shiftKey ? pan : rotate)(...arrow);
  else if (!press(e.key.toLowerCase())) return;
  e.preventDefault();
  redraw();
});
byId("toggle").addEventListener("click", togglePanel);
addEventListener("resize", redraw);
addEventListener("hashchange", () => { if (takeView(location.hash)) redraw(); });
