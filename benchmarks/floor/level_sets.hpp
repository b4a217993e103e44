// The floors of level sets, for triangles and tets in flat arrays only: no vert lies on the level set, and no value is NaN.
#pragma once

#include "normals.hpp"

namespace bench::floors {

/// The point where a function with the values `from` and `to` at a and b has the value `level`.
inline vector3 crossing(vector3 a, vector3 b, double from, double to, double level) {
  const double t = (level - from) / (to - from);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The level set on triangles as segments, in no order: two points each.
inline buffer<vector3> level_segments(const buffer<double>& points, const buffer<u32>& p2v, const buffer<double>& u, double level) {
  buffer<vector3> ends;
  for (u32 c = 0; c != p2v.size(); c += 3) {
    const u32* const v = p2v.data() + c;
    const bool above[] = {u[v[0]] >= level, u[v[1]] >= level, u[v[2]] >= level};
    if (above[0] == above[1] && above[1] == above[2]) continue;
    const u32 alone = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;  // the corner on its side of the level set
    const u32 a = v[alone], b = v[(alone + 1) % 3], d = v[(alone + 2) % 3];
    const vector3 x = at(points, a);
    ends.push(crossing(x, at(points, b), u[a], u[b], level));
    ends.push(crossing(x, at(points, d), u[a], u[d], level));
  }
  return ends;
}

/// The polygon across a tet as a cycle of its edges in tet_shape, counter-clockwise seen from the verts above. Bit k of `above` says whether vert k is.
struct tet_polygon { u32 size, edges[4]; };
inline constexpr tet_polygon tet_polygons[16] = {
    {0, {}}, {3, {0, 3, 2}}, {3, {0, 1, 4}}, {4, {2, 1, 4, 3}}, {3, {5, 1, 2}}, {4, {3, 5, 1, 0}}, {4, {2, 5, 4, 0}}, {3, {5, 4, 3}},
    {3, {5, 3, 4}}, {4, {0, 4, 5, 2}}, {4, {0, 1, 5, 3}}, {3, {5, 2, 1}}, {4, {3, 4, 1, 2}}, {3, {0, 4, 1}}, {3, {0, 2, 3}}, {0, {}},
};

/// Marching tets: points and polygons, without adjacencies. Each edge that is crossed has one point.
inline surface<0> level_polygons(const cells<tet_shape>& m, const buffer<double>& u, double level) {
  surface<0> s;
  const u32 np = m.num_polys();
  buffer<u32> number(m.num_edges());  // a bit says whether it is set, so that most pages of it are never touched
  buffer<std::uint64_t> known((m.num_edges() + 63) / 64, 0);
  u32 n = 0;
  s.p_off.push(0);
  for (u32 p = 0; p < np; ++p) {
    const u32 *const v = m.p2v.data() + 4 * p, *const e = m.p2e.data() + 6 * p;
    const u32 above = u32{u[v[0]] >= level} | u32{u[v[1]] >= level} << 1 | u32{u[v[2]] >= level} << 2 | u32{u[v[3]] >= level} << 3;
    if (above == 0 || above == 15) continue;
    const tet_polygon& polygon = tet_polygons[above];
    for (u32 i = 0; i < polygon.size; ++i) {
      const u32 edge = e[polygon.edges[i]];
      const std::uint64_t bit = std::uint64_t{1} << edge % 64;
      if (!(known[edge / 64] & bit)) {
        known[edge / 64] |= bit;
        number[edge] = n++;
        const u32 a = m.e2v[2 * edge], b = m.e2v[2 * edge + 1];
        const vector3 x = crossing(at(m.points, a), at(m.points, b), u[a], u[b], level);
        s.points.push(x.x);
        s.points.push(x.y);
        s.points.push(x.z);
      }
      s.p2v.push(number[edge]);
    }
    s.p_off.push(static_cast<u32>(s.p2v.size()));
  }
  return s;
}

}  // namespace bench::floors
