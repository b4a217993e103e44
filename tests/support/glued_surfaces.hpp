// Random closed surfaces: triangles whose edges are glued in pairs. They have any genus, may be non-orientable and may have several components.
#pragma once

#include <concino/mesh/arrays.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

namespace concino::testing {

/// Triangles with verts and edges. Two edges may have the same ends, and an edge may be a loop.
struct glued_triangles {
  struct side {
    unsigned edge;
    bool forward;  // from the edge's first end to its second
  };
  struct triangle {
    std::array<unsigned, 3> verts;
    std::array<side, 3> sides;  // sides[k] from verts[k] to verts[k + 1]
  };
  unsigned vert_count = 0, edge_count = 0;
  std::vector<triangle> triangles;
};

/// Glues the edges of n triangles, n even. With `twisted` they may also be glued with reversed direction.
inline glued_triangles glue_sides(std::mt19937& random, unsigned n, bool twisted) {
  glued_triangles g;
  g.triangles.resize(n);
  std::vector<unsigned> sides(3 * n), corner(3 * n);
  for (unsigned i = 0; i < 3 * n; ++i) sides[i] = corner[i] = i;
  std::shuffle(sides.begin(), sides.end(), random);
  const auto next = [](unsigned c) { return c % 3 == 2 ? c - 2 : c + 1; };
  const auto unite = [&](unsigned a, unsigned b) {
    for (const unsigned from = corner[a], to = corner[b]; unsigned& c : corner)
      if (c == from) c = to;
  };
  for (unsigned i = 0; i < 3 * n; i += 2) {
    const unsigned a = sides[i], b = sides[i + 1];
    const bool forward = twisted && random() % 2;
    g.triangles[a / 3].sides[a % 3] = {g.edge_count, true};
    g.triangles[b / 3].sides[b % 3] = {g.edge_count++, forward};
    unite(a, forward ? b : next(b));
    unite(next(a), forward ? next(b) : b);
  }
  std::vector<unsigned> number(3 * n, ~0u);
  for (unsigned c = 0; c < 3 * n; ++c) {
    unsigned& v = number[corner[c]];
    if (v == ~0u) v = g.vert_count++;
    g.triangles[c / 3].verts[c % 3] = v;
  }
  return g;
}

/// Splits each triangle into six, around a new vert in its middle. New verts in the middles of edges follow the old verts. Afterwards the three
/// verts of every triangle are different, and so are the ends of every edge.
inline glued_triangles in_six(const glued_triangles& g) {
  glued_triangles r;
  r.vert_count = g.vert_count + g.edge_count + static_cast<unsigned>(g.triangles.size());
  r.edge_count = 2 * g.edge_count + 6 * static_cast<unsigned>(g.triangles.size());
  for (unsigned t = 0; t < g.triangles.size(); ++t)
    for (unsigned k = 0; k < 3; ++k) {
      const auto& [v, s] = g.triangles[t];
      const unsigned a = v[k], b = v[(k + 1) % 3], middle = g.vert_count + s[k].edge, centre = g.vert_count + g.edge_count + t;
      const unsigned first = 2 * s[k].edge + (s[k].forward ? 0 : 1), second = 2 * s[k].edge + (s[k].forward ? 1 : 0);
      const unsigned spokes = 2 * g.edge_count + 6 * t;  // from the verts, then from the middles
      r.triangles.push_back({{a, middle, centre}, {{{first, s[k].forward}, {spokes + 3 + k, true}, {spokes + k, false}}}});
      r.triangles.push_back({{middle, b, centre}, {{{second, s[k].forward}, {spokes + (k + 1) % 3, true}, {spokes + 3 + k, false}}}});
    }
  return r;
}

/// The surface as a mesh: six triangles or three quads for each triangle of in_six, or a hexagon with a vert in the middle of every edge.
template<class M>
M glued_mesh(const glued_triangles& g) {
  const glued_triangles fine = in_six(g);
  std::vector<std::vector<unsigned>> rings;
  std::vector<vec3> points(fine.vert_count + fine.edge_count + (arity_v<M> == 0 ? 0 : fine.triangles.size()));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {double(i % 7), double(i % 11), double(i)};
  for (unsigned t = 0; t < fine.triangles.size(); ++t) {
    const auto& v = fine.triangles[t].verts;
    const unsigned centre = fine.vert_count + fine.edge_count + t;
    const auto middle = [&](unsigned k) { return fine.vert_count + fine.triangles[t].sides[k % 3].edge; };
    if constexpr (arity_v<M> == 0) {
      rings.push_back({v[0], middle(0), v[1], middle(1), v[2], middle(2)});
    } else {
      for (unsigned k = 0; k < 3; ++k) {
        if constexpr (arity_v<M> == 4) {
          rings.push_back({v[k], middle(k), centre, middle(k + 2)});
        } else {
          rings.push_back({v[k], middle(k), centre});
          rings.push_back({middle(k), v[(k + 1) % 3], centre});
        }
      }
    }
  }
  return M(points, rings);
}

/// Calls check(m, chi) for random closed surfaces glued from two or four triangles.
template<class M, class F>
void for_random_closed_surfaces(unsigned count, const F& check) {
  std::mt19937 random(30);
  for (unsigned i = 0; i < count; ++i) {
    const unsigned n = random() % (arity_v<M> == 3 ? 12 : 2) == 0 ? 4 : 2;  // few large ones, which become 144 triangles
    const glued_triangles g = glue_sides(random, n, random() % 2 == 0);
    check(glued_mesh<M>(g), static_cast<int>(g.vert_count + g.triangles.size()) - static_cast<int>(g.edge_count));
  }
}

}  // namespace concino::testing
