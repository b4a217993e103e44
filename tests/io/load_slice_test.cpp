// Slices of binary mesh files: together they are the whole mesh, and each takes its part of the memory.
#include <concino/adapters/zlib.hpp>
#include <concino/io/load.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

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
std::vector<std::uint64_t> numbers_of(const M& m, const auto& around, const std::vector<std::uint64_t>* global) {
  std::vector<std::uint64_t> r;
  for (const auto v : around) r.push_back(global ? (*global)[index_of(m, v)] : index_of(m, v));
  return r;
}

/// Properties of elements, by kind, name and element, as bytes. Values of edges and faces that are 0 are left out: not each slice lists all.
using values = std::map<std::string, std::string>;

template<class M>
void add_values(const M& m, std::uint64_t first_poly, const std::vector<std::uint64_t>* global, values& all) {
  const auto key_of = [&](std::vector<std::uint64_t> of) {
    std::sort(of.begin(), of.end());
    std::string r;
    for (const std::uint64_t x : of) r += std::to_string(x) + ' ';
    return r;
  };
  for (const property_info& p : property_list(m)) {
    const std::string bytes = bytes_of_property(m, p);
    const auto add = [&](std::size_t i, std::size_t bound, const std::string& key) {
      const std::size_t size = bytes.size() / bound;
      const std::string value = bytes.substr(i * size, size);
      if (value.find_first_not_of('\0') == value.npos) return;
      const auto [at, is_new] = all.emplace(std::string(to_string(p.kind)) + " " + p.name + " " + key, value);
      CHECK(at->second == value);
    };
    if (p.kind == element_kind::vert)
      for (const auto v : verts(m)) add(index_of(m, v), vert_index_bound(m), key_of({global ? (*global)[index_of(m, v)] : index_of(m, v)}));
    if (p.kind == element_kind::poly)
      for (const auto x : polys(m)) add(index_of(m, x), poly_index_bound(m), key_of({first_poly + index_of(m, x)}));
    if (p.kind == element_kind::edge)
      for (const auto e : edges(m)) add(index_of(m, e), edge_index_bound(m), key_of(numbers_of(m, adj_e2v(m, e), global)));
    if constexpr (dimension_v<M> == 3)
      if (p.kind == element_kind::face)
        for (const auto f : faces(m)) add(index_of(m, f), face_index_bound(m), key_of(numbers_of(m, adj_f2v(m, f), global)));
    if (p.kind == element_kind::mesh) add(0, 1, "");
  }
}

/// Checks that the slices of a file are, together, its mesh.
template<class M>
void check_slices(const std::string& path, std::size_t most, const load_options& options = {}) {
  const M m = load<M>(path, options);
  values expected;
  add_values(m, 0, nullptr, expected);
  for (std::size_t n = 1; n <= most; ++n) {
    CAPTURE(n);
    values found;
    std::vector<bool> has_vert(num_verts(m));
    std::uint64_t next_poly = 0;
    auto p = polys(m).begin();
    for (std::size_t k = 0; k < n; ++k) {
      const mesh_slice<M> s = load_slice<M>(path, k, n, options);
      CHECK(s.num_polys == num_polys(m));
      CHECK(s.num_verts == num_verts(m));
      CHECK(s.first_poly == next_poly);
      REQUIRE(s.global_vert.size() == num_verts(s.mesh));
      CHECK(std::is_sorted(s.global_vert.begin(), s.global_vert.end()));
      CHECK(num_polys(s.mesh) <= num_polys(m) / n + 1);
      next_poly += num_polys(s.mesh);
      for (const auto q : polys(s.mesh)) {
        auto mine = numbers_of(s.mesh, adj_p2v(s.mesh, q), &s.global_vert), his = numbers_of(m, adj_p2v(m, *p), nullptr);
        if constexpr (arity_v<M> == 0) std::sort(mine.begin(), mine.end()), std::sort(his.begin(), his.end());
        CHECK(mine == his);
        if constexpr (dimension_v<M> == 3) CHECK(num_elements(adj_p2f(s.mesh, q)) == num_elements(adj_p2f(m, *p)));
        ++p;
      }
      std::size_t i = 0;
      auto v = verts(m).begin();
      std::uint64_t at = 0;
      for (const auto w : verts(s.mesh)) {
        for (; at < s.global_vert[i]; ++at) ++v;
        has_vert[at] = true;
        CHECK(point(s.mesh, w) == point(m, *v));
        ++i;
      }
      add_values(s.mesh, s.first_poly, &s.global_vert, found);
    }
    CHECK(next_poly == num_polys(m));
    std::size_t missing = 0;
    for (const auto v : verts(m)) missing += !has_vert[index_of(m, v)] && num_elements(adj_v2p(m, v)) > 0;
    CHECK(missing == 0);
    for (const auto& value : expected)
      if (!found.contains(value.first)) {
        CAPTURE(value.first);
        CHECK(value.first.starts_with("vert"));  // of a vert of no poly
      }
    CHECK(found.size() <= expected.size());
  }
}

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
