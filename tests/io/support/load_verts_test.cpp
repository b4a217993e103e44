// Verts of a mesh file without its polys.
#include <concino/io/support/load_verts.hpp>

#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// A mesh whose file lists faces and edges too, with a vert of no poly in the middle and at the end.
template<class M>
M mesh_with_marks() {
  auto arrays = two_grids_arrays<M>(2);
  arrays.points.push_back({7, 8, 9});
  M m(std::move(arrays));
  auto label = vert_property<int>(m, "label");
  for (const auto v : verts(m)) label[v] = 1 + static_cast<int>(index_of(m, v));
  auto of_polys = poly_property<int>(m, "label");
  for (const auto p : polys(m)) of_polys[p] = 5;
  auto ridge = edge_property<int>(m, "ridge");
  for (const auto e : edges(m)) ridge[e] = 1;
  if constexpr (dimension_v<M> == 3) {
    auto patch = face_property<int>(m, "label");
    for (const auto f : faces(m)) patch[f] = 3;
  }
  return m;
}

template<class M>
void check_verts(const M& m, const std::string& path) {
  std::vector<std::uint64_t> every, some = {1, num_verts(m) - 2, num_verts(m) - 1};
  for (std::uint64_t v = 0; v < num_verts(m); ++v) every.push_back(v);
  for (const auto& wanted : {every, some, std::vector<std::uint64_t>()}) {
    const mesh_slice<M> s = core::load_verts<M>(path, wanted);
    CHECK(s.global_vert == wanted);
    CHECK(num_polys(s.mesh) == 0);
    CHECK(s.num_polys == num_polys(m));
    CHECK(s.num_verts == num_verts(m));
    REQUIRE(num_verts(s.mesh) == wanted.size());
    const auto label = find_vert_property<int>(s.mesh, "label");
    REQUIRE((label || wanted.empty()));
    for (const auto v : verts(s.mesh)) {
      const std::uint64_t number = wanted[index_of(s.mesh, v)];
      CHECK(point(s.mesh, v) == point(m, vert_t<M>{static_cast<unsigned>(number)}));
      CHECK(label[v] == 1 + static_cast<int>(number));
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("load_verts: verts of a .vtu file", M, CONCINO_ALL_KINDS) {
  const temporary_folder folder;
  const M m = mesh_with_marks<M>();
  save(m, folder / "m.vtu", {.binary = true});
  check_verts(m, folder / "m.vtu");
}

TEST_CASE_TEMPLATE("load_verts: verts of a .meshb file", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const temporary_folder folder;
  const M m = mesh_with_marks<M>();
  save(m, folder / "m.meshb");
  check_verts(m, folder / "m.meshb");
}

TEST_CASE("load_verts: errors are those of load_slice, and verts that the file does not have") {
  const temporary_folder folder;
  save(grid<trimesh>(1), folder / "m.vtu", {.binary = true});
  save(grid<trimesh>(1), folder / "m.meshb");
  for (const char* const file : {"m.vtu", "m.meshb"})
    CHECK_THROWS_WITH_AS(core::load_verts<trimesh>(folder / file, {0, 4}), "load_verts: there is no vert 4; the file has 4", invalid_argument);
  CHECK_THROWS_AS(core::load_verts<trimesh>(folder / "none.vtu", {0}), io_error);
  save(grid<trimesh>(1), folder / "text.vtu");
  CHECK_THROWS_AS(core::load_verts<trimesh>(folder / "text.vtu", {0}), unsupported);
}
