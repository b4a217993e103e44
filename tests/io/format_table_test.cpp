// The tables of docs/formats.md: which kinds of mesh each format takes and gives, and which values come back from its files. Each cell is what meshes
// showed that were saved and loaded again. With CONCINO_WRITE_TABLES=1 the test writes the tables to the page.
#include <concino/convert.hpp>
#include <concino/io.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using texture = std::array<double, 2>;

// The values of elements: they follow from a number, which is different for the elements of a small grid, however these are numbered.
template<class T> T value_of(int k);
template<> int value_of<int>(int k) { return k; }
template<> double value_of<double>(int k) { return 0.5 * k; }
template<> rgba value_of<rgba>(int k) { return {float(k & 1), float(k >> 1 & 1), float(k >> 2 & 1), 1}; }
template<> vec3 value_of<vec3>(int k) { return {k % 3 == 0 ? 1. : 0., k % 3 == 1 ? 1. : 0., k % 3 == 2 ? 1. : 0.}; }
template<> texture value_of<texture>(int k) { return {0.25 * k, 0.125 * k}; }
template<> label_names value_of<label_names>(int) { return {{{element_kind::poly, 1, "upper"}, {element_kind::poly, 2, "lower"}}}; }

template<class M, class Range>
int number_at(const M& m, const Range& verts_of_element) {
  vec3 sum{};
  for (const auto v : verts_of_element) sum = sum + point(m, v);
  return 1 + static_cast<int>(4 * sum.x + 100 * sum.y + 2500 * sum.z);
}

/// A property: the column of the table that says whether its values come back.
template<class T, element_kind Kind>
struct property_column_of_table {
  std::string_view title, name;

  template<class M>
  static constexpr bool fits = (Kind != element_kind::face || dimension_v<M> == 3) && (Kind != element_kind::corner || dimension_v<M> == 2);

  /// The property of a mesh, created if the mesh is not const.
  template<class M>
  auto of(M& m) const {
    constexpr bool find = std::is_const_v<M>;
    if constexpr (Kind == element_kind::vert && find) return find_vert_property<T>(m, name);
    else if constexpr (Kind == element_kind::vert) return vert_property<T>(m, name);
    else if constexpr (Kind == element_kind::edge && find) return find_edge_property<T>(m, name);
    else if constexpr (Kind == element_kind::edge) return edge_property<T>(m, name);
    else if constexpr (Kind == element_kind::face && find) return find_face_property<T>(m, name);
    else if constexpr (Kind == element_kind::face) return face_property<T>(m, name);
    else if constexpr (Kind == element_kind::poly && find) return find_poly_property<T>(m, name);
    else if constexpr (Kind == element_kind::poly) return poly_property<T>(m, name);
    else if constexpr (Kind == element_kind::corner && find) return find_corner_property<T>(m, name);
    else if constexpr (Kind == element_kind::corner) return corner_property<T>(m, name);
    else if constexpr (find) return find_mesh_property<T>(m, name);
    else return mesh_property<T>(m, name);
  }

  /// Calls f(value in the mesh, value that is expected there) for each element.
  template<class M, class F>
  static void for_each(M& m, const F& f, auto&& values) {
    const auto each = [&](const auto& elements, const auto& verts_of) {
      for (const auto x : elements) f(values[x], value_of<T>(number_at(m, verts_of(x))));
    };
    if constexpr (Kind == element_kind::vert) each(verts(m), [](auto v) { return std::array{v}; });
    else if constexpr (Kind == element_kind::edge) each(edges(m), [&](auto e) { return adj_e2v(m, e); });
    else if constexpr (Kind == element_kind::face) each(faces(m), [&](auto x) { return adj_f2v(m, x); });
    else if constexpr (Kind == element_kind::poly) each(polys(m), [&](auto p) { return adj_p2v(m, p); });
    else if constexpr (Kind == element_kind::mesh) f(*values, value_of<T>(1));
    else
      for (const auto p : polys(m)) {
        std::size_t k = 0;
        for (const auto v : adj_p2v(m, p)) f(values.of(p)[k++], value_of<T>(number_at(m, std::array{v}) + number_at(m, adj_p2v(m, p))));
      }
  }

