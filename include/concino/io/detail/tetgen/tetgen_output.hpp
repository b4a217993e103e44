// Writes the list of points of a .node, .smesh or .poly file, and finds the attributes that a mesh has.
#pragma once

#include <concino/io/detail/text/write_common.hpp>

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The properties "attribute_1", "attribute_2", ... (double) of verts or polys, and "label", which the file stores.
struct tetgen_values {
  flat_values<int> label;
  std::vector<flat_values<double>> attributes;

  tetgen_values(write_context& c, const flat_mesh& m, element_kind kind) {
    const bool of_verts = kind == element_kind::vert;
    if ((of_verts ? m.points.size() : m.num_polys) == 0) return;  // a reader finds no values
    label = of_verts ? m.vert_values<int>("label") : m.poly_values<int>("label");
    if (label) c.declare_stored<int>(kind, "label");
    for (;;) {
      const std::string name = core::joined({"attribute_", attributes.size() + 1});
      const auto values = of_verts ? m.vert_values<double>(name) : m.poly_values<double>(name);
      if (!values) break;
      c.declare_stored<double>(kind, name);
      attributes.push_back(values);
    }
  }
};

/// Writes all points, numbered from 0. Nothing but the counts if there is no point.
inline void write_tetgen_points(text_sink& out, write_context& c, const flat_mesh& m) {
  const tetgen_values values(c, m, element_kind::vert);
  out << m.points.size() << " 3 " << values.attributes.size() << (values.label ? " 1\n" : " 0\n");
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    out << v << ' ';
    write_point(out, m.points[v]);
    for (const flat_values<double>& a : values.attributes) out << ' ' << c.finite(a[v]);
    if (values.label) out << ' ' << values.label[v];
    out << '\n';
    c.report_progress();
  }
}

/// Writes a number with a point or an exponent, so that readers do not take it for the integer of a region.
inline void write_real(text_sink& out, double x) {
  char digits[32];
  const std::string_view text(digits, static_cast<std::size_t>(std::to_chars(digits, digits + 32, x).ptr - digits));
  out << text;
  if (text.find_first_of(".e") == text.npos) out << ".0";
}

}  // namespace concino::detail
