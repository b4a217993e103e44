// The reader of legacy VTK files.
#pragma once

#include <concino/io/detail/vtk/vtk_format.hpp>
#include <concino/io/detail/vtk/vtk_mesh.hpp>
#include <concino/io/detail/vtk/vtk_values_reader.hpp>

namespace concino::detail {

/// Reads a legacy VTK file into a grid.
class vtk_reader : public vtk_values_reader {
  std::uint64_t num_tables_ = 0;

 public:
  vtk_reader(const read_context& c, vtk_grid& grid) : vtk_values_reader(c, grid) {}

  void read() {
    header();
    for (;;) {
      skip();
      if (at_end() || (!binary_ && text_without_padding({at, left()}).empty())) break;
      section();
    }
    if (num_tables_) report_.skipped.push_back(core::joined({num_tables_, " lookup tables of colours"}));
    finish_cells();
  }

 private:
  void header() {
    constexpr std::string_view first = "# vtk DataFile Version ";
    if (at_end()) fail(at, {"# vtk DataFile Version"}, {"an empty file"});
    if (left() < first.size() || std::string_view(at, first.size()) != first) fail(at, "# vtk DataFile Version");
    at += first.size();
    real("the version, such as 3.0", 0);
    skip_line();
    if (left() > 1 && *at == '\r' && at[1] == '\n') ++at;
    if (!at_end()) ++at;
    skip_line();  // the title
    skip();
    const char* const from = at;
    const std::string form = next_keyword();
    if (form != "ascii" && form != "binary") fail(from, "ASCII or BINARY");
    binary_ = form == "binary";
    binary_line_ = from;
    skip();
    const char* const dataset = at;
    if (next_keyword() != "dataset") reject(dataset, {"DATASET"});
    skip();
    const char* const type = at;
    const std::string kind = next_keyword();
    if (kind == "polydata") is_polydata_ = true;
    else if (kind != "unstructured_grid")
      core::throw_joined<unsupported>({name(), ": DATASET '",
                                       std::string_view(type, static_cast<std::size_t>(at - type)).substr(0, 40),
                                       "' is not supported; UNSTRUCTURED_GRID and POLYDATA are"});
  }

  void section() {
    const char* const from = at;
    const std::string keyword = next_keyword();
    if (keyword == "points") return points(from);
    if (read_cells(keyword, from)) return;
    if (keyword == "point_data" || keyword == "cell_data") {
      kind_ = keyword == "point_data" ? element_kind::vert : element_kind::poly;
      if (kind_ == element_kind::poly) finish_cells();
      tuples_ = next_number("the number of values");
    } else if (keyword == "metadata") {
      skip_metadata();
    } else if (keyword == "field") {
      read_field_data();
    } else if (keyword == "lookup_table") {
      next_name();
      const std::uint64_t n = next_number("the size of the table");
      begin_numbers();
      require_room(from, n > max_count ? n : 4 * n, vtk_number::uint8);
      skip_values(vtk_number::uint8, 4 * n);
      ++num_tables_;
    } else {
      read_attribute(keyword, from);
    }
  }

  void points(const char* from) {
    if (!grid_.points.empty()) reject(from, {"one section POINTS"}, {"another"});
    const std::uint64_t n = next_number("the number of points");
    const vtk_number type = number_type();
    begin_numbers();
    require_room(from, n > max_count ? n : 3 * n, type);
    if (n > max_ids) fail_to_count("points");
    grid_.points.reserve(n);
    const char* const first = at;
    if (type == vtk_number::float64) {
      grid_.points.resize(n);
      read_values_of(type, grid_.points.data(), 3 * n);
    } else with_number_type(type, [&]<class T>(std::type_identity<T>) {
      for (std::uint64_t i = 0; i < n; ++i) {
        if constexpr (std::is_same_v<T, bool>) reject(from, {"points of numbers"}, {"bits"});
        else if (binary_) point_of<T>();
        else point_of<double>();
      }
    });
    for (std::size_t i = 0; i < grid_.points.size(); ++i)
      if (!is_finite(grid_.points[i])) fail_point(first, i, vtk_names_of(type).size);
  }
  template<class T>
  void point_of() {
    T x[3];
    read_values(x, 3);
    grid_.points.push_back({x[0], x[1], x[2]});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail_point(const char* first, std::size_t i, std::size_t size) {
    at = first;
    skip_values(vtk_number::uint8, binary_ ? 3 * size * i : 3 * i);
    skip();
    reject(at, {"the coordinates of a point, finite numbers"});
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a legacy VTK file, versions 2.0 to 5.1, ASCII or BINARY, with an UNSTRUCTURED_GRID or POLYDATA.
/// Result: a volume if there is any cell of a volume, else a surface. Polys keep their order. The verts of cells of
///         negative volume are put into the standard order, polyhedra are turned outward, and both are counted. Arrays
///         of numbers become properties: those of the cells become properties of polys, and in a volume those of its
///         polygons become properties of faces. Lines, verts and texts are reported as skipped. Elements of second or
///         higher order are read by their corners, if load_options::corners_only is set; points that are only their
///         other nodes are reported as skipped, and so are arrays that have not one value for each element.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line, or in binary files the byte, of what is wrong; unsupported for other datasets
///         and cell types, and if the file holds a volume and a surface was wanted, or the reverse.
template<std::derived_from<file_contents> Contents>
void vtk_format::read(const read_context& in, Contents& out) {
  detail::vtk_grid grid;
  detail::vtk_reader reader(in, grid);
  reader.read();
  detail::vtk_mesh<Contents>(grid, in, reader, out).make();
}

}  // namespace concino
