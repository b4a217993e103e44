// Meshes with many elements at one element: many polys at an edge, a face or a vert, polys with very many verts, many equal polys.
#pragma once

#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/kinds.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace concino::testing {

/// Lists of verts, and their points.
struct dense_mesh {
  std::string name;
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> polys;

  unsigned add(double x, double y, double z) {
    points.push_back({x, y, z});
    return static_cast<unsigned>(points.size() - 1);
  }
  unsigned on_circle(std::size_t i, std::size_t n, double z) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    return add(std::cos(angle), std::sin(angle), z);
  }
  template<class M>
  M mesh() const { return M(points, polys); }
};

inline dense_mesh equal_triangles(unsigned n) { return {"equal triangles", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<std::vector<unsigned>>(n, {0, 1, 2})}; }

/// n triangles at one edge, connected by other triangles at both of its ends.
inline dense_mesh pages(unsigned n) {
  dense_mesh c{"pages on one edge", {{0, 0, 0}, {0, 0, 1}}, {}};
  for (unsigned i = 0; i < n; ++i) c.polys.push_back({0, 1, c.on_circle(i, n, 0.5)});
  for (unsigned i = 0; i + 1 < n; ++i) c.polys.push_back({0, 2 + i, 3 + i});
  return c;
}
/// Equal polygons of n verts. With `leaves` each edge has a triangle too, and every other edge two.
inline dense_mesh equal_polygons(unsigned n, unsigned copies, bool leaves) {
  dense_mesh c{"equal polygons", {}, {}};
  std::vector<unsigned> ring;
  for (unsigned i = 0; i < n; ++i) ring.push_back(c.on_circle(i, n, 0));
  c.polys.assign(copies, ring);
  for (unsigned i = 0; leaves && i < n; ++i)
    for (unsigned k = 0; k <= i % 2; ++k) c.polys.push_back({(i + 1) % n, i, c.on_circle(i, n, k ? -1 : 1)});
  return c;
}
/// A polygon of n verts with n triangles at one of its edges.
inline dense_mesh polygon_with_pages(unsigned n) {
  dense_mesh c = equal_polygons(n, 1, false);
  c.name = "pages on a side of a large polygon";
  for (unsigned i = 0; i < n; ++i) c.polys.push_back({0, 1, c.add(0, 0, i + 1.0)});
  return c;
}
/// A polygon of 4 n + 2 verts, most of whose edges are long and close to one another.
inline dense_mesh comb(unsigned n) {
  dense_mesh c{"comb", {}, {{}}};
  const auto add = [&](double along, double across) { c.polys[0].push_back(c.add(along - across, along + across, 0)); };
  for (unsigned i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) / n, step = 0.25 / n;
    add(0.1, at);
    add(1, at + step);
    add(1, at + 2 * step);
    add(0.1, at + 3 * step);
  }
  add(0, 1);
  add(0, 0);
  return c;
}

