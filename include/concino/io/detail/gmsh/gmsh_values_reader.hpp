// Reads the values of nodes and elements in Gmsh files.
#pragma once

#include <concino/io/detail/gmsh/gmsh_elements_reader.hpp>

namespace concino::detail {

class gmsh_values_reader : protected gmsh_elements_reader {
  std::uint64_t num_unknown_[2] = {};  // values of elements and nodes that the file does not have
  std::uint64_t num_replaced_ = 0;
  std::uint64_t num_numbers_ = 0;  // of all properties

 protected:
  using gmsh_elements_reader::gmsh_elements_reader;

  /// Reads $NodeData or $ElementData. Those of one name and step, as for several partitions, are united.
  void values(bool of_nodes) {
    const std::string_view section = of_nodes ? "NodeData" : "ElementData";
    if (!(of_nodes ? has_nodes_ : has_elements_)) reject(at, {of_nodes ? "$Nodes" : "$Elements", " before $", section});
    gmsh_values v{of_nodes, std::string(section), 0, 0};
    const std::uint64_t rows = header(v);
    const value_type* const type = property_type_of(vtk_number::float64, v.components, "");
    if (!type)
      report_.skipped.push_back(
          core::joined({"values \"", v.name, "\" of ", v.components, " numbers: properties have 1, 2, 3, 4, 6 or 9"}));
    gmsh_values& to = values_like(v);
    const std::size_t n = of_nodes ? grid_.points.size() : grid_.num_elements;
    if (type && to.values.empty()) make_room(to, n);
    to.is_set.resize(n);
    for (std::uint64_t i = 0; i < rows; ++i) {
      const std::uint64_t tag = take_row_tag();
      const std::uint32_t e = (of_nodes ? grid_.node_tags : grid_.element_tags).find(tag);
      const bool is_known = e < n;
      num_unknown_[of_nodes] += !is_known;
      if (is_known) {
        num_replaced_ += to.is_set[e];
        to.is_set[e] = true;
        if (!of_nodes) to.has_dimension[dimension_of(e)] = true;
      }
      for (std::size_t k = 0; k < v.components; ++k) {
        const double x = take_real("a value");
        if (type && is_known) to.values[e * v.components + k] = x;
      }
      report_progress();
    }
    if (!type) grid_.values.pop_back();
    end_section(section);
  }

  void report_values() {
    if (num_unknown_[0])
      report_.skipped.push_back(core::joined({num_unknown_[0], " values of elements that the file does not have"}));
    if (num_unknown_[1])
      report_.skipped.push_back(core::joined({num_unknown_[1], " values of nodes that the file does not have"}));
    if (num_replaced_)
      report_.skipped.push_back(core::joined({num_replaced_,
                                              " values of nodes or elements that have another one of "
                                              "the same name and step, which follows"}));
  }

 private:
  /// Properties have values for all elements, also where the file has few. Errors: unsupported for so many sections of
  /// few values that the properties would be very much larger than the file.
  void make_room(gmsh_values& v, std::size_t n) {
    num_numbers_ += (n + 1) * v.components;
    if (num_numbers_ / 16 > static_cast<std::uint64_t>(end() - begin()))
      core::throw_joined<unsupported>({name(),
                                       ": very many sections with values of few nodes or elements: properties "
                                       "of ",
                                       num_numbers_, " numbers"});
    v.values.resize((n + 1) * v.components);
  }

  /// Result: the number of elements with values.
  std::uint64_t header(gmsh_values& v) {
    const std::uint64_t texts = text_count("the number of texts");
    for (std::uint64_t i = 0; i < texts; ++i) {
      skip();
      if (at_end() || *at == '$') reject(at, {"a text"});
      std::string text = quoted_text();
      if (i == 0) v.name = std::move(text);
    }
    const std::uint64_t reals = text_count("the number of real tags");
    for (std::uint64_t i = 0; i < reals; ++i) {
      skip();
      double x = 0;
      const char* const p = parse_real(at, end(), x);
      if (!p || !ends_token(p, 0)) reject(at, {"a real tag"});
      at = p;
    }
    skip();
    const char* const from = at;
    const std::uint64_t integers = text_count("the number of integer tags, at least 3");
    if (integers < 3) reject(from, {"the number of integer tags, at least 3"});
    v.step = text_number("the step of time");
    skip();
    const char* const components = at;
    v.components = text_count("the number of components");
    if (v.components == 0 || v.components > left()) reject(components, {"the number of components"});
    skip();
    const char* const count = at;
    const std::uint64_t rows = text_count("the number of values");
    for (std::uint64_t i = 3; i < integers; ++i) text_number("an integer tag");
    begin_numbers();
    check_count(count, rows, 1 + v.components, 4 + 8 * v.components);
    return rows;
  }

  gmsh_values& values_like(const gmsh_values& v) {
    if (property_type_of(vtk_number::float64, v.components, ""))
      for (gmsh_values& x : grid_.values)
        if (x.of_nodes == v.of_nodes && x.name == v.name && x.step == v.step && x.components == v.components) return x;
    grid_.values.push_back(v);
    return grid_.values.back();
  }

  /// Tags have 32 bits here, in version 4.1 too.
  std::uint64_t take_row_tag() {
    if (!binary_) return take_size("the tag of a node or an element");
    const int tag = take_int("the tag of a node or an element");
    return tag < 0 ? ~std::uint64_t{0} : static_cast<std::uint64_t>(tag);
  }

  int dimension_of(std::size_t e) const {
    const auto after = std::upper_bound(grid_.runs.begin(), grid_.runs.end(), e,
                                        [](std::size_t i, const gmsh_run& r) { return i < r.first; });
    return (after - 1)->type.dimension();
  }
};

}  // namespace concino::detail
