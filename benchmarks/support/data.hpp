// Generates the meshes that are measured, as the flat arrays of <concino/mesh/arrays.hpp>.
//
// Surfaces resemble a scan that was reconstructed by marching cubes and then refined: a closed bumpy torus with random diagonals (4 to 8 triangles at a
// vert). Verts and triangles are numbered in the order of a sweep through thin slabs, and the first corner of each triangle is random. The mesh is then
// split 1-to-4 twice, and new verts are numbered after the old. So neighbours are mostly close to each other in memory, but not as close as in a grid; the
// files of the Stanford bunny are similar. A triangle mesh from a file can replace the torus.
//
// Volumes are grids, numbered in the order of the grid as hex meshers and voxel tools write them, with verts moved a little.
#pragma once

#include "../floor/cells.hpp"
#include "../floor/polyhedra.hpp"
#include "../floor/surface.hpp"

#include <concino/mesh/arrays.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace bench {

using concino::cell_arrays;
using concino::face_id;
using concino::polyhedra_arrays;
using concino::surface_arrays;
using concino::vec3;
using concino::vert_id;
using floors::u32;

// Conversions between the library's arrays and the containers of the floors.

inline floors::buffer<double> flat(const std::vector<vec3>& points) {
  floors::buffer<double> x(3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) x[3 * i + k] = points[i][k];
  return x;
}

