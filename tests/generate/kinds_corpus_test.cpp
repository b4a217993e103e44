#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/extrude.hpp>
#include <concino/generate/offset_shell.hpp>
#include <concino/generate/unite.hpp>
#include <concino/generate/voxel_hexes.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>
#include <support/subdivisions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
bool is_even(const M& m) {
  for (const auto e : edges(m))
    if (num_elements(adj_e2p(m, e)) % 2) return false;
  return true;
}

/// Cubes in closed surfaces; a shell, or a reason against it that validate() knows too. Returns the number of meshes that were made.
template<SurfaceMesh M>
std::size_t check_between(const M& m, const corpus_row&) {
  std::size_t done = 0;
  const double diagonal = bounding_box(m).diagonal();
  if (!is_even(m)) {
    CHECK_THROWS_AS(voxel_hexes(m, 8), invalid_mesh);
  } else if (num_polys(m) > 0) {
    const std::size_t n = 20;
    const auto v = voxel_hexes(m, n);
    CHECK(check_laws(v).empty());
    const double cell = diagonal / n;  // at least the size of a cube
    CHECK(std::abs(total_measure(v) - std::abs(enclosed_volume(m))) < total_measure(m) * cell);
    ++done;
  }
  std::vector<poly_id> inverted;
  try {
    const auto shell = offset_shell(m, 1e-3 * diagonal, 2, {.inverted = &inverted});
    CHECK(num_polys(shell) == 2 * num_polys(m));
    CHECK(check_laws(shell).empty());
    if (inverted.empty())
      for (const poly_id p : polys(shell)) CHECK(volume(shell, p) > 0);
    ++done;
  } catch (const invalid_mesh& e) {
    CHECK_MESSAGE(validate(m).begin() != validate(m).end(), e.what());
  }
  try {
    const auto v = extrude(m, {0.3 * diagonal, 0.2 * diagonal, diagonal}, 2);
    CHECK(check_laws(v).empty());
    for (const poly_id p : polys(v)) CHECK(volume(v, p) > 0);
    ++done;
  } catch (const invalid_argument&) {  // it does not face the direction from one side
  } catch (const invalid_mesh& e) {
    CHECK_MESSAGE(validate(m).begin() != validate(m).end(), e.what());
  }
  return done;
}

/// The boundary is closed and encloses the volume.
template<VolumeMesh M>
std::size_t check_between(const M& m, const corpus_row&) {
  const auto s = boundary_surface(m);
  CHECK(check_laws(s).empty());
  CHECK(is_even(s));
  CHECK(num_polys(s) == num_polys(boundary(m)));
  CHECK(total_measure(s) == doctest::Approx(total_measure(boundary(m))).epsilon(1e-12));
  if (TetMesh<M>) CHECK(enclosed_volume(s) == doctest::Approx(total_measure(m)).epsilon(1e-9));
  return 1;
}

}  // namespace

TEST_CASE("between kinds: volumes of the surfaces of the corpus, boundaries of its volumes, and each united with itself") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t done = 0;
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    std::visit(
        [&](const auto& m) {
          if (!long_run() && num_polys(m) > 700) return;
          done += check_between(m, row);
          const auto twice = unite(m, m);
          CHECK(num_verts(twice) == num_verts(m));
          CHECK(num_edges(twice) >= num_edges(m));  // more where verts of one mesh coincide: the second mesh takes the first of them
          CHECK(num_polys(twice) == 2 * num_polys(m));
        },
        load_any(row.file));
  }
  CHECK(done > 10);
  MESSAGE(done << " meshes were made of " << rows.size());
}
