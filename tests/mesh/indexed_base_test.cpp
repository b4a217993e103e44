// A user's mesh with lists of verts becomes a complete mesh through the indexed bases.
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

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