template<class Id>
floors::buffer<u32> flat(const std::vector<Id>& ids) {
  floors::buffer<u32> x(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    if constexpr (requires { ids[i].raw(); }) x[i] = ids[i].raw();
    else x[i] = ids[i];
  return x;
}

template<u32 K>
floors::surface<K> flat_surface(const surface_arrays& a) {
  floors::surface<K> m;
  m.points = flat(a.points);
  m.p2v = flat(a.verts);
  if constexpr (K == 0) m.p_off = flat(a.offsets);
  return m;
}

template<class S>
floors::cells<S> flat_cells(const cell_arrays& a) {
  floors::cells<S> m;
  m.points = flat(a.points);
  m.p2v = flat(a.verts);
  return m;
}

inline floors::polyhedra flat_polyhedra(const polyhedra_arrays& a) {
  floors::polyhedra m;
  m.points = flat(a.points);
  m.f_off = flat(a.face_offsets);
  m.f2v = flat(a.face_verts);
  m.p_off = flat(a.poly_offsets);
  m.p2f = flat(a.poly_faces);
  for (std::size_t k = 0; k < a.outward.size(); ++k)
    if (a.outward[k]) m.p2f[k] |= floors::polyhedra::outward;
  return m;
}

template<u32 K>
floors::surface<K> built(const surface_arrays& a) {
  auto m = flat_surface<K>(a);
  build(m);
  return m;
}

template<class S>
floors::cells<S> built(const cell_arrays& a) {
  auto m = flat_cells<S>(a);
  build(m);
  return m;
}

// Surfaces.

/// A closed torus of 2 * rows * columns triangles; rows, columns >= 3.
inline surface_arrays torus(u32 rows, u32 columns) {
  std::mt19937 random(7);
  auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const u32 n = rows * columns;
  std::vector<vec3> points(n);
  for (u32 i = 0; i < rows; ++i)
    for (u32 j = 0; j < columns; ++j) {
      const double turn = 2 * 3.14159265358979323846;
      const double a = turn * (i + 0.5 * uniform()) / rows, b = turn * (j + 0.5 * uniform()) / columns;
      const double r = 0.3 + 0.04 * std::sin(3 * a + 5 * b) + 0.02 * std::sin(11 * a) * std::cos(17 * b), s = 0.65 + r * std::cos(a);
      points[i * columns + j] = {s * std::cos(b), s * std::sin(b), r * std::sin(a)};
    }
  std::vector<std::array<u32, 3>> triangles;
  for (u32 i = 0; i < rows; ++i)
    for (u32 j = 0; j < columns; ++j) {
      const u32 k = (i + 1) % rows, l = (j + 1) % columns;
      const u32 a = i * columns + j, b = k * columns + j, c = k * columns + l, d = i * columns + l;
      if (random() % 2) triangles.insert(triangles.end(), {{a, c, b}, {a, d, c}});
      else triangles.insert(triangles.end(), {{a, d, b}, {b, d, c}});
    }

  // The sweep: slabs a little thicker than a triangle, orthogonal to a direction that is no coordinate axis.
  const double slab = 3 / std::sqrt(static_cast<double>(n));
  auto key = [&](const vec3& p) {
    const vec3 q(0.8 * p.x + 0.6 * p.z, p.y, 0.8 * p.z - 0.6 * p.x);
    return std::array<double, 3>{std::floor(q.z / slab), std::floor(q.y / slab), q.x};
  };
  std::vector<u32> order(n), number(n);
  std::iota(order.begin(), order.end(), u32{0});
  std::sort(order.begin(), order.end(), [&](u32 a, u32 b) { return key(points[a]) < key(points[b]); });
  surface_arrays m;
  m.arity = 3;
  for (u32 i = 0; i < n; ++i) {
    number[order[i]] = i;
    m.points.push_back(points[order[i]]);
  }
  std::vector<std::pair<std::array<double, 3>, u32>> sweep;
  for (u32 t = 0; t < triangles.size(); ++t) {
    const auto& x = triangles[t];
    sweep.push_back({key((points[x[0]] + points[x[1]] + points[x[2]]) / 3), t});
  }
  std::sort(sweep.begin(), sweep.end());
  for (const auto& [where, t] : sweep)
    for (u32 first = static_cast<u32>(random() % 3), i = 0; i < 3; ++i) m.verts.emplace_back(number[triangles[t][(first + i) % 3]]);
  return m;
}

/// Splits each triangle into four at the midpoints of its edges.
inline surface_arrays split_triangles(const surface_arrays& a) {
  const auto m = built<3>(a);
  const u32 nv = m.num_verts();
  surface_arrays r;
  r.arity = 3;
  r.points = a.points;
  for (u32 e = 0; e < m.num_edges(); ++e) r.points.push_back((a.points[m.e2v[2 * e]] + a.points[m.e2v[2 * e + 1]]) / 2);
  for (u32 p = 0; p < m.num_polys(); ++p) {
    const u32 *v = &m.p2v[3 * p], *e = &m.p2e[3 * p];
    for (u32 i : {v[0], nv + e[0], nv + e[2], v[1], nv + e[1], nv + e[0], v[2], nv + e[2], nv + e[1], nv + e[0], nv + e[1], nv + e[2]})
      r.verts.emplace_back(i);
  }
  return r;
}

/// Splits each poly of K verts into K quads around its centroid.
template<u32 K>
surface_arrays split_into_quads(const surface_arrays& a) {
  const auto m = built<K>(a);
  const u32 nv = m.num_verts(), ne = m.num_edges();
  surface_arrays r;
  r.arity = 4;
  r.points = a.points;
  for (u32 e = 0; e < ne; ++e) r.points.push_back((a.points[m.e2v[2 * e]] + a.points[m.e2v[2 * e + 1]]) / 2);
  for (u32 p = 0; p < m.num_polys(); ++p) {
    vec3 c;
    for (u32 i = 0; i < K; ++i) c += a.points[m.p2v[K * p + i]];
    r.points.push_back(c / K);
    for (u32 i = 0; i < K; ++i)
      for (u32 v : {m.p2v[K * p + i], nv + m.p2e[K * p + i], nv + ne + p, nv + m.p2e[K * p + (i + K - 1) % K]}) r.verts.emplace_back(v);
  }
  return r;
}

/// The dual of a closed triangle mesh: a vert per triangle, a polygon per vert.
inline surface_arrays dual_polygons(const surface_arrays& a) {
  const auto m = built<3>(a);
  surface_arrays r;
  for (u32 p = 0; p < m.num_polys(); ++p)
    r.points.push_back((a.points[m.p2v[3 * p]] + a.points[m.p2v[3 * p + 1]] + a.points[m.p2v[3 * p + 2]]) / 3);
  r.offsets.push_back(0);
  for (u32 v = 0; v < m.num_verts(); ++v) {
    const u32 start = m.v2p[m.vp_off[v]];
    u32 p = start;
    do {
      r.verts.emplace_back(p);
      u32 i = 0;
      while (m.p2v[3 * p + i] != v) ++i;
      p = m.p2p[3 * p + (i + 2) % 3];
    } while (p != start);
    r.offsets.push_back(static_cast<u32>(r.verts.size()));
  }
  return r;
}

// Volumes.

/// (n + 1)^3 points of a grid; those inside are moved by up to `jitter` times the size of a cell.
inline std::vector<vec3> grid_points(u32 n, double jitter) {
  std::mt19937 random(11);
  auto shift = [&](u32 i) { return i == 0 || i == n ? 0.0 : jitter * (static_cast<double>(random()) / 2147483648.0 - 1); };
  std::vector<vec3> points;
  for (u32 k = 0; k <= n; ++k)
    for (u32 j = 0; j <= n; ++j)
      for (u32 i = 0; i <= n; ++i) points.emplace_back(i + shift(i), j + shift(j), k + shift(k));
  return points;
}

inline cell_arrays hex_grid(u32 n) {
  cell_arrays m;
  m.arity = 8;
  m.points = grid_points(n, 0.1);
  const u32 y = n + 1, z = y * y;
  for (u32 k = 0; k < n; ++k)
    for (u32 j = 0; j < n; ++j)
      for (u32 i = 0; i < n; ++i) {
        const u32 a = i + y * j + z * k;
        for (u32 v : {a, a + 1, a + 1 + y, a + y, a + z, a + 1 + z, a + 1 + y + z, a + y + z}) m.verts.emplace_back(v);
      }
  return m;
}

/// A grid of cubes, each split into six tets around its diagonal (Kuhn 1960), so that the faces of neighbouring cubes match.
inline cell_arrays tet_grid(u32 n) {
  cell_arrays m;
  m.points = grid_points(n, 0.1);
  const u32 y = n + 1, z = y * y;
  const u32 step[3] = {1, y, z};
  for (u32 k = 0; k < n; ++k)
    for (u32 j = 0; j < n; ++j)
      for (u32 i = 0; i < n; ++i)
        for (const std::array<u32, 3>& way : {std::array<u32, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}) {
          const u32 a = i + y * j + z * k, b = a + step[way[0]], c = b + step[way[1]], d = c + step[way[2]];
          const bool even = (way[0] + 1) % 3 == way[1];
          for (u32 v : {a, b, even ? c : d, even ? d : c}) m.verts.emplace_back(v);
        }
  return m;
}

inline polyhedra_arrays hexes_as_polyhedra(u32 n) {
  const auto a = hex_grid(n);
  const auto m = built<floors::hex_shape>(a);
  polyhedra_arrays r;
  r.points = a.points;
  r.face_offsets.push_back(0);
  for (u32 f = 0; f < m.num_faces(); ++f) {
    for (u32 i : floors::hex_shape::face[m.f2h[f] % 6]) r.face_verts.push_back(a.verts[m.f2h[f] / 6 * 8 + i]);
    r.face_offsets.push_back(static_cast<u32>(r.face_verts.size()));
  }
  r.poly_offsets.push_back(0);
  for (u32 h = 0; h < m.p2f.size(); ++h) {
    r.poly_faces.emplace_back(m.p2f[h]);
    r.outward.push_back(m.f2h[m.p2f[h]] == h);
    if (h % 6 == 5) r.poly_offsets.push_back(h + 1);
  }
  return r;
}

/// The dual of the tet grid: a vert per tet and per boundary triangle, a polyhedron per vert. Each face of a polyhedron is the ring of tets around an edge of
/// its vert; at a boundary edge the two boundary triangles close the ring. A boundary vert has one face more: the ring of the boundary triangles around it.
inline polyhedra_arrays dual_polyhedra(u32 n) {
  using shape = floors::tet_shape;
  const auto a = tet_grid(n);
  const auto m = built<shape>(a);
  const u32 nv = m.num_verts(), np = m.num_polys();
  polyhedra_arrays r;
  for (u32 p = 0; p < np; ++p) {
    vec3 c;
    for (u32 i = 0; i < 4; ++i) c += a.points[m.p2v[4 * p + i]];
    r.points.push_back(c / 4);
  }
  std::vector<u32> outside(m.p2p.size(), floors::none);   // half-face at the boundary -> its dual vert
  for (u32 h = 0; h < m.p2p.size(); ++h)
    if (m.p2p[h] == floors::none) {
      vec3 c;
      for (u32 i : shape::face[h % 4]) c += a.points[m.p2v[h / 4 * 4 + i]];
      outside[h] = static_cast<u32>(r.points.size());
      r.points.push_back(c / 3);
    }

  std::vector<std::vector<std::pair<u32, bool>>> cells(nv);   // used only while generating
  r.face_offsets.push_back(0);
  auto corner_of = [&](u32 p, u32 v) {
    u32 i = 0;
    while (m.p2v[4 * p + i] != v) ++i;
    return i;
  };
  for (u32 e = 0; e < m.num_edges(); ++e) {
    const u32 v = m.e2v[2 * e], w = m.e2v[2 * e + 1], start = m.e2p[e];
    u32 i = corner_of(start, v), j = corner_of(start, w), ends[2] = {floors::none, floors::none};
    for (u32 k = 0, n_ends = 0; k < 4; ++k)
      if (k != i && k != j) ends[n_ends++] = k;
    // Walks from `start` through the face that lacks local corner `skip`, until the boundary or back to the start.
    auto walk = [&](u32 skip, std::vector<u32>& ring) {
      for (u32 p = start;;) {
        const u32 half = 4 * p + 3 - skip;   // in this shape the face that lacks corner s is the (3-s)th
        const u32 q = m.p2p[half];
        if (q == floors::none) { ring.push_back(outside[half]); return false; }
        if (q == start) return true;
        // The next face is the one that lacks the corner shared with p that is not on the edge.
        u32 next = 0;
        for (u32 k = 0; k < 4; ++k) {
          const u32 x = m.p2v[4 * q + k];
          if (x == v || x == w) continue;
          for (u32 l = 0; l < 4; ++l)
            if (m.p2v[4 * p + l] == x) next = k;
        }
        ring.push_back(q);
        p = q;
        skip = next;
      }
    };
    std::vector<u32> ring, back;
    if (!walk(ends[0], ring)) walk(ends[1], back);
    std::reverse(back.begin(), back.end());
    back.push_back(start);
    back.insert(back.end(), ring.begin(), ring.end());
    vec3 normal;
    for (std::size_t k = 0; k < back.size(); ++k) normal += concino::cross(r.points[back[k]], r.points[back[(k + 1) % back.size()]]);
    const bool from_v = concino::dot(normal, a.points[w] - a.points[v]) > 0;
    const u32 f = static_cast<u32>(r.face_offsets.size() - 1);
    cells[v].push_back({f, from_v});
    cells[w].push_back({f, !from_v});
    for (u32 x : back) r.face_verts.emplace_back(x);
    r.face_offsets.push_back(static_cast<u32>(r.face_verts.size()));
  }
  // The boundary triangles around each boundary vert. After each follows its neighbour at the edge from the vert to its next corner.
  std::vector<std::array<u32, 3>> around;   // vert, next corner, half-face; sorted by vert
  std::vector<std::array<u32, 3>> at;
  for (u32 h = 0; h < outside.size(); ++h)
    if (outside[h] != floors::none)
      for (u32 i = 0; i < 3; ++i) {
        auto x = [&](u32 k) { return m.p2v[h / 4 * 4 + shape::face[h % 4][k % 3]]; };
        at.push_back({x(i), x(i + 1), h});
        around.push_back({x(i), x(i + 2), h});
      }
  std::sort(at.begin(), at.end());
  std::sort(around.begin(), around.end());
  auto last_corner = [&](u32 v, u32 h) {
    for (auto k = std::lower_bound(around.begin(), around.end(), std::array<u32, 3>{v, 0, 0}); k != around.end() && (*k)[0] == v; ++k)
      if ((*k)[2] == h) return (*k)[1];
    return floors::none;
  };
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (k && at[k][0] == at[k - 1][0]) continue;
    const u32 v = at[k][0], start = at[k][2];
    u32 h = start;
    do {
      r.face_verts.emplace_back(outside[h]);
      h = (*std::lower_bound(at.begin(), at.end(), std::array<u32, 3>{v, last_corner(v, h), 0}))[2];
    } while (h != start);
    cells[v].push_back({static_cast<u32>(r.face_offsets.size() - 1), true});
    r.face_offsets.push_back(static_cast<u32>(r.face_verts.size()));
  }
  r.poly_offsets.push_back(0);
  for (const auto& cell : cells) {
    for (const auto& [f, outward] : cell) {
      r.poly_faces.emplace_back(f);
      r.outward.push_back(outward);
    }
    r.poly_offsets.push_back(static_cast<u32>(r.poly_faces.size()));
  }
  return r;
}

