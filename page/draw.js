// Draws the things by WebGL 2.

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

/// Pixels of the drawing for each of the page: fewer while the view moves if drawing is slow.
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

/// level 0: smooth edges; 1: one sample a pixel; 2: also fewer pixels, and of many triangles fewer.
/// moving, rest: the level while the view moves, and when it rests.
const motion = { level: 0, moving: 0, rest: 0, slow: 0, fast: 0, pictures: 0, timer: 0, manyCorners: 60000 };
function redrawMoving() {
  motion.level = motion.moving;
  clearTimeout(motion.timer);
  motion.timer = setTimeout(() => { Object.assign(motion, { level: motion.rest, timer: 0, slow: 0, fast: 0 }); redraw(); }, 300);
  redraw();
}
/// While the view moves, pictures that take longer than 80 ms are drawn at the next level, until they take less than 25; at rest, those that
/// take longer than a second. The first ones wait for programs.
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
/// Draws once before the next picture of the screen.
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