  template<class M>
  void give(M& m) const {
    for_each(m, [](T& value, const T& wanted) { value = wanted; }, of(m));
    if constexpr (std::is_same_v<T, label_names>) {
      const auto label = poly_property<int>(m, "label");
      for (const auto p : polys(m)) label[p] = 1 + static_cast<int>(index_of(m, p)) % 2;
    }
  }
  /// Whether the polys have the names that they were given; their labels may be others.
  template<class M>
  static bool names_are_in(const M& m, const label_names& names) {
    const auto label = find_poly_property<int>(m, "label");
    if (!label) return false;
    for (const auto p : polys(m)) {
      const label_name* const name = names.find(element_kind::poly, label[p]);
      if (!name || name->name != value_of<label_names>(1).names[index_of(m, p) % 2].name) return false;
    }
    return true;
  }
  template<class M>
  bool is_in(const M& m) const {
    try {
      bool all = true;
      const auto values = of(m);
      if (!values) return false;
      if constexpr (std::is_same_v<T, label_names>) return names_are_in(m, *values);
      for_each(m, [&](const T& value, const T& wanted) { all = all && value == wanted; }, values);
      return all;
    } catch (const invalid_argument&) {  // values of another type
      return false;
    }
  }
};

template<class F>
void for_each_column(const F& f) {
  const auto column = [&]<class T, element_kind Kind>(std::string_view title, std::string_view name) { f(property_column_of_table<T, Kind>{title, name}); };
  column.template operator()<int, element_kind::vert>("labels of verts", "label");
  column.template operator()<int, element_kind::edge>("edges", "label");
  column.template operator()<int, element_kind::face>("faces", "label");
  column.template operator()<int, element_kind::poly>("polys", "label");
  column.template operator()<label_names, element_kind::mesh>("names of labels", "label_names");
  column.template operator()<rgba, element_kind::vert>("colours of verts", "color");
  column.template operator()<rgba, element_kind::poly>("polys", "color");
  column.template operator()<vec3, element_kind::vert>("normals of verts", "normal");
  column.template operator()<texture, element_kind::vert>("textures of verts", "texture");
  column.template operator()<texture, element_kind::corner>("corners", "texture");
  column.template operator()<double, element_kind::vert>("numbers of verts", "number");
  column.template operator()<double, element_kind::edge>("edges", "number");
  column.template operator()<double, element_kind::face>("faces", "number");
  column.template operator()<double, element_kind::poly>("polys", "number");
  column.template operator()<double, element_kind::mesh>("the mesh", "number");
}

/// Files of formats that are only read: one for triangles, quads, other polygons, and so on, where the format has them.
std::vector<std::string> samples_of(format_id format) {
  const std::string iv = "#Inventor V2.1 ascii\nCoordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 2 0 ] }\nIndexedFaceSet { coordIndex [ ";
  const std::string nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=";
  if (format == file_format::abaqus)
    return {nodes + "S3\n1, 1, 2, 3\n", nodes + "S4\n1, 1, 2, 3, 4\n", nodes + "C3D4\n1, 1, 2, 3, 5\n", nodes + "C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"};
  if (format == file_format::iv) return {iv + "0, 1, 2, -1, 0, 2, 3, -1 ] }\n", iv + "0, 1, 2, 3, -1 ] }\n", iv + "0, 1, 2, 4, 3, -1 ] }\n"};
  return {};
}

/// Saves a mesh, and calls loaded(mesh) with what is loaded from the file. Result: whether it was saved.
template<class M, class F>
bool saves(const M& m, format_id format, bool binary, const std::string& path, const F& loaded) {
  try {
    if (format == file_format::pvtu) save_pvtu(m, path, make_poly_map<int>(m), {.binary = binary});  // save has no parts
    else save(m, path, {.format = format, .binary = binary});
  } catch (const unsupported&) {
    return false;
  }
  try {
    loaded(load<M>(path, {.format = format}));
  } catch (const unsupported&) {  // formats that are only written
  }
  return true;
}

template<class M>
bool loads(format_id format, const std::string& path) {
  for (const std::string& text : samples_of(format)) {
    write_file(path, text);
    try {
      if (num_polys(load<M>(path, {.format = format})) > 0) return true;
    } catch (const error&) {  // a sample for other kinds
    }
  }
  return false;
}

/// Whether the mesh of a file is the one that was saved; some formats number verts anew.
template<class M>
bool is_same(const M& a, const M& b) {
  if (num_verts(a) != num_verts(b) || num_edges(a) != num_edges(b) || num_polys(a) != num_polys(b)) return false;
  auto p = polys(b).begin();
  for (const auto q : polys(a))
    if (number_at(a, adj_p2v(a, q)) != number_at(b, adj_p2v(b, *p++))) return false;
  return true;
}

struct table_row {
  std::string kinds, values;  // its cells
};

struct value_counts {
  int held = 0, kept = 0;  // kinds of mesh that are saved with such values, and whose values come back
};

