// Distributed meshes saved in pieces, and read again as a whole.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_files.hpp>

#include <concino/io/pvtu.hpp>
#include <concino/io/vtu.hpp>
#include <concino/mesh/property.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

/// The grids of other tests, and a vert of no poly between their verts.
template<class M>
M mesh_to_save() {
  auto a = two_grids_arrays<M>(2);
  a.points.push_back({9, 9, 9});
  return M(std::move(a));
}

template<class M>
std::vector<std::uint64_t> sorted_verts(const M& m, const poly_t<M>& p) {
  std::vector<std::uint64_t> r;
  for (const auto v : adj_p2v(m, p)) r.push_back(number(m, v));
  std::sort(r.begin(), r.end());
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("save_pvtu: the pieces of all processes are the whole mesh in its order", M, CONCINO_ALL_KINDS) {
  const M m = mesh_to_save<M>();
  for (const auto& part : parts_of(m))
    for (const bool binary : {false, true}) {
      const shared_folder folder;
      const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
      auto u = make_vert_map<double>(d, -1.0);
      auto w = make_poly_map<vec3>(d);
      for (const auto v : verts(d))
        if (!d.is_ghost(v)) u[v] = std::sqrt(static_cast<double>(d.global_number(v)));
      for (const auto p : polys(d)) w[p] = {static_cast<double>(d.global_number(p)), 1, 2};
      save_pvtu(d, folder / "new/m.pvtu", {{"u", u}, {"w", w}}, {.binary = binary});
      if (!is_first()) continue;
      const M r = load_pvtu<M>(folder / "new/m.pvtu");
      REQUIRE(num_verts(r) == num_verts(m));
      REQUIRE(num_polys(r) == num_polys(m));
      const auto number_of_vert = find_vert_property<std::int64_t>(r, "global_id");
      const auto number_of_poly = find_poly_property<std::int64_t>(r, "global_id");
      const auto owner_of_poly = find_poly_property<int>(r, "owner");
      const auto owner_of_vert = find_vert_property<int>(r, "owner");
      const auto read_u = find_vert_property<double>(r, "u");
      const auto read_w = find_poly_property<vec3>(r, "w");
      REQUIRE(static_cast<bool>(number_of_vert && number_of_poly && owner_of_poly && owner_of_vert && read_u && read_w));
      std::size_t num_wrong = 0;
      for (const auto v : verts(r)) {
        num_wrong += !(point(r, v) == point(m, vert_at(m, number(r, v))));
        num_wrong += number_of_vert[v] != static_cast<std::int64_t>(number(r, v));
        num_wrong += read_u[v] != std::sqrt(static_cast<double>(number(r, v)));
        int lowest = num_elements(adj_v2p(r, v)) > 0 ? number_of_processes() : 0;
        for (const auto p : adj_v2p(r, v)) lowest = std::min(lowest, owner_of_poly[p]);
        num_wrong += owner_of_vert[v] != lowest;
      }
      for (const auto p : polys(r)) {
        num_wrong += sorted_verts(r, p) != sorted_verts(m, poly_at(m, number(r, p)));
        num_wrong += number_of_poly[p] != static_cast<std::int64_t>(number(r, p));
        num_wrong += owner_of_poly[p] != part[poly_at(m, number(r, p))];
        num_wrong += !(read_w[p] == vec3{static_cast<double>(number(r, p)), 1, 2});
      }
      CHECK(num_wrong == 0);
      // each piece has the polys of its process
      for (int k = 0; k < number_of_processes(); ++k) {
        const M piece = load_vtu<M>(folder / ("new/m_" + std::to_string(k) + ".vtu"));
        CHECK(num_polys(piece) == static_cast<std::size_t>(std::count(part.values().begin(), part.values().end(), k)));
      }
    }
}

TEST_CASE_TEMPLATE("save_pvtu: named properties", M, CONCINO_ALL_KINDS) {
  M m = mesh_to_save<M>();
  add_values(m);
  vert_property<double>(m, "owner");  // save_pvtu has its own
  const shared_folder folder;
  distributed<M> d(MPI_COMM_WORLD, m, parts_of(m)[1]);
  auto heat = vert_property<double>(d, "heat");
  for (const auto v : verts(d)) heat[v] = d.is_ghost(v) ? -1 : 2 * static_cast<double>(d.global_number(v));
  auto label = make_poly_map<double>(d, 0.0);
  for (const auto p : polys(d)) label[p] = static_cast<double>(d.global_number(p)) / 2;
  remove_property(d, element_kind::poly, "byte");
  save_pvtu(d, folder / "m.pvtu", {{"label", label}}, {.binary = true});
  if (is_first()) {
    const M r = load_pvtu<M>(folder / "m.pvtu");
    REQUIRE(num_verts(r) == num_verts(m));
    const auto names = [](const M& x) {
      std::set<std::string> all;
      for (const property_info& p : property_list(x))
        if (p.kind != element_kind::face) all.insert(std::string(to_string(p.kind)) + " " + p.name);
      return all;
    };
    std::set<std::string> expected = names(m);
    expected.erase("poly byte");
    expected.insert({"vert global_id", "poly global_id", "poly owner"});
    CHECK(names(r) == expected);
    const auto read_heat = find_vert_property<double>(r, "heat");
    const auto read_label = find_poly_property<double>(r, "label");
    const auto normal = find_vert_property<vec3>(r, "normal");
    const auto color = find_poly_property<rgba>(r, "color"), expected_color = find_poly_property<rgba>(m, "color");
    std::size_t num_wrong = 0;
    for (const auto v : verts(r)) {
      const auto i = static_cast<double>(number(r, v));
      num_wrong += read_heat[v] != 2 * i;
      num_wrong += !(normal[v] == vec3{i, 0, -i});
    }
    for (const auto p : polys(r)) {
      num_wrong += read_label[p] != static_cast<double>(number(r, p)) / 2;
      num_wrong += !(color[p] == expected_color[poly_at(m, number(r, p))]);
    }
    CHECK(num_wrong == 0);
    CHECK(*find_mesh_property<double>(r, "time") == 0.75);
  }
}

TEST_CASE("save_pvtu: an empty distributed mesh") {
  const shared_folder folder;
  const trimesh m;
  const distributed<trimesh> d(MPI_COMM_WORLD, m, make_poly_map<int>(m, 0));
  save_pvtu(d, folder / "m.pvtu");
  if (is_first()) CHECK(num_verts(load_pvtu<trimesh>(folder / "m.pvtu")) == 0);
}

TEST_CASE("save_pvtu: what one process finds wrong is thrown on all, and no file is changed") {
  const shared_folder folder;
  const trimesh m = grid<trimesh>(2);
  const distributed<trimesh> d(MPI_COMM_WORLD, m, parts_of(m)[0]), other(MPI_COMM_WORLD, m, parts_of(m)[0]);
  const auto u = make_vert_map<double>(d, 1.0), of_other = make_vert_map<double>(other, 1.0);
  const int last = number_of_processes() - 1;
  const std::string path = folder / "m.pvtu", uv = rank() == last ? "v" : "u";
  CHECK_THROWS_WITH_AS(save_pvtu(d, path, {{"u", u}, {"u", u}}), "save_pvtu: two maps are named vert \"u\"", invalid_argument);
  CHECK_THROWS_WITH_AS(save_pvtu(d, path, {{"owner", u}}), doctest::Contains("\"owner\" is the name of what save_pvtu adds"), invalid_argument);
  CHECK_THROWS_WITH_AS(save_pvtu(d, path, {{"u", of_other}}), "save_pvtu: \"u\" is a map of another mesh", invalid_argument);
  CHECK_THROWS_WITH_AS(save_pvtu(d, path, {}, {.as_boundary = rank() == last}), doctest::Contains("and no boundary"), invalid_argument);
  if (last > 0) CHECK_THROWS_WITH_AS(save_pvtu(d, path, {{uv, u}}), doctest::Contains("the maps and properties are not the same on all processes"), invalid_argument);
  distributed<trimesh> with_own(MPI_COMM_WORLD, m, parts_of(m)[0]);
  if (rank() == last) vert_property<double>(with_own, "own");
  if (last > 0) CHECK_THROWS_WITH_AS(save_pvtu(with_own, path), doctest::Contains("not the same on all processes: ; vert \"own\""), invalid_argument);
  const std::string elsewhere = rank() == last ? path + "/no/folder.pvtu" : path;
  if (is_first()) write_file(path, "old");
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK_THROWS_AS(save_pvtu(d, elsewhere), io_error);
  trimesh infinite = m;
  if (is_first()) set_point(infinite, vert_id{0}, vec3{std::numeric_limits<double>::infinity(), 0, 0});
  const distributed<trimesh> e(MPI_COMM_WORLD, infinite, parts_of(m)[3]);
  CHECK_THROWS_AS(save_pvtu(e, path), invalid_mesh);
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK(read_file(path) == "old");
  MPI_Barrier(MPI_COMM_WORLD);  // before the first process counts, no other has files
  if (is_first()) CHECK(std::distance(std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()), std::filesystem::directory_iterator()) == 1);
}