// The data sets, with their names in the table. `tiny`: generated in the same way with some hundred elements, to test the programs.

struct data_sets {
  bool tiny = false;
  surface_arrays base;   // replaces the torus in all surfaces if it has polys

  surface_arrays once(u32 rows, u32 columns) const { return base.num_polys() ? base : tiny ? torus(4, 5) : torus(rows, columns); }
  surface_arrays bunny() const { return once(94, 152); }                                                // 28,576 triangles
  surface_arrays bunny16() const { return split_triangles(split_triangles(bunny())); }
  surface_arrays tri1m() const { return split_triangles(split_triangles(once(160, 217))); }             // 1,111,040
  surface_arrays poly228k() const { return dual_polygons(bunny16()); }                                  // 228,608
  surface_arrays quad343k() const { return split_into_quads<4>(split_into_quads<3>(bunny())); }         // 342,912
  cell_arrays tet1m() const { return tet_grid(tiny ? 3 : 55); }                                         // 998,250
  cell_arrays hex1m() const { return hex_grid(tiny ? 4 : 100); }
  polyhedra_arrays hex216k() const { return hexes_as_polyhedra(tiny ? 4 : 60); }
  cell_arrays tet200k() const { return tet_grid(tiny ? 3 : 32); }                                       // 196,608
  polyhedra_arrays dual200k() const { return dual_polyhedra(tiny ? 3 : 32); }                           // 35,937 of 196,608 tets
};

}  // namespace bench