inline dense_mesh tets_on_a_face(unsigned n) {
  dense_mesh c{"tets on one face", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  for (unsigned i = 0; i < n; ++i) c.polys.push_back({0, 1, 2, c.add(0.3, 0.3, i + 1.0)});
  return c;
}
/// A ring of n tets around an edge, in which consecutive tets share a face.
inline dense_mesh tets_around_an_edge(unsigned n) {
  dense_mesh c{"tets around one edge", {{0, 0, 0}, {0, 0, 1}}, {}};
  for (unsigned i = 0; i < n; ++i) c.on_circle(i, n, 0.5);
  for (unsigned i = 0; i < n; ++i) c.polys.push_back({2 + i, 2 + (i + 1) % n, 1, 0});
  return c;
}
/// n tets that share only one edge.
inline dense_mesh tets_on_an_edge(unsigned n) {
  dense_mesh c{"tets on one edge", {{0, 0, 0}, {0, 0, 1}}, {}};
  for (unsigned i = 0; i < n; ++i) {
    const unsigned a = c.on_circle(2 * i, 2 * n, 0.5), b = c.on_circle(2 * i + 1, 2 * n, 0.5);
    c.polys.push_back({a, b, 1, 0});
  }
  return c;
}
/// n edges at one vert, each with two tets that share nothing else.
inline dense_mesh tets_at_a_vert(unsigned n) {
  dense_mesh c{"tets at one vert", {{0, 0, 0}}, {}};
  for (unsigned i = 0; i < n / 2; ++i) {
    const unsigned b = c.add(1, i, 0);
    for (unsigned j = 0; j < 2; ++j) {
      const unsigned k = c.add(1, i + 1, 3 * j), l = c.add(1, i, 1 + 3 * j);
      c.polys.push_back({0, b, k, l});
    }
  }
  return c;
}
/// Rings of 300 tets around each of n edges that meet at a vert.
inline dense_mesh rings_at_a_vert(unsigned n) {
  dense_mesh c{"rings of tets at one vert", {{0, 0, 0}}, {}};
  for (unsigned ring = 0; ring < n / 300 + 1; ++ring) {
    const unsigned axis = c.add(ring, 0, 1), first = axis + 1;
    for (unsigned i = 0; i < 300; ++i) c.on_circle(i, 300, ring + 1.0);
    for (unsigned i = 0; i < 300; ++i) c.polys.push_back({first + i, first + (i + 1) % 300, axis, 0});
  }
  return c;
}
inline dense_mesh equal_tets(unsigned n) { return {"equal tets", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, std::vector<std::vector<unsigned>>(n, {0, 1, 2, 3})}; }

inline dense_mesh hexes_around_an_edge(unsigned n) {
  dense_mesh c{"hexes around one edge", {{0, 0, 0}, {0, 0, 1}}, {}};
  for (unsigned i = 0; i < 2 * n; ++i)
    for (const double z : {0., 1.}) c.on_circle(i, 2 * n, z);
  const auto at = [n](unsigned i, unsigned z) { return 2 + 2 * (i % (2 * n)) + z; };
  for (unsigned i = 0; i < 2 * n; i += 2) c.polys.push_back({0, at(i, 0), at(i + 1, 0), at(i + 2, 0), 1, at(i, 1), at(i + 1, 1), at(i + 2, 1)});
  return c;
}
/// Hexes with faces that have the same three smallest verts.
inline dense_mesh hexes_on_three_verts(unsigned n) {
  dense_mesh c{"hexes on three verts", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}};
  for (unsigned i = 0; i < n; ++i) {
    std::vector<unsigned> hex = {0, 1, 2};
    for (unsigned k = 3; k < 8; ++k) hex.push_back(c.add(i, k / 4, k % 4));
    c.polys.push_back(hex);
  }
  return c;
}

/// Cells as general polyhedra; equal faces are merged.
inline polyhedralmesh as_polyhedra(const dense_mesh& c) {
  std::vector<vert_id> verts;
  for (const auto& p : c.polys)
    for (const unsigned v : p) verts.push_back(vert_id{v});
  return polyhedralmesh(to_polyhedra<cell_arrays>(cell_arrays{c.points, std::move(verts), static_cast<std::uint32_t>(c.polys[0].size())}));
}
/// `copies` polyhedra that all have the same faces, outward in each.
inline polyhedralmesh polyhedra_of(const dense_mesh& c, unsigned copies) {
  std::vector<std::pair<unsigned, bool>> all;
  for (unsigned f = 0; f < c.polys.size(); ++f) all.push_back({f, true});
  return polyhedralmesh(c.points, c.polys, std::vector<std::vector<std::pair<unsigned, bool>>>(copies, all));
}
/// The faces of a prism over a polygon of n verts: two of n verts, n of four.
inline dense_mesh prism_faces(unsigned n) {
  dense_mesh c{"prism", {}, {{}, {}}};
  for (unsigned i = 0; i < n; ++i) {
    c.polys[0].push_back(c.on_circle(i, n, 0));
    c.polys[1].push_back(c.on_circle(i, n, 1));
  }
  c.polys[0] = {c.polys[0].rbegin(), c.polys[0].rend()};
  for (unsigned i = 0; i < n; ++i) {
    const unsigned j = (i + 1) % n;
    c.polys.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  return c;
}
/// The faces of two pyramids over a polygon of n verts: 2 n triangles at two verts.
inline dense_mesh bipyramid_faces(unsigned n) {
  dense_mesh c{"bipyramid", {{0, 0, 1}, {0, 0, -1}}, {}};
  for (unsigned i = 0; i < n; ++i) c.on_circle(i, n, 0);
  for (unsigned i = 0; i < n; ++i) {
    const unsigned a = 2 + i, b = 2 + (i + 1) % n;
    c.polys.push_back({0, a, b});
    c.polys.push_back({1, b, a});
  }
  return c;
}

}  // namespace concino::testing