/// Small grids of each shape of polys that the kind has.
template<class M>
std::vector<M> grids() {
  std::vector<M> all;
  all.push_back(grid<M>(2));
  if constexpr (std::is_same_v<M, polygonmesh>) {
    all.emplace_back(quad_grid(2));
    all.emplace_back(triangle_grid(2));
  }
  if constexpr (std::is_same_v<M, polyhedralmesh>) {
    all.push_back(convert<polyhedralmesh>(grid<hexmesh>(2)));
    all.push_back(convert<polyhedralmesh>(grid<tetmesh>(2)));
  }
  return all;
}

template<class M>
void add_cells(format_id format, const std::string& path, std::string& kinds, std::vector<value_counts>& counts) {
  const std::vector<M> all = grids<M>();
  std::size_t num_saved = 0, num_loaded = 0;
  M held = all[0];
  for (const M& m : all) {
    bool saved = false, loaded = false;
    for (const bool binary : {false, true})
      saved = saves(m, format, binary, path, [&](const M& back) { loaded = loaded || is_same(m, back); }) || saved;
    if (saved && num_saved == 0) held = m;
    num_saved += saved;
    num_loaded += loaded;
  }
  const std::string some = num_saved > 0 && num_saved < all.size() ? "some" : "";
  const bool is_loaded = num_loaded > 0 || loads<M>(format, path);
  CHECK((num_loaded == 0 || num_loaded == num_saved));
  kinds += num_saved == 0 ? (is_loaded ? " load |" : " |") : is_loaded ? (some.empty() ? " + |" : " some |") : some.empty() ? " save |" : " save some |";
  std::size_t i = 0;
  for_each_column([&]<class T, element_kind Kind>(const property_column_of_table<T, Kind>& column) {
    value_counts& count = counts.at(i++);
    if constexpr (property_column_of_table<T, Kind>::template fits<M>) {
      M m = held;
      column.give(m);
      bool is_held = false, is_kept = false;
      for (const bool binary : {false, true})
        is_held = saves(m, format, binary, path, [&](const M& back) { is_kept = is_kept || column.is_in(back); }) || is_held;
      count.held += is_held;
      count.kept += is_kept;
    }
  });
}

template<class... Kinds>
table_row row_of(format_id format, const std::string& path) {
  table_row row;
  std::vector<value_counts> counts;
  for_each_column([&](const auto&) { counts.emplace_back(); });
  (add_cells<Kinds>(format, path, row.kinds, counts), ...);
  for (const auto& [held, kept] : counts) row.values += kept == 0 ? " |" : kept == held ? " + |" : " some |";
  return row;
}

const std::filesystem::path page = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "docs" / "formats.md";

/// Replaces what stands between <!-- name --> and <!-- end of name -->.
std::string with_table(std::string text, const std::string& name, const std::string& table) {
  const std::string first = "<!-- " + name + " -->\n", last = "<!-- end of " + name + " -->";
  const std::size_t from = text.find(first), to = text.find(last);
  REQUIRE(from != text.npos);
  REQUIRE(to != text.npos);
  return text.replace(from + first.size(), to - from - first.size(), table);
}

}  // namespace

TEST_CASE("formats: the tables of docs/formats.md say what meshes show that are saved and loaded again") {
  const temporary_folder folder;
  std::string kinds = "| | trimesh | quadmesh | polygonmesh | tetmesh | hexmesh | polyhedralmesh |\n|---|:-:|:-:|:-:|:-:|:-:|:-:|\n", values = "| |", line = "|---|";
  for_each_column([&](const auto& column) {
    values += " " + std::string(column.title) + " |";
    line += ":-:|";
  });
  values += "\n" + line + "\n";
  const auto add = [&]<class F>(F format) {
    const std::string extension(*std::begin(F::extensions));
    CAPTURE(extension);
    const table_row row = row_of<CONCINO_ALL_KINDS>(format, folder / (extension[0] == '.' ? "mesh" + extension : extension));  // a file, or a folder of that name
    CHECK(row.kinds.find_first_not_of(" |") != row.kinds.npos);  // else a format that is only read needs samples above
    kinds += "| `" + extension + "` |" + row.kinds + "\n";
    if (row.values.find_first_not_of(" |") != row.values.npos) values += "| `" + extension + "` |" + row.values + "\n";
  };
  [&]<class... F>(format_list<F...>) { (add(F{}), ...); }(standard_formats);
  const std::string there = read_file(page.string()), made = with_table(with_table(there, "kinds", kinds), "values", values);
  if (std::getenv("CONCINO_WRITE_TABLES")) write_file(page.string(), made);
  else CHECK_MESSAGE(there == made, "the tables should be:\n" << kinds << "\n" << values << "\nCONCINO_WRITE_TABLES=1 writes them to the page");
}
