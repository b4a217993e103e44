// Slices of binary mesh files: together they are the whole mesh, and each takes its part of the memory.
#include <concino/io/load_slice.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus_meshes.hpp>
#include <support/file_slices.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
M mesh_with_values(bool medit) {
  M m(two_grids_arrays<M>(2));
  auto label = poly_property<int>(m, "label");
  for (const auto p : polys(m)) label[p] = static_cast<int>(index_of(m, p)) * 3 - 5;
  auto mark = vert_property<int>(m, "corner");
  for (const auto v : verts(m)) mark[v] = index_of(m, v) % 3 == 0;
  auto normal = vert_property<vec3>(m, "normal");
  for (const auto v : verts(m)) normal[v] = index_of(m, v) % 4 ? vec3{0, 1, point(m, v).x} : vec3{};
  if (!medit) {
    auto weight = poly_property<float>(m, "weight");
    for (const auto p : polys(m)) weight[p] = static_cast<float>(index_of(m, p)) / 4;
    *mesh_property<double>(m, "time") = 0.25;
  }
  if constexpr (dimension_v<M> == 3) {
    auto patch = face_property<int>(m, "label");
    for (const auto f : faces(m)) patch[f] = num_elements(adj_f2p(m, f)) == 1 ? 1 + static_cast<int>(index_of(m, f)) : 0;
  }
  if (medit) {
    auto ridge = edge_property<int>(m, "ridge"), edge_label = edge_property<int>(m, "label");
    for (const auto e : edges(m)) ridge[e] = index_of(m, e) % 5 == 0, edge_label[e] = static_cast<int>(index_of(m, e) % 3);
    if constexpr (dimension_v<M> == 2) {
      auto required = poly_property<int>(m, "required");
      for (const auto p : polys(m)) required[p] = index_of(m, p) % 2 == 1;
    }
  }
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("load_slice: the slices of a .vtu file are its mesh", M, CONCINO_ALL_KINDS) {
  const temporary_folder folder;
  save(mesh_with_values<M>(false), folder / "m.vtu", {.binary = true});
  check_slices<M>(folder / "m.vtu", 7);
}

TEST_CASE_TEMPLATE("load_slice: the slices of a .meshb file are its mesh", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const temporary_folder folder;
  save(mesh_with_values<M>(true), folder / "m.meshb");
  check_slices<M>(folder / "m.meshb", 7);
}

TEST_CASE("load_slice: mixed cells, lines between polygons, and verts of no poly") {
  // hexes, a tet and polyhedra, as a file lists them
  polyhedralmesh m(two_grids_arrays<polyhedralmesh>(2));
  const temporary_folder folder;
  save(m, folder / "m.vtu", {.binary = true});
  check_slices<polyhedralmesh>(folder / "m.vtu", 5);
  CHECK(load_slice<polyhedralmesh>(folder / "m.vtu", 0, 1).num_verts == num_verts(m));
  save(polygonmesh(), folder / "empty.vtu", {.binary = true});
  check_slices<polygonmesh>(folder / "empty.vtu", 3);
  save(trimesh(), folder / "empty.meshb");
  check_slices<trimesh>(folder / "empty.meshb", 3);
  const auto one = triangle_grid(1);  // more slices than polys
  save(trimesh(one), folder / "one.meshb");
  check_slices<trimesh>(folder / "one.meshb", 7);
  save(trimesh(one), folder / "one.vtu", {.binary = true});
  check_slices<trimesh>(folder / "one.vtu", 7);
}

namespace {

std::string says(const std::string& path, std::size_t k, std::size_t n, const load_options& options = {}) {
  try {
    load_slice<polygonmesh>(path, k, n, options);
    return "";
  } catch (const error& e) {
    return std::string(e.what()).substr(path.size());
  }
}

}  // namespace

TEST_CASE("load_slice: lines between polygons") {
  const temporary_folder folder;
  write_file(folder / "m.vtu", slice_vtu_text(lines_between_polygons));
  check_slices<polygonmesh>(folder / "m.vtu", 5);
  load_report report;
  const auto s = load_slice<polygonmesh>(folder / "m.vtu", 1, 2, {.report = &report});
  CHECK(s.first_poly == 2);
  CHECK(s.num_polys == 4);
  CHECK(s.global_vert == std::vector<std::uint64_t>{2, 3, 4, 5, 6});
  CHECK(find_poly_property<double>(s.mesh, "heat")[*polys(s.mesh).begin()] == 1.5);
}

TEST_CASE("load_slice: what cannot be read, and where it is wrong") {
  const temporary_folder folder;
  const auto m = grid<polygonmesh>(2);
  save(m, folder / "m.vtu");
  CHECK(says(folder / "m.vtu", 0, 2) == ": slices cannot be read of a file whose array \"Points\" is text or base64; load it, and save it by save(m, path, {.binary = true})");
  save(trimesh(triangle_grid(1)), folder / "m.mesh");
  CHECK(says(folder / "m.mesh", 0, 2) == ": slices are read of binary .vtu and .meshb files; convert it by save(m, path, {.binary = true})");
  save(m, folder / "m.vtu", {.binary = true});
  for (const std::size_t n : {std::size_t{0}, std::size_t{2}}) CHECK_THROWS_AS(load_slice<polygonmesh>(folder / "m.vtu", n, n), invalid_argument);
  CHECK_THROWS_AS(load_slice<polygonmesh>(folder / "m.vtu", 0, 2, {.repeated_verts = repeated_verts::skip}), invalid_argument);
  CHECK_THROWS_AS(load_slice<polygonmesh>(folder / "m.vtu", 0, 2, {.corners_only = true}), invalid_argument);
  CHECK_THROWS_AS(load_slice<tetmesh>(folder / "m.vtu", 0, 2), unsupported);
  CHECK_THROWS_AS(load_slice<trimesh>(folder / "m.vtu", 0, 1), parse_error);
  CHECK_THROWS_AS(load_slice<polygonmesh>(folder / "none.vtu", 0, 2), io_error);
  auto ghosts = m;
  poly_property<std::uint8_t>(ghosts, "vtkGhostType");
  save(ghosts, folder / "ghosts.vtu", {.binary = true});
  CHECK(says(folder / "ghosts.vtu", 0, 2).starts_with(": slices cannot be read of a file with ghost cells"));
  const auto wrong = [&](const std::string& types, const std::vector<std::int32_t>& lists, const std::vector<std::int32_t>& ends) {
    write_file(folder / "w.vtu", slice_vtu_text({types, lists, ends}));
    return says(folder / "w.vtu", 0, 1);
  };
  CHECK(wrong("\5\5", {0, 1, 2, 0, 2, 8}, {3, 6}) == ":11: expected point indices below 8, found 8 in the array \"connectivity\"");
  CHECK(wrong("\5\5", {0, 1, 2, 0, 2, 3}, {3, 7}) == ":12: expected ends that do not decrease, up to 6, found 7 after 3 in the array \"offsets\"");
  CHECK(wrong("\5\3\5", {0, 1, 2, 0, 2, 3}, {3, 6, 3}) == ":12: expected ends that do not decrease, up to 6, found 3 after 6 in the array \"offsets\"");
  CHECK(wrong("\5", {0, 1, 1}, {3}) == " (slice 0 of 1):3: expected different points at the corners of a polygon (or set options.repeated_verts), found point 1 twice in cell 0 of the piece");
  CHECK(wrong("\5\6", {0, 1, 2, 0, 2, 3}, {3, 6}).starts_with(": slices cannot be read of a file with triangle strips"));
  CHECK(wrong("\5\x16", {0, 1, 2, 0, 2, 3}, {3, 6}).starts_with(": slices cannot be read of a file with elements of second or higher order"));
  CHECK(wrong("\5\x11", {0, 1, 2, 0, 2, 3}, {3, 6}).find("has type 17") != std::string::npos);
}

TEST_CASE("load_slice: the slices of all files of the corpus") {
  const temporary_folder folder;
  for_each_small_corpus_mesh([&]<class M>(const M& m) {
    save(m, folder / "m.vtu", {.binary = true});
    check_slices<M>(folder / "m.vtu", 3);
    try {
      save(m, folder / "m.meshb");
    } catch (const unsupported&) {  // polys of other shapes
      return;
    }
    check_slices<M>(folder / "m.meshb", 3);
  });
}
