// What is under the pointer: the thing, the element, its neighbours and values; distances; marks over the picture.

let picked = null;    // { thing, kind, index, point }
let measured = [];    // one or two points in units of the page

/// The triangle at a pixel of the page: { thing, part, triangle }, or null. Only this pixel is drawn.
function triangleAt(x, y) {
  const box = canvas.getBoundingClientRect();
  gl.bindFramebuffer(gl.FRAMEBUFFER, pickBuffer);
  gl.viewport(-Math.floor(x - box.left), Math.floor(y - box.top) + 1 - canvas.clientHeight, canvas.clientWidth, canvas.clientHeight);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.disable(gl.BLEND);
  ++cameraChanges.count;
  const candidates = things.filter((t) => t.visible).flatMap((thing) => thing.parts.filter((p) => p.role !== "arrows").map((part) => ({ thing, part })));
  candidates.slice(0, 255).forEach(({ thing, part }, i) => drawPart(thing, part, i + 1));
  const rgba = new Uint8Array(4);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return rgba[0] === 0 ? null : { ...candidates[rgba[0] - 1], triangle: rgba[1] + 256 * rgba[2] + 65536 * rgba[3] };
}

/// The point where the ray through a pixel meets the plane of a triangle.
function pointOn({ part, triangle }, x, y) {
  const { list } = part, [a, b, c] = [0, 1, 2].map((k) => at3(list.points, list.corners[list.triangles[3 * triangle + k]]));
  const ray = rayThrough(x, y), n = cross(sub(b, a), sub(c, a)), slope = dot(n, ray.direction);
  return slope === 0 ? a : add(ray.origin, scaled(ray.direction, dot(n, sub(a, ray.origin)) / slope));
}

const pixelDistance = (p, x, y) => {
  const box = canvas.getBoundingClientRect(), q = pixelOf(p);
  return q ? Math.hypot(q[0] - (x - box.left), q[1] - (y - box.top)) : Infinity;
};
function nearestOnEdge(a, b, p) {
  const d = sub(b, a), t = dot(d, d) > 0 ? Math.min(1, Math.max(0, dot(sub(p, a), d) / dot(d, d))) : 0;
  return mix(a, b, t);
}

/// Picks what is at a pixel; `wanted`: "any" or a kind of elements.
function pickAt(x, y, wanted = "any") {
  const hit = triangleAt(x, y);
  if (!hit) return null;
  const { thing, part } = hit, { list } = part, mesh = thing.mesh, point = pointOn(hit, x, y), polygon = list.polygonOf[hit.triangle];
  if (!mesh) return { thing, kind: "polygon", index: polygon, point };
  const poly = list.polys[polygon];
  if (!list.elements) return { thing, kind: "poly", index: poly, point };
  const element = list.elements[polygon], verts = [...mesh.cornersOf(element)];
  const nearest = (items, distance) => items.reduce((best, i) => (distance(i) < distance(best) ? i : best));
  const vert = nearest(verts, (v) => pixelDistance(mesh.point(v), x, y));
  const edges = mesh.edgesOfPolygon(element).filter((e) => e >= 0);
  const ends = (e) => [mesh.point(mesh.edges[2 * e]), mesh.point(mesh.edges[2 * e + 1])];
  const edgeDistance = (e) => pixelDistance(nearestOnEdge(...ends(e), point), x, y);
  const edge = edges.length ? nearest(edges, edgeDistance) : -1;
  if (wanted === "vert" || (wanted === "any" && pixelDistance(mesh.point(vert), x, y) < 7)) return { thing, kind: "vert", index: vert, point };
  if (edge >= 0 && (wanted === "edge" || (wanted === "any" && edgeDistance(edge) < 4))) return { thing, kind: "edge", index: edge, point };
  if (wanted === "face" && mesh.isVolume) return { thing, kind: "face", index: element, point };
  return { thing, kind: "poly", index: poly, face: mesh.isVolume ? element : undefined, point };
}

/// The elements of a kind: how many indices there are, and whether one has an element.
const boundOf = (mesh, kind) => ({ vert: mesh.numVerts, edge: mesh.edges.length / 2, face: mesh.isVolume ? mesh.numPolygons : 0, poly: mesh.numPolys })[kind] ?? 0;
function hasElement(mesh, kind, i) {
  if (!(Number.isInteger(i) && i >= 0 && i < boundOf(mesh, kind))) return false;
  if (kind === "vert") return Number.isFinite(mesh.points[3 * i]);
  if (kind === "edge") return mesh.edges[2 * i] !== mesh.edges[2 * i + 1];
  return kind === "poly" ? mesh.hasPoly(i) : mesh.polygonStarts[i + 1] > mesh.polygonStarts[i];
}
function middleOf(mesh, kind, i) {
  const verts = kind === "vert" ? [i] : kind === "edge" ? [...mesh.edges.subarray(2 * i, 2 * i + 2)] : kind === "poly" ? mesh.vertsOfPoly(i) : [...mesh.cornersOf(i)];
  return scaled(verts.map((v) => mesh.point(v)).reduce(add), 1 / verts.length);
}

