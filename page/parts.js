// What the graphics processor has of a thing: corners, colours, textures.

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
  /// For pictures while the view moves: points at the first one in each cell of a grid, and the triangles whose points remain three.
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
  /// isCoarse: few triangles are enough.
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
