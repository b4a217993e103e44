// The things of the scene, what the user chose for each, and the polygons that follow from it.

const slicing = { exact: false, direction: [1, 1, 1], planes: [0, 1, 2, 3].map(() => ({ on: false, keepsAbove: false, t: 0.5 })) };

/// The plane k in units of the mesh; what is above it, n.x >= offset, is hidden.
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
/// The same in units of the page, for the shader.
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

  /// The field that gives the colours, if one does.
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
  /// The range of all finite values.
  fitRange() { if (this.field) this.setRange(...rangeOf(this.numbers)); }
  setRange(low, high) {
    this.scale = [[low, 0], [Math.max(low, high), 1]];
    this.baseRange = [low, Math.max(low, high)];
  }

  /// The map of colours as 256 sRGB triples.
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

  /// By poly: what is shown. Exact cuts leave all polys, and the shader cuts them.
  mask() {
    const f = this.filter, field = this.polyFields[f.field], rules = { layers: f.layers, planes: slicing.exact ? [] : planesOn(), values: null };
    if (f.on && field) {
      const labels = f.labels.trim() ? new Set(f.labels.split(/[\s,;]+/).filter(Boolean).map(Number)) : null;
      rules.values = { numbers: field.numbers, low: f.low, high: f.high, labels };
    }
    return this.mesh.visiblePolys(rules);
  }
  get polyFields() { return this.fields.filter((f) => f.at === "poly" && f.width === 1 && f.numbers); }

  /// The lists of polygons to draw: the surface, the cross-sections, the arrows.
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

/// Visits the points of all things, in units of the page.
function forEachPoint(visit) {
  for (const thing of things) {
    if (!thing.visible) continue;
    const all = thing.mesh ? thing.mesh.units : thing.prepared.points;
    for (let i = 0; i < all.length; i += 3) if (Number.isFinite(all[i] + all[i + 1] + all[i + 2])) visit([all[i], all[i + 1], all[i + 2]]);
  }
}
