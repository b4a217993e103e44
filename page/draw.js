// Draws the things by WebGL 2.

const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
let program, uniforms, pickBuffer;

function makeProgram() {
  program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, shaders.surface_vert], [gl.FRAGMENT_SHADER, shaders.surface_frag]]) {
    const s = gl.createShader(type);
    gl.shaderSource(s, text.trim());
    gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(s));
    gl.attachShader(program, s);
  }
  ["position", "normal", "flags", "value", "paint", "sides", "texture_place"].forEach((name, i) => gl.bindAttribLocation(program, i, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
  uniforms = {};
  for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
    const name = gl.getActiveUniform(program, i).name.replace(/\[0\]$/, "");
    uniforms[name] = gl.getUniformLocation(program, name);
  }
  const color = gl.createRenderbuffer(), depth = gl.createRenderbuffer();
  pickBuffer = gl.createFramebuffer();  // of one pixel
  gl.bindFramebuffer(gl.FRAMEBUFFER, pickBuffer);
  for (const [buffer, format, place] of [[color, gl.RGBA8, gl.COLOR_ATTACHMENT0], [depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, 1, 1);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
  }
}

/// What is sent to the graphics processor for a list of polygons.
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

  /// Sends the values or colours that the thing shows now.
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
        bytes.set(rgb.subarray(3 * k, 3 * k + 3), 4 * i);
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
  free() {
    for (const b of this.buffers) gl.deleteBuffer(b);
    gl.deleteVertexArray(this.array);
  }
}

/// By corner of the triangles: texture coordinates.
function texturePlaces(list, { at, numbers }) {
  const places = new Float32Array(2 * list.triangles.length);
  for (let i = 0; i < list.triangles.length; ++i) {
    const c = list.triangles[i], v = list.corners[c];
    const k = at === "vert" ? v : list.mesh ? list.mesh.cornerAt(list.polys[list.polygonOf[Math.floor(i / 3)]], v) : c;
    for (let j = 0; j < 2; ++j) places[2 * i + j] = Number.isFinite(numbers[2 * k + j]) ? numbers[2 * k + j] : noValue;
  }
  return places;
}

/// A picture for a texture, with smaller ones for where it is small. Colours are times their opacities.
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

/// Sends polygons, colours and maps of a thing again.
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
  const u = uniforms, look = thing.data.look, isArrow = part.role === "arrows";
  const hasValues = thing.field && !isArrow && !thing.edgesHaveValues;
  gl.uniform1i(u.cuts, slicing.exact ? planesOn().reduce((bits, { k }) => bits | (k === part.plane ? 0 : 1 << k), 0) : 0);
  gl.uniform1i(u.flat_shading, thing.flat || part.role !== "surface" ? 1 : 0);
  gl.uniform1i(u.coloring, hasValues ? (thing.isLabels ? 3 : 2) : thing.chosen === "painted" && part.role === "surface" ? 1 : 0);
  gl.uniform3fv(u.color, isArrow ? [0.02, 0.02, 0.025] : thing.color);
  gl.uniform3fv(u.exposed_color, look.exposed_color);
  gl.uniform3fv(u.no_value, look.no_value);
  gl.uniform3fv(u.edge_color, look.edge_color);
  const [low, high] = thing.field ? thing.baseRange : [0, 0];  // equal: all values are in the middle of the map
  const knots = high > low ? thing.scale.slice(0, 18).map(([x, t]) => [Math.max(-1e29, Math.min(1e29, fraction(x, thing.baseRange))), t]) : [[0, 0], [1, 1]];
  gl.uniform2fv(u.knots, knots.flat());
  gl.uniform1i(u.num_knots, knots.length);
  gl.uniform1f(u.bands, thing.bands);
  gl.uniform1f(u.lines, thing.lines);
  gl.uniform1f(u.edge_width, thing.wire && !isArrow ? (look.edge_width || 1.3) * pixelScale() : 0);
  gl.uniform1i(u.edges_have_values, thing.edgesHaveValues && part.role === "surface" ? 1 : 0);
  gl.uniform1f(u.opacity, isArrow ? 1 : thing.opacity);
  gl.uniform1f(u.shine, look.shine);
  gl.uniform1i(u.has_ball, thing.ball ? 1 : 0);
  gl.uniform1i(u.picking, pick ? pick : 0);
  const texture = thing.textured && part.role === "surface" ? thing.texture : null;
  gl.uniform1i(u.texture_kind, texture ? texture.kind : 0);
  if (texture) {
    gl.uniform2f(u.texture_size, texture.count, texture.width * pixelScale());
    gl.uniform3fv(u.texture_first, texture.first);
    gl.uniform3fv(u.texture_second, texture.second);
  }
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D, thing.picture ?? thing.mapTexture);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, thing.mapTexture);
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D, thing.ball ?? thing.mapTexture);
  gl.bindVertexArray(part.array);
  gl.drawArrays(gl.TRIANGLES, 0, part.count);
}

function setCamera() {
  gl.useProgram(program);
  gl.uniformMatrix4fv(uniforms.project, false, projection());
  const { right: r, up, back: b } = camera;
  gl.uniformMatrix3fv(uniforms.turn, false, [r[0], up[0], b[0], r[1], up[1], b[1], r[2], up[2], b[2]]);
  gl.uniform1i(uniforms.parallel, camera.parallel ? 1 : 0);
  gl.uniform3fv(uniforms.eye, eyeOf());
  const planes = new Float32Array(16);
  for (const p of planesOn()) planes.set(unitPlane(p), 4 * p.k);
  gl.uniform4fv(uniforms.planes, planes);
  gl.uniform1i(uniforms.map, 0);
  gl.uniform1i(uniforms.ball, 1);
  gl.uniform1i(uniforms.picture, 2);
  gl.vertexAttrib3f(5, noValue, noValue, noValue);
}

const paper = () => (document.documentElement.dataset.theme === "dark" ? [0.09, 0.094, 0.11] : [1, 1, 1]);

/// Pixels of the drawing for each of the page: fewer while the view moves if drawing is slow.
const pixelScale = () => devicePixelRatio * (motion.coarse ? 0.4 : 1);

function drawScene() {
  const width = Math.max(1, Math.round(canvas.clientWidth * pixelScale())), height = Math.max(1, Math.round(canvas.clientHeight * pixelScale()));
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.viewport(0, 0, width, height);
  gl.clearColor(...paper(), 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.disable(gl.CULL_FACE);
  setCamera();
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
  drawMarks();
}

const motion = { coarse: false, last: 0, slow: 0, timer: 0 };
/// The view moves: when pictures take longer than 80 ms, they are coarse until it rests.
function redrawMoving() {
  const now = performance.now(), time = now - motion.last;
  motion.last = now;
  if (time < 2000 && !motion.coarse) motion.slow = time > 80 ? motion.slow + 1 : 0;
  if (motion.slow >= 3) motion.coarse = true;
  clearTimeout(motion.timer);
  motion.timer = setTimeout(() => { motion.coarse = false; redraw(); }, 300);
  redraw();
}

let requested = false;
/// Draws once before the next picture of the screen.
function redraw() {
  if (requested) return;
  requested = true;
  requestAnimationFrame(() => { requested = false; followFingers(); if (!gl.isContextLost()) drawScene(); });
}
