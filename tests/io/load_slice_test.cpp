// Slices of binary mesh files: together they are the whole mesh, and each takes its part of the memory.
#include <concino/adapters/zlib.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
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
      const auto at = all.emplace(std::string(to_string(p.kind)) + " " + p.name + " " + key, value).first;
      if (at->second != value) CHECK(at->second == value);
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
        auto mine = numbers_of(s.mesh, adj_p2v(s.mesh, q), &s.global_vert), his = numbers_of(m, adj_p2v(m, *p), nullptr);
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
      add_values(s.mesh, s.first_poly, &s.global_vert, found);
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

/// A .vtu file with appended arrays: points, and cells with lines between the triangles.
std::string vtu_text(bool compressed, const std::string& types, const std::vector<std::int32_t>& lists, const std::vector<std::int32_t>& ends) {
  std::string data, tags;
  const auto array = [&](const char* type, const char* name, const char* more, const std::string& bytes) {
    tags += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + more + " format=\"appended\" offset=\"" + std::to_string(data.size()) + "\"/>\n";
    const auto word = [&](std::size_t x) {
      const auto w = static_cast<std::uint32_t>(x);
      data.append(reinterpret_cast<const char*>(&w), 4);
    };
    if (!compressed) {
      word(bytes.size());
      data += bytes;
      return;
    }
    constexpr std::size_t block = 20;  // numbers are in two blocks
    std::vector<std::string> blocks;
    for (std::size_t at = 0; at < bytes.size(); at += block) {
      const std::string part = bytes.substr(at, block);
      std::string packed(compressBound(part.size()), 0);
      uLongf size = packed.size();
      compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(part.data()), part.size());
      blocks.push_back(packed.substr(0, size));
    }
    word(blocks.size()), word(block), word(bytes.size() % block);
    for (const std::string& b : blocks) word(b.size());
    for (const std::string& b : blocks) data += b;
  };
  const auto bytes_of = [](const auto& all) { return std::string(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(all[0])); };
  std::vector<float> points;
  for (int i = 0; i < 8; ++i) points.insert(points.end(), {static_cast<float>(i / 2), static_cast<float>(i % 2), 0.f});
  std::vector<double> heat;
  for (std::size_t i = 0; i < types.size(); ++i) heat.push_back(0.5 * static_cast<double>(i));
  tags += "<CellData>\n";
  array("Float64", "heat", "", bytes_of(heat));
  tags += "</CellData>\n<Points>\n";
  array("Float32", "Points", " NumberOfComponents=\"3\"", bytes_of(points));
  tags += "</Points>\n<Cells>\n";
  array("Int32", "connectivity", "", bytes_of(lists));
  array("Int32", "offsets", "", bytes_of(ends));
  array("UInt8", "types", "", types);
  return std::string("<VTKFile type=\"UnstructuredGrid\"") + (compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"8\" NumberOfCells=\"" +
         std::to_string(types.size()) + "\">\n" + tags + "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + data;
}

std::string says(const std::string& path, std::size_t k, std::size_t n, const load_options& options = {}) {
  try {
    load_slice<polygonmesh>(path, k, n, options);
    return "";
  } catch (const error& e) {
    return std::string(e.what()).substr(path.size());
  }
}

}  // namespace

TEST_CASE("load_slice: compressed arrays, of which a slice reads some blocks, and lines between polygons") {
  const temporary_folder folder;
  for (const bool compressed : {false, true}) {
    const std::string text = vtu_text(compressed, "\5\3\5\x9\3\5", {0, 2, 1, 0, 1, 1, 2, 3, 2, 4, 5, 3, 6, 7, 4, 6, 5}, {3, 5, 8, 12, 14, 17});
    write_file(folder / "m.vtu", text);
    check_slices<polygonmesh>(folder / "m.vtu", 5, {.inflate = zlib_inflate});
    load_report report;
    const auto s = load_slice<polygonmesh>(folder / "m.vtu", 1, 2, {.report = &report, .inflate = zlib_inflate});
    CHECK(s.first_poly == 2);
    CHECK(s.num_polys == 4);
    CHECK(s.global_vert == std::vector<std::uint64_t>{2, 3, 4, 5, 6});
    CHECK(find_poly_property<double>(s.mesh, "heat")[*polys(s.mesh).begin()] == 1.5);
    if (compressed) CHECK(says(folder / "m.vtu", 0, 2).starts_with(": the arrays are compressed"));
  }
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
    write_file(folder / "w.vtu", vtu_text(false, types, lists, ends));
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
  for (const corpus_row& row : corpus_meshes()) {
    if (std::filesystem::file_size(row.file) > (long_run() ? 3000000 : 100000)) continue;
    CAPTURE(row.name);
    std::visit(
        [&]<class M>(const M& m) {
          save(m, folder / "m.vtu", {.binary = true});
          check_slices<M>(folder / "m.vtu", 3);
          try {
            save(m, folder / "m.meshb");
          } catch (const unsupported&) {  // polys of other shapes
            return;
          }
          check_slices<M>(folder / "m.meshb", 3);
        },
        load_any(row.file.string()));
  }
}
