// The exact intersection of a volume with a plane: the cross-section of each poly, with values that are linear along edges.

/// Finds cross-sections with { x : n.x = offset } in units of the mesh. Result: points as [vert a, vert b, t] for a + t (b - a), and for each
/// cross-section its poly and the places of its corners in this list, counter-clockwise seen from above the plane.
function crossSections(mesh, mask, n, offset) {
  const heights = new Float64Array(mesh.numVerts);
  for (let v = 0; v < mesh.numVerts; ++v) heights[v] = dot(n, at3(mesh.points, v)) - offset;
  const points = [], sections = [], places = new Map();
  const placeOf = (a, b) => {
    const low = Math.min(a, b), high = Math.max(a, b), key = low * mesh.numVerts + high;
    let i = places.get(key);
    if (i === undefined) {
      places.set(key, i = points.length);
      points.push([low, high, heights[low] / (heights[low] - heights[high])]);
    }
    return i;
  };
  const crossed = (poly) => {
    let above = false, below = false;
    for (let k = mesh.faces.starts[poly]; k < mesh.faces.starts[poly + 1]; ++k) {
      const f = mesh.faces.items[k] >> 1;
      for (let c = mesh.polygonStarts[f]; c < mesh.polygonStarts[f + 1]; ++c) if (heights[mesh.corners[c]] < 0) below = true; else above = true;
    }
    return above && below;
  };
  const position = (i) => mix(mesh.point(points[i][0]), mesh.point(points[i][1]), points[i][2]);
  for (let poly = 0; poly < mesh.numPolys; ++poly) {
    if (!mask[poly] || !crossed(poly)) continue;
    const next = new Map();
    for (let k = mesh.faces.starts[poly]; k < mesh.faces.starts[poly + 1]; ++k) {
      const x = mesh.faces.items[k], loop = mesh.cornersOf(x >> 1), crossings = [];
      for (let i = 0; i < loop.length; ++i) {
        const a = loop[i], b = loop[(i + 1) % loop.length];
        const up = heights[a] < 0 && heights[b] >= 0, down = heights[a] >= 0 && heights[b] < 0;
        if (up || down) crossings.push({ place: placeOf(a, b), up: up === ((x & 1) === 0) });
      }
      if (crossings.length > 2) {  // a polygon that is not convex: pairs along the line in which the plane meets it
        const first = position(crossings[0].place);
        let along = [0, 0, 0];
        for (const c of crossings) { const d = sub(position(c.place), first); if (norm(d) > norm(along)) along = d; }
        crossings.sort((c, d) => dot(along, position(c.place)) - dot(along, position(d.place)));
      }
      for (let i = 0; i + 1 < crossings.length; i += 2) {
        const [c, d] = crossings[i].up ? [crossings[i], crossings[i + 1]] : [crossings[i + 1], crossings[i]];
        next.set(c.place, d.place);
      }
    }
    while (next.size) {
      const [first] = next.keys(), loop = [];
      for (let at = first; at !== undefined && next.has(at); ) {
        loop.push(at);
        const to = next.get(at);
        next.delete(at);
        at = to;
      }
      if (loop.length > 2) sections.push({ poly, loop });
    }
  }
  return { points, sections, position };
}

/// The area of cross-sections, in squares of the units of the page.
function areaOf(cut, n) {
  let sum = [0, 0, 0];
  for (const { loop } of cut.sections) {
    const o = cut.position(loop[0]);
    for (let i = 2; i < loop.length; ++i) sum = add(sum, cross(sub(cut.position(loop[i - 1]), o), sub(cut.position(loop[i]), o)));
  }
  return Math.abs(dot(sum, unit(n))) / 2;
}
