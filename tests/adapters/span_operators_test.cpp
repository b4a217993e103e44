// The laws of operators hold on views of arrays, for real and generated surfaces and volumes.
#include <concino/adapters/span.hpp>

#include <support/input_arrays.hpp>
#include <support/operator_laws.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks the same mesh as a view of arrays.
template<class M>
void check_as_arrays(const M& m) {
  std::vector<int> corners, begins{0};
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) corners.push_back(static_cast<int>(index_of(m, v)));
    begins.push_back(static_cast<int>(corners.size()));
  }
  std::vector<double> points[3];
  std::size_t next = 0;
  check_operators_scale([&](double s) {
    std::vector<double>& x = points[next++];
    for (const auto v : verts(m))
      for (std::size_t k = 0; k < 3; ++k) x.push_back(s * to_vec3(point(m, v))[k]);
    if constexpr (TriMesh<M>) return view_tri(x, corners);
    else if constexpr (TetMesh<M>) return view_tet(x, corners);
    else if constexpr (HexMesh<M>) return view_hex(x, corners);
    else return view_polygons(x, begins, corners);
  });
}

}  // namespace

TEST_CASE("arrays: gradients are exact on linear functions, masses sum to the measure, matrices scale exactly") {
  each_small_corpus_mesh([](const auto& m) {
    using mesh = std::remove_cvref_t<decltype(m)>;
    if constexpr (!std::same_as<mesh, polyhedralmesh>) check_as_arrays(m);
  });
  auto hexes = make_grid<hexmesh>({.cells = {3, 3, 3}});
  jitter(hexes, 0.2);
  check_as_arrays(hexes);
  check_as_arrays(make_sphere<polygonmesh>({.cells = 3}));
}
