// A user's mesh with lists of verts becomes a complete mesh through the indexed bases.
#include <concino/concepts/facets.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace cn = concino;

namespace {
struct flat {
  std::vector<cn::vec3> x;
  cn::surface_tables<3> tables;
};
struct solid {
  std::vector<float> xyz;
  cn::tet_tables tables;
};
}  // namespace

template<>
struct concino::mesh_traits<flat> : concino::indexed_surface<flat> {
  static constexpr int arity = 3;
  static const surface_tables<3>& tables(const flat& m) { return m.tables; }
  static vec3 point(const flat& m, vert_id v) { return m.x[v.raw()]; }
};
template<>
struct concino::mesh_traits<solid> : concino::indexed_volume<solid> {
  static constexpr int arity = 4;
  static const tet_tables& tables(const solid& m) { return m.tables; }
  static const float* point(const solid& m, vert_id v) { return m.xyz.data() + 3 * v.raw(); }
};

static_assert(cn::TriMesh<flat> && cn::Embedded<flat> && !cn::MutablePoints<flat>);
static_assert(cn::TetMesh<const solid&> && cn::Embedded<solid>);

TEST_CASE("indexed bases: a surface of lists obeys all laws") {
  auto arrays = cn::testing::triangle_grid(3);
  const flat m{arrays.points, cn::surface_tables<3>(arrays.points.size(), arrays.verts)};
  CHECK(cn::num_edges(m) == 33);
  CHECK(cn::check_laws(m).empty());
}

TEST_CASE("indexed bases: a volume of lists obeys all laws") {
  auto arrays = cn::testing::tet_grid(2);
  solid m{{}, cn::tet_tables(arrays.points.size(), arrays.verts)};
  for (const auto& p : arrays.points)
    for (std::size_t i = 0; i < 3; ++i) m.xyz.push_back(static_cast<float>(p[i]));
  CHECK(cn::num_edges(m) == 98);
  CHECK(cn::num_faces(m) == 120);
  CHECK(cn::check_laws(m).empty());
}

namespace {
/// A strip of three triangles that hides the last one, with its vert and its two edges.
struct hiding : flat {
  bool has(cn::poly_id p) const { return p.raw() != 2; }
  bool has(cn::edge_id e) const { return std::ranges::any_of(tables.adj_e2p(e), [&](cn::poly_id p) { return has(p); }); }
  bool has(cn::vert_id v) const { return v.raw() != 4; }
  template<class X, class R>
  std::vector<X> visible(const R& all) const {
    std::vector<X> kept;
    for (const X element : all)
      if (has(element)) kept.push_back(element);
    return kept;
  }
};
}  // namespace
template<>
struct concino::mesh_traits<hiding> : concino::indexed_surface<hiding> {
  static constexpr int arity = 3;
  static const auto& tables(const hiding& m) { return m.tables; }
  static vec3 point(const hiding& m, vert_id v) { return m.x[v.raw()]; }
  static bool contains(const hiding& m, auto x) { return m.has(x); }
  static auto verts(const hiding& m) { return m.visible<vert_id>(m.tables.verts().all()); }
  static auto edges(const hiding& m) { return m.visible<edge_id>(m.tables.edges().all()); }
  static auto polys(const hiding& m) { return m.visible<poly_id>(m.tables.polys().all()); }
  static std::size_t num_verts(const hiding& m) { return verts(m).size(); }
  static std::size_t num_edges(const hiding& m) { return edges(m).size(); }
  static std::size_t num_polys(const hiding& m) { return polys(m).size(); }
  static auto adj_v2v(const hiding& m, vert_id v) { return m.visible<vert_id>(m.tables.adj_v2v(v)); }
  static auto adj_v2e(const hiding& m, vert_id v) { return m.visible<edge_id>(m.tables.adj_v2e(v)); }
  static auto adj_v2p(const hiding& m, vert_id v) { return m.visible<poly_id>(m.tables.adj_v2p(v)); }
  static auto adj_e2p(const hiding& m, edge_id e) { return m.visible<poly_id>(m.tables.adj_e2p(e)); }
  static auto adj_p2p(const hiding& m, poly_id p) { return m.visible<poly_id>(m.tables.adj_p2p(p)); }
};

TEST_CASE("indexed bases: no inherited member answers for a verb that was replaced") {
  std::vector<cn::vert_id> corners;
  for (const unsigned v : {0u, 1u, 2u, 2u, 1u, 3u, 2u, 3u, 4u}) corners.emplace_back(v);
  const hiding m{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}, cn::surface_tables<3>(5, corners)}};
  CHECK(cn::num_edges(m) == 5);
  for (const auto e : cn::edges(m))
    for (const auto p : cn::adj_e2p(m, e)) {
      std::size_t others = 0;
      for (const auto q : cn::other_polys(m, p, e)) {
        CHECK(cn::contains(m, q));
        ++others;
      }
      CHECK(cn::is_boundary(m, e) == (others == 0));
    }
  const auto broken = cn::check_laws(m);
  CHECK_MESSAGE(broken.empty(), broken[0].what);
}
