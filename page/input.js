// Mouse, touch and keys.

let wanted = "any";
const pointers = new Map();
let moved = 0, pinch = 0, button0 = 0;

canvas.addEventListener("contextmenu", (e) => e.preventDefault());
canvas.addEventListener("pointerdown", (e) => {
  canvas.focus({ preventScroll: true });
  try { canvas.setPointerCapture(e.pointerId); } catch { /* a pointer that is already gone */ }
  pointers.set(e.pointerId, [e.clientX, e.clientY]);
  button0 = e.button;
  if (pointers.size === 1) moved = 0;
  pinch = 0;
});
canvas.addEventListener("pointermove", (e) => {
  const before = pointers.get(e.pointerId);
  if (!before) return;
  const dx = e.clientX - before[0], dy = e.clientY - before[1];
  moved += Math.abs(dx) + Math.abs(dy);
  pointers.set(e.pointerId, [e.clientX, e.clientY]);
  if (pointers.size === 2) {
    const [a, b] = [...pointers.values()], size = Math.hypot(a[0] - b[0], a[1] - b[1]);
    pan(dx / 2, dy / 2);
    if (pinch > 0 && size > 0) zoom(pinch / size, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    pinch = size;
  } else if (button0 === 0 && !e.shiftKey) rotate(dx, dy);
  else pan(dx, dy);
  redrawMoving();
});
const release = (e) => {
  if (!pointers.delete(e.pointerId) || e.type === "pointercancel") return;
  if (moved < 5 && e.button === 0 && pointers.size === 0) click(e.clientX, e.clientY, e.shiftKey);
  pinch = 0;
};
canvas.addEventListener("pointerup", release);
canvas.addEventListener("pointercancel", release);
canvas.addEventListener("wheel", (e) => {
  e.preventDefault();
  zoom(Math.exp(Math.max(-1, Math.min(1, e.deltaY * (e.deltaMode === 1 ? 0.05 : 0.0015)))), e.clientX, e.clientY);
  redrawMoving();
}, { passive: false });
canvas.addEventListener("dblclick", (e) => {
  const hit = triangleAt(e.clientX, e.clientY);
  if (hit) camera.target = pointOn(hit, e.clientX, e.clientY);
  redraw();
});

function click(x, y, measures) {
  const found = pickAt(x, y, wanted);
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
