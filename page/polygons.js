// Polygons to draw, whether of a mesh or prepared by the program: flat lists of corners, their triangles and normals.
//   points: coordinates in units of the page; starts, corners: the points of each polygon; triangles: three corners each;
//   mesh: if they are those of one; polygonOf: by triangle; normals: by corner; polys, elements: by polygon, indices in the mesh; bare: by polygon, laid bare by a cut

/// What a program prepared.
function preparedPolygons(data) {
  const a = readArrays(data.arrays), count = a.starts.length - 1, starts = a.starts;
  const triangles = a.triangles.length ? a.triangles : Uint32Array.from({ length: a.corners.length }, (_, i) => i);
  return { ...a, triangles, polygonOf: polygonsOfTriangles(starts, triangles), polys: null, elements: null, bare: a.exposed.length ? a.exposed : null, count };
}

function polygonsOfTriangles(starts, triangles) {
  const corner = new Uint32Array(starts[starts.length - 1]);
  for (let p = 0; p + 1 < starts.length; ++p) corner.fill(p, starts[p], starts[p + 1]);
  const result = new Uint32Array(triangles.length / 3);
  for (let t = 0; t < result.length; ++t) result[t] = corner[triangles[3 * t]];
  return result;
}

/// The polygons of a mesh that are visible if some polys are hidden.
function polygonsOfMesh(mesh, mask) {
  const seen = mesh.visiblePolygons(mask), count = seen.polygon.length, starts = new Uint32Array(count + 1);
  const own = mesh.once("triangles", () => {
    if (!mesh.triangles.length) return null;
    const of = polygonsOfTriangles(mesh.polygonStarts, mesh.triangles), first = new Uint32Array(mesh.numPolygons + 1);
    for (const p of of) ++first[p + 1];
    for (let p = 0; p < mesh.numPolygons; ++p) first[p + 1] += first[p];
    return first;
  });
  let numTriangles = 0;
  seen.polygon.forEach((p, i) => {
    starts[i + 1] = starts[i] + mesh.polygonStarts[p + 1] - mesh.polygonStarts[p];
    numTriangles += own ? own[p + 1] - own[p] : 1;
  });
  const corners = new Uint32Array(starts[count]), triangles = new Uint32Array(3 * numTriangles), polygonOf = new Uint32Array(numTriangles);
  let t = 0;
  for (let i = 0; i < count; ++i) {
    const p = seen.polygon[i], from = mesh.polygonStarts[p], first = starts[i], n = starts[i + 1] - first, turn = seen.turned[i];
    for (let k = 0; k < n; ++k) corners[first + (turn ? n - 1 - k : k)] = mesh.corners[from + k];
    const put = (a, b, c) => {
      polygonOf[t] = i;
      triangles.set(turn ? [first + n - 1 - a, first + n - 1 - c, first + n - 1 - b] : [first + a, first + b, first + c], 3 * t++);
    };
    if (!own) put(0, 1, 2);
    else for (let k = own[p]; k < own[p + 1]; ++k) put(mesh.triangles[3 * k] - from, mesh.triangles[3 * k + 1] - from, mesh.triangles[3 * k + 2] - from);
  }
  const list = { mesh, points: mesh.units, starts, corners, triangles, polygonOf, polys: seen.poly, elements: seen.polygon, bare: seen.bare, count };
  list.normals = smoothNormals(list, mesh.crease);
  return list;
}

