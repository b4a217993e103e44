// The mesh that an object keeps if it was added with `inspect`: its elements, who touches whom, and which polys are shown.

/// Lists of lists as two arrays: list i is items[starts[i]] ... items[starts[i + 1] - 1]. Of starts null, each list has one item.
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
  /// The place of the corner of a poly at a vert in the lists of corners, by which values at corners are numbered; -1: there is none.
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
  /// The polys that share a facet with a poly.
  neighboursOf(poly) {
    const beside = this.isVolume ? this.facesOf(poly).flatMap((f) => this.polysOfPolygon(f))
      : this.edgesOfPolygon(poly).flatMap((e) => this.polygonsOfEdge(e));
    return [...new Set(beside)].filter((p) => p !== poly);
  }

  /// By poly: how many layers of polys lie between it and the boundary, as peeled() counts them; 2^32 - 1: no boundary is near.
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

  /// Whether a poly is above a plane, by its centroid, as the criteria below() and above() decide: n.x >= offset.
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

  /// By poly: whether the rules show it.
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

  /// The polygons between what is shown and what is not: their indices, whether they are turned over, laid bare, and of which poly.
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