/// Picks an element by its index and shows it in the middle.
function goTo(thing, kind, index) {
  if (!thing?.mesh || !hasElement(thing.mesh, kind, index)) return false;
  picked = { thing, kind, index, point: middleOf(thing.mesh, kind, index) };
  camera.target = picked.point;
  return true;
}

/// Names and values of what is picked, as pairs of texts.
function describe({ thing, kind, index, face, point }) {
  const rows = [["object", thing.name], ["element", `${kind} ${index}`]], mesh = thing.mesh, few = (list) => {
    const texts = [...list].slice(0, 24).map(String);
    return texts.join(" ") + (list.length > 24 ? ` … ${list.length} in all` : list.length ? "" : "none");
  };
  if (!mesh) return [...rows, ["point", toMesh(point).map(textOf).join(", ")], ...valueRows(thing, "polygon", index, point)];
  if (face !== undefined) rows.push(["face", String(face)]);
  if (kind === "vert") {
    rows.push(["position", at3(mesh.points, index).map(textOf).join(", ")]);
    const edges = listOf(mesh.edgesOfVert, index);
    rows.push(["verts beside it", few([...edges].map((e) => mesh.edges[2 * e] + mesh.edges[2 * e + 1] - index))], ["edges", few(edges)]);
    rows.push(["polys", few(mesh.polysOfVert(index))]);
  } else if (kind === "edge") {
    const [a, b] = mesh.edges.subarray(2 * index, 2 * index + 2), polygons = mesh.polygonsOfEdge(index);
    rows.push(["verts", `${a} ${b}`], ["length", textOf(norm(sub(mesh.point(a), mesh.point(b))) * scene.radius)]);
    if (mesh.isVolume) rows.push(["faces", few(polygons)]);
    rows.push(["polys", few([...new Set(polygons.flatMap((p) => mesh.polysOfPolygon(p)))])]);
  } else if (kind === "face") rows.push(["verts", few(mesh.cornersOf(index))], ["polys", few(mesh.polysOfPolygon(index))]);
  else {
    rows.push(["verts", few(mesh.vertsOfPoly(index))], ["polys beside it", few(mesh.neighboursOf(index))]);
    if (mesh.isVolume) rows.push(["faces", few(mesh.facesOf(index))]);
    rows.push(["centroid", at3(mesh.centroids, index).map(textOf).join(", ")]);
  }
  return [...rows, ...valueRows(thing, kind, index)];
}
function valueRows(thing, kind, index) {
  const textAt = (f, i) => (f.texts ? f.texts[i] : [...f.numbers.subarray(f.width * i, f.width * i + f.width)].map(textOf).join(", "));
  const rows = thing.fields.filter((f) => f.at === kind || f.at === "mesh").map((f) => [f.name, textAt(f, f.at === "mesh" ? 0 : index)]);
  if (!thing.mesh || (kind !== "poly" && kind !== "vert")) return rows;
  const beside = kind === "poly" ? thing.mesh.vertsOfPoly(index) : thing.mesh.polysOfVert(index);
  for (const f of thing.fields.filter((g) => g.at === "corner")) {
    const texts = beside.slice(0, 24).map((x) => `${x}: ${textAt(f, kind === "poly" ? thing.mesh.cornerAt(index, x) : thing.mesh.cornerAt(x, index))}`);
    rows.push([`${f.name}, by ${kind === "poly" ? "vert" : "poly"}`, texts.join("; ")]);
  }
  return rows;
}

/// Marks what is picked and measured, and places texts.
function drawMarks() {
  const svg = byId("marks"), shape = (name, attributes) => {
    const e = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
    return e;
  };
  svg.replaceChildren();
  const pixels = (points) => points.map(pixelOf).filter(Boolean);
  const outline = (points, closed = true) => svg.append(shape(closed ? "polygon" : "polyline", { class: "mark", points: pixels(points).map((p) => p.join()).join(" ") }));
  const dot2 = (p) => { const q = pixelOf(p); if (q) svg.append(shape("circle", { class: "mark", cx: q[0], cy: q[1], r: 5 })); };
  if (picked?.thing.mesh) {
    const { thing: { mesh }, kind, index } = picked, loop = (f) => [...mesh.cornersOf(f)].map((v) => mesh.point(v));
    if (kind === "vert") dot2(mesh.point(index));
    else if (kind === "edge") outline([0, 1].map((k) => mesh.point(mesh.edges[2 * index + k])), false);
    else if (kind === "face" || !mesh.isVolume) outline(loop(index));
    else for (const f of mesh.facesOf(index)) outline(loop(f));
  } else if (picked) dot2(picked.point);
  if (measured.length === 2) svg.append(shape("polyline", { class: "measure", points: pixels(measured).map((p) => p.join()).join(" ") }));
  measured.forEach(dot2);
  const texts = byId("texts");
  while (texts.children.length < scene.labels.length) texts.append(make("span", { dir: "auto", textContent: scene.labels[texts.children.length].text }));
  scene.labels.forEach(({ at }, i) => {
    const p = pixelOf(toUnit(at)), e = texts.children[i];
    e.hidden = !p;
    if (p) e.style.transform = `translate(${p[0] + 8}px, ${p[1] - 24}px)`;
  });
}
