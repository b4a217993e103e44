#include <concino/generate/dual_mesh.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

/// The dual, or nothing if the mesh is refused, for a reason that validate() must know too.
template<class M>
auto dual_unless_invalid(const M& m, const dual_mesh_options& o) {
  using dual = decltype(dual_mesh(m, o));
  try {
    return std::optional<dual>(dual_mesh(m, o));
  } catch (const invalid_mesh& e) {
    CHECK_MESSAGE(validate(m).begin() != validate(m).end(), e.what());
    return std::optional<dual>();
  }
}

template<class R>
std::size_t count(const R& r) {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto x : r) ++n;
  return n;
}

template<class M>
bool is_closed(const M& m) {
  for (const auto f : facets(m))
    if (is_boundary(m, f)) return false;
  return true;
}

template<class M>
bool check_duals(const M& m, const corpus_row& row) {
  dual_maps maps;
  const auto clipped = dual_unless_invalid(m, {.maps = &maps});
  if (!clipped) return false;
  CHECK(check_laws(*clipped).empty());
  std::size_t with_polys = 0;
  for (const auto v : verts(m)) with_polys += count(adj_v2p(m, v)) > 0;
  CHECK(num_polys(*clipped) == with_polys);
  if constexpr (VolumeMesh<M>) {
    for (const auto p : polys(*clipped)) CHECK(count(adj_p2v(*clipped, p)) + count(adj_p2f(*clipped, p)) == count(adj_p2e(*clipped, p)) + 2);
    if (TetMesh<M>) CHECK(total_measure(*clipped) == doctest::Approx(row.volume).epsilon(1e-12));  // its boundary is planar at each face
  } else if (is_closed(m) && with_polys == num_verts(m)) {
    CHECK(num_verts(*clipped) == num_polys(m));
    CHECK(num_edges(*clipped) == num_edges(m));
  }
  for (const auto& o : {dual_mesh_options{.boundary = dual_boundary::closed}, dual_mesh_options{.boundary = dual_boundary::discarded}, dual_mesh_options{.crease_angle_deg = 40}}) {
    const auto other = dual_mesh(m, o);
    if (long_run()) CHECK(check_laws(other).empty());
    if (o.boundary == dual_boundary::discarded) CHECK(num_polys(other) <= with_polys);
    else CHECK(num_polys(other) == with_polys);
    CHECK(num_verts(other) <= num_verts(*clipped));
  }
  return true;
}

}  // namespace

TEST_CASE("dual_mesh: all meshes of the corpus have a dual, or are refused for a reason that validate() knows") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t duals = 0;
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    std::visit(
        [&](const auto& m) {
          if (long_run() || num_polys(m) < 6000) duals += check_duals(m, row);
        },
        load_any(row.file));
  }
  CHECK(duals > rows.size() / 2);
  MESSAGE(duals << " of " << rows.size() << " meshes have a dual");
}
