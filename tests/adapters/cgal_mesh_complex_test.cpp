// A Mesh_complex_3_in_triangulation_3, the result of CGAL's meshers, is the tet mesh of its cells through indexed(c).
#include <concino/adapters/cgal_triangulation.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate/check_laws.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <doctest/doctest.h>
#include <support/models.hpp>

using namespace concino;

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<kernel>;
using complex = CGAL::Mesh_complex_3_in_triangulation_3<triangulation>;
using view = decltype(indexed(std::declval<const complex&>()));

}  // namespace

static_assert(testing::models_in_all_forms<view>(testing::volume | testing::embedded | testing::fixed_arity));

TEST_CASE("CGAL mesh complexes: the mesh has exactly the cells in the complex") {
  complex c;
  for (int k = 0; k <= 3; ++k)
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i) c.triangulation().insert(kernel::Point_3(i, j, k));
  CHECK(num_polys(indexed(c)) == 0);
  CHECK(num_verts(indexed(c)) == 0);
  double volume = 0;
  for (const triangulation::Cell_handle cell : c.triangulation().finite_cell_handles()) {
    const auto tet = c.triangulation().tetrahedron(cell);
    if (CGAL::centroid(tet).x() > 1) continue;
    c.add_to_complex(cell, 1);
    volume += tet.volume();
  }
  CHECK(c.number_of_cells_in_complex() > 0);
  const auto m = indexed(c);
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
  CHECK(num_polys(m) == c.number_of_cells_in_complex());
  CHECK(num_verts(m) < 64);
  CHECK(total_measure(m) == doctest::Approx(volume));
  for (const triangulation::Cell_handle cell : c.triangulation().finite_cell_handles()) CHECK(m.poly(cell).is_none() != c.is_in_complex(cell));
}
