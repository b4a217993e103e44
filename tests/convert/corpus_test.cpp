// Converting every mesh of the corpus to the general kind and back preserves verts, polys, coordinates and properties.
#include <concino/convert.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
using general_of = std::conditional_t<VolumeMesh<M>, polyhedralmesh, polygonmesh>;

/// The number of elements of m that differ from their counterparts after converting there and back.
template<class M, class There, class Back>
std::size_t differences(const M& m, const There& there, const Back& back) {
  std::size_t wrong = 0;
  const auto stand_in = [&](vert_id v) { return back.vert_of(there.vert_of(v)); };
  for (const auto v : verts(m)) wrong += !(point(m, v) == point(back.mesh, stand_in(v)));
  std::vector<vert_id> expected;
  for (const auto p : polys(m)) {
    expected.clear();
    for (const auto v : adj_p2v(m, p)) expected.push_back(stand_in(v));
    const auto found = adj_p2v(back.mesh, back.poly_of(there.poly_of(p)));
    if constexpr (SurfaceMesh<M>) wrong += !std::equal(expected.begin(), expected.end(), found.begin(), found.end());
    else wrong += !std::is_permutation(expected.begin(), expected.end(), found.begin(), found.end());
  }
  return wrong;
}

}  // namespace

TEST_CASE("corpus: converting to the general kind and back changes nothing") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    INFO(row.name);
    auto any = load_any(row.file.string());
    std::visit(
        [&](auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          auto number = vert_property<unsigned>(m, "number");
          for (const auto v : verts(m)) number[v] = v.raw();
          const auto there = convert_with_correspondence<general_of<M>>(m);
          const auto back = convert_with_correspondence<M>(there.mesh);
          CHECK(num_verts(back.mesh) == num_verts(m));
          CHECK(num_edges(back.mesh) == num_edges(m));
          CHECK(num_polys(back.mesh) == num_polys(m));
          CHECK(differences(m, there, back) == 0);
          CHECK(property_list(back.mesh).size() == property_list(m).size());
          const auto carried = find_vert_property<unsigned>(back.mesh, "number");
          std::size_t wrong = 0;
          for (const auto v : verts(m)) wrong += carried[back.vert_of(there.vert_of(v))] != v.raw();
          CHECK(wrong == 0);
        },
        any);
  }
}
