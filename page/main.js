// Starts the page.

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
/// For programs that drive the page, such as tests.
window.concino = { scene, camera, slicing, things: () => things, press, rotate, pickAt, pixelOf, halfHeight, describe, goTo, changed, drawScene,
  planeOf, setTheme, motion, redrawMoving, gl };
