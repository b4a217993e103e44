// Reads the values of points and cells in legacy VTK files: attributes and fields.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/detail/vtk/vtk_cells_reader.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace concino::detail {

class vtk_values_reader : public vtk_cells_reader {
 protected:
  load_report& report_;
  element_kind kind_ = element_kind::mesh;  // the elements of the values that follow
  std::uint64_t tuples_ = 0;                // and their number in the file

  vtk_values_reader(const read_context& c, vtk_grid& grid) : vtk_cells_reader(c, grid), report_(*c.report) {}

  vtk_number number_type() {
    skip();
    const char* const from = at;
    const vtk_number t = vtk_number_of_legacy(next_keyword());
    if (t == vtk_number::none) reject(from, {"a type of numbers, such as double or int"});
    return t;
  }

  /// SCALARS, VECTORS and similar sections: a name, a type, and values for every point or cell.
  void read_attribute(const std::string& keyword, const char* from) {
    struct row {
      std::string_view keyword;
      std::size_t components;  // 0: in the file
    };
    static constexpr row rows[] = {
        {"scalars", 0},  {"vectors", 3},    {"normals", 3},      {"texture_coordinates", 0}, {"tensors", 9},
        {"tensors6", 6}, {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1},          {"color_scalars", 0}};
    for (const row& r : rows) {
      if (r.keyword != keyword) continue;
      if (kind_ == element_kind::mesh) reject(from, {"POINT_DATA or CELL_DATA before values"});
      std::string array = next_name();
      std::size_t components = r.components;
      if (keyword == "texture_coordinates" || keyword == "color_scalars")
        components = next_number("the number of values per element");
      if (keyword == "color_scalars") return read_colors(array, components, from);
      const vtk_number type = number_type();
      if (keyword == "scalars") {
        components = number_on_line(1);
        skip();
        const char* const table = at;
        if (next_keyword() == "lookup_table") next_name();
        else at = table;
      }
      if (keyword == "normals") use_reserved_name(array, "normal");
      if (keyword == "texture_coordinates" && components == 2) use_reserved_name(array, "texture");
      begin_numbers();
      return read_column(array, type, components, tuples_, from, keyword == "normals" || array == "texture");
    }
    reject(from, {"a section, such as POINTS, CELLS, POINT_DATA or SCALARS"});
  }

  void read_field_data() {
    next_name();
    std::uint64_t arrays = next_number("the number of arrays");
    for (; arrays > 0; --arrays) {
      skip();
      const char* const from = at;
      if (at_end()) reject(at, {"the name of an array"});
      const std::string array = next_name();
      if (std::string_view(from, static_cast<std::size_t>(at - from)) == "METADATA") {
        skip_metadata();
        ++arrays;
        continue;
      }
      const std::uint64_t components = next_number("the number of values per element"),
                          tuples = next_number("the number of elements");
      skip();
      const char* const type_name = at;
      const std::string type = next_keyword();
      begin_numbers();
      if (type == "string" || type == "variant") {
        if (type == "variant" || (components && tuples > left() / components))
          reject(type_name, {"a type of numbers, or texts that fit into the file"});
        report_.skipped.push_back(core::joined({"array \"", array, "\" of texts"}));
        skip_strings(components * tuples);
        continue;
      }
      const vtk_number number = vtk_number_of_legacy(type);
      if (number == vtk_number::none) reject(type_name, {"a type of numbers, such as double or int"});
      read_column(array, number, components, tuples, from, false);
    }
  }

  /// Skips a block that ends with an empty line.
  void skip_metadata() {
    for (skip_line(); !at_end(); skip_line()) {
      at += *at == '\r' && left() > 1 && at[1] == '\n' ? 2 : 1;
      const char* const from = at;
      while (!at_end() && is_blank(*at)) ++at;
      if (at_end() || is_line_end(*at)) return;
      at = from;
    }
  }

 private:
  /// The number of the elements to which the values belong.
  std::uint64_t num_elements() const {
    return kind_ == element_kind::vert ? grid_.points.size() : kind_ == element_kind::poly ? grid_.size() : 1;
  }

  void use_reserved_name(std::string& array, const char* reserved) {
    if (array != reserved)
      report_.notes.push_back(core::joined({"the array \"", array, "\" is the property \"", reserved, "\""}));
    array = reserved;
  }

  /// Reads the values of a column, or skips them. `as_doubles`: stores numbers of any type as doubles.
  void read_column(const std::string& array, vtk_number type, std::size_t components, std::uint64_t tuples,
                   const char* from, bool as_doubles) {
    if (components > max_count || tuples > max_count)
      reject(from, {"a count that fits into the file"}, {components > max_count ? components : tuples});
    const std::uint64_t n = tuples * components;
    require_room(from, n, type);
    const value_type* const stored = property_type_of(as_doubles ? vtk_number::float64 : type, components, array);
    if (kind_ != element_kind::mesh && tuples != num_elements()) {
      report_.skipped.push_back(core::joined({"array \"", array, "\" of ", tuples, " values, where ", num_elements(),
          kind_ == element_kind::vert ? " points" : " cells", " need one each"}));
      return skip_values(type, n);
    }
    if (!stored || tuples != num_elements()) {
      report_.skipped.push_back(
          core::joined({"array \"", array, "\" of ", tuples, " values of ", components,
                        " numbers: properties have one value for each element, of 1, 2, 3, 4, 6 or 9 numbers"}));
      return skip_values(type, n);
    }
    grid_.columns.push_back({kind_, array, make_column(*stored, tuples)});
    void* const to = grid_.columns.back().values->data();
    if (!as_doubles || type == vtk_number::float64) return read_values_of(type, to, n);
    with_number_type(type, [&]<class T>(std::type_identity<T>) {
      if constexpr (!std::is_same_v<T, bool>)
        for (std::uint64_t i = 0; i < n; ++i) {
          T x;
          read_values(&x, 1);
          static_cast<double*>(to)[i] = static_cast<double>(x);
        }
    });
  }

  /// COLOR_SCALARS: reals from 0 to 1 in text files, bytes in binary ones.
  void read_colors(std::string& array, std::size_t components, const char* from) {
    begin_numbers();
    const vtk_number type = binary_ ? vtk_number::uint8 : vtk_number::float32;
    if ((components != 3 && components != 4) || tuples_ != num_elements())
      return read_column(array, type, components, tuples_, from, false);
    require_room(from, tuples_ * components, type);
    use_reserved_name(array, "color");
    grid_.columns.push_back({kind_, array, make_column(values_of<rgba>, tuples_)});
    auto* const to = static_cast<rgba*>(grid_.columns.back().values->data());
    for (std::uint64_t i = 0; i < tuples_; ++i) {
      float channels[4] = {1, 1, 1, 1};
      for (std::size_t k = 0; k < components; ++k)
        channels[k] = binary_ ? static_cast<float>(static_cast<unsigned char>(*at++) / 255.0) : next_value<float>();
      to[i] = {channels[0], channels[1], channels[2], channels[3]};
    }
  }
};

}  // namespace concino::detail
