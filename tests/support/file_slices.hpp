// What tests of load_slice share: checks that the slices of a file are together its mesh, and small .vtu files.
#pragma once

#include <concino/io/load.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/mesh/property.hpp>

#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace concino::testing {

template<class M>
std::vector<std::uint64_t> slice_numbers(const M& m, const auto& around, const std::vector<std::uint64_t>* global) {
  std::vector<std::uint64_t> r;
  for (const auto v : around) r.push_back(global ? (*global)[index_of(m, v)] : index_of(m, v));
  return r;
}

/// Properties of elements, by kind, name and element, as bytes. Values of edges and faces that are 0 are left out: not each slice lists all.
using slice_values = std::map<std::string, std::string>;

template<class M>
void add_slice_values(const M& m, std::uint64_t first_poly, const std::vector<std::uint64_t>* global, slice_values& all) {
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
      const auto at = all.emplace(std::string(to_string(p.kind)) + " " + p.name + " " + key, value).first;
      if (at->second != value) CHECK(at->second == value);
    };
    if (p.kind == element_kind::vert)
      for (const auto v : verts(m)) add(index_of(m, v), vert_index_bound(m), key_of({global ? (*global)[index_of(m, v)] : index_of(m, v)}));
    if (p.kind == element_kind::poly)
      for (const auto x : polys(m)) add(index_of(m, x), poly_index_bound(m), key_of({first_poly + index_of(m, x)}));
    if (p.kind == element_kind::edge)
      for (const auto e : edges(m)) add(index_of(m, e), edge_index_bound(m), key_of(slice_numbers(m, adj_e2v(m, e), global)));
    if constexpr (dimension_v<M> == 3)
      if (p.kind == element_kind::face)
        for (const auto f : faces(m)) add(index_of(m, f), face_index_bound(m), key_of(slice_numbers(m, adj_f2v(m, f), global)));
    if (p.kind == element_kind::mesh) add(0, 1, "");
  }
}

/// Checks that the slices of a file are, together, its mesh.
template<class M>
void check_slices(const std::string& path, std::size_t most, const load_options& options = {}) {
  const M m = load<M>(path, options);
  slice_values expected;
  add_slice_values(m, 0, nullptr, expected);
  for (std::size_t n = 1; n <= most; ++n) {
    CAPTURE(n);
    slice_values found;
    std::vector<bool> has_vert(num_verts(m));
    std::uint64_t next_poly = 0;
    auto p = polys(m).begin();
    std::size_t num_wrong = 0;
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
        auto mine = slice_numbers(s.mesh, adj_p2v(s.mesh, q), &s.global_vert), his = slice_numbers(m, adj_p2v(m, *p), nullptr);
        if constexpr (arity_v<M> == 0) std::sort(mine.begin(), mine.end()), std::sort(his.begin(), his.end());
        num_wrong += mine != his;
        if constexpr (dimension_v<M> == 3) num_wrong += num_elements(adj_p2f(s.mesh, q)) != num_elements(adj_p2f(m, *p));
        ++p;
      }
      std::size_t i = 0;
      auto v = verts(m).begin();
      std::uint64_t at = 0;
      for (const auto w : verts(s.mesh)) {
        for (; at < s.global_vert[i]; ++at) ++v;
        has_vert[at] = true;
        num_wrong += !(point(s.mesh, w) == point(m, *v));
        ++i;
      }
      add_slice_values(s.mesh, s.first_poly, &s.global_vert, found);
    }
    CHECK(num_wrong == 0);
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

/// Cells of a .vtu file.
struct slice_vtu_cells {
  std::string types;
  std::vector<std::int32_t> lists, ends;
};
inline const slice_vtu_cells lines_between_polygons{"\5\3\5\x9\3\5", {0, 2, 1, 0, 1, 1, 2, 3, 2, 4, 5, 3, 6, 7, 4, 6, 5}, {3, 5, 8, 12, 14, 17}};

/// A .vtu file with appended arrays: eight points, and the cells. pack(bytes) compresses a block.
template<class Pack = std::nullptr_t>
std::string slice_vtu_text(const slice_vtu_cells& cells, Pack pack = nullptr) {
  constexpr bool compressed = !std::is_same_v<Pack, std::nullptr_t>;
  std::string data, tags;
  const auto array = [&](const char* type, const char* name, const char* more, const std::string& bytes) {
    tags += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + more + " format=\"appended\" offset=\"" + std::to_string(data.size()) + "\"/>\n";
    const auto word = [&](std::size_t x) {
      const auto w = static_cast<std::uint32_t>(x);
      data.append(reinterpret_cast<const char*>(&w), 4);
    };
    if constexpr (compressed) {
      constexpr std::size_t block = 20;  // numbers are in two blocks
      std::vector<std::string> blocks;
      for (std::size_t at = 0; at < bytes.size(); at += block) blocks.push_back(pack(bytes.substr(at, block)));
      word(blocks.size()), word(block), word(bytes.size() % block);
      for (const std::string& b : blocks) word(b.size());
      for (const std::string& b : blocks) data += b;
    } else {
      word(bytes.size());
      data += bytes;
    }
  };
  const auto bytes_of = [](const auto& all) { return std::string(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(all[0])); };
  std::vector<float> points;
  for (int i = 0; i < 8; ++i) points.insert(points.end(), {static_cast<float>(i / 2), static_cast<float>(i % 2), 0.f});
  std::vector<double> heat;
  for (std::size_t i = 0; i < cells.types.size(); ++i) heat.push_back(0.5 * static_cast<double>(i));
  tags += "<CellData>\n";
  array("Float64", "heat", "", bytes_of(heat));
  tags += "</CellData>\n<Points>\n";
  array("Float32", "Points", " NumberOfComponents=\"3\"", bytes_of(points));
  tags += "</Points>\n<Cells>\n";
  array("Int32", "connectivity", "", bytes_of(cells.lists));
  array("Int32", "offsets", "", bytes_of(cells.ends));
  array("UInt8", "types", "", cells.types);
  return std::string("<VTKFile type=\"UnstructuredGrid\"") + (compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"8\" NumberOfCells=\"" +
         std::to_string(cells.types.size()) + "\">\n" + tags + "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + data;
}

}  // namespace concino::testing