/// The mean of the normals around a point that are similar to that of the polygon, weighted by the angles of corners.
function smoothNormals({ points, starts, corners, count }, crease) {
  const own = new Float64Array(3 * count), angles = new Float64Array(corners.length), normals = new Float32Array(3 * corners.length);
  for (let p = 0; p < count; ++p) {
    const first = starts[p], last = starts[p + 1], o = 3 * corners[first];
    let nx = 0, ny = 0, nz = 0;
    for (let c = first; c < last; ++c) {
      const v = 3 * corners[c], before = 3 * corners[c === first ? last - 1 : c - 1], after = 3 * corners[c + 1 === last ? first : c + 1];
      const ax = points[before] - points[v], ay = points[before + 1] - points[v + 1], az = points[before + 2] - points[v + 2];
      const bx = points[after] - points[v], by = points[after + 1] - points[v + 1], bz = points[after + 2] - points[v + 2];
      const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
      angles[c] = Math.atan2(Math.sqrt(x * x + y * y + z * z), ax * bx + ay * by + az * bz);
      if (c < first + 2) continue;
      const px = points[before] - points[o], py = points[before + 1] - points[o + 1], pz = points[before + 2] - points[o + 2];
      const qx = points[v] - points[o], qy = points[v + 1] - points[o + 1], qz = points[v + 2] - points[o + 2];
      nx += py * qz - pz * qy; ny += pz * qx - px * qz; nz += px * qy - py * qx;
    }
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (length > 0) { own[3 * p] = nx / length; own[3 * p + 1] = ny / length; own[3 * p + 2] = nz / length; }
  }
  const around = inverted(points.length / 3, null, corners);
  const polygon = new Uint32Array(corners.length), cosine = Math.cos(crease * Math.PI / 180);
  for (let p = 0; p < count; ++p) polygon.fill(p, starts[p], starts[p + 1]);
  for (let c = 0; c < corners.length; ++c) {
    const p = 3 * polygon[c], ring = listOf(around, corners[c]);
    let x = 0, y = 0, z = 0;
    if (ring.length <= 64) for (const d of ring) {
      const q = 3 * polygon[d];
      if (own[p] * own[q] + own[p + 1] * own[q + 1] + own[p + 2] * own[q + 2] < cosine) continue;
      x += own[q] * angles[d]; y += own[q + 1] * angles[d]; z += own[q + 2] * angles[d];
    }
    const length = Math.sqrt(x * x + y * y + z * z);
    const fits = length > 0;
    normals[3 * c] = fits ? x / length : own[p];
    normals[3 * c + 1] = fits ? y / length : own[p + 1];
    normals[3 * c + 2] = fits ? z / length : own[p + 2];
  }
  return normals;
}

/// The cross-sections of a cut as polygons; `between` says where their points are: [vert, vert, t].
function polygonsOfCut(mesh, cut) {
  const count = cut.sections.length, starts = [0], corners = [], triangles = [];
  const points = new Float64Array(3 * cut.points.length);
  cut.points.forEach((_, i) => points.set(cut.position(i), 3 * i));
  for (const { loop } of cut.sections) {
    const first = corners.length;
    corners.push(...loop);
    starts.push(corners.length);
    for (const t of trianglesOf(loop.map((i) => at3(points, i)))) triangles.push(...t.map((k) => first + k));
  }
  const list = { mesh, points, starts: Uint32Array.from(starts), corners: Uint32Array.from(corners), triangles: Uint32Array.from(triangles),
    polys: cut.sections.map((s) => s.poly), elements: null, bare: new Array(count).fill(true), between: cut.points, count };
  list.polygonOf = polygonsOfTriangles(list.starts, list.triangles);
  list.normals = new Float32Array(3 * corners.length);  // flat: the shader takes the plane of the triangle
  return list;
}

/// An arrow for each vector of a field: a pyramid of three sides. Longest: in units of the page.
function polygonsOfArrows(mesh, field, longest) {
  const n = field.numbers.length / field.width, starts = [0], corners = [], points = [], polys = [];
  let most = 0;
  const length = (i) => Math.hypot(...field.numbers.subarray(field.width * i, field.width * i + field.width));
  for (let i = 0; i < n; ++i) if (Number.isFinite(length(i))) most = Math.max(most, length(i));
  const step = Math.max(1, Math.ceil(n / 20000));
  for (let i = 0; i < n; i += step) {
    const size = length(i) / most;
    if (!(size > 1e-6 && size < Infinity)) continue;
    const at = field.at === "vert" ? mesh.point(i) : toUnit(at3(mesh.centroids, i));
    const v = field.numbers.subarray(field.width * i, field.width * i + field.width);
    const along = unit([v[0], v[1], v[2] ?? 0].map((x) => x / most)), side = unit(cross(along, Math.abs(along[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]));
    const tip = add(at, scaled(along, size * longest)), first = points.length / 3;
    for (let k = 0; k < 3; ++k) points.push(...add(at, scaled(turned(side, along, k * 2 * Math.PI / 3), 0.08 * longest * Math.sqrt(size))));
    points.push(...tip);
    for (const t of [[0, 1, 3], [1, 2, 3], [2, 0, 3], [2, 1, 0]]) { corners.push(...t.map((k) => first + k)); starts.push(corners.length); polys.push(i); }
  }
  const list = { points: Float64Array.from(points), starts: Uint32Array.from(starts), corners: Uint32Array.from(corners),
    triangles: Uint32Array.from(corners, (_, i) => i), polys, elements: null, bare: null, count: polys.length };
  list.polygonOf = Uint32Array.from(polys, (_, i) => i);
  list.normals = new Float32Array(3 * corners.length);
  return list;
}
