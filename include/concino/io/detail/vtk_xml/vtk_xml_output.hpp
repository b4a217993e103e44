// Writes the arrays of .vtu and .vtp files: as text between their tags, or as bytes appended to the tags.
#pragma once

#include <concino/io/detail/vtk/vtk_output.hpp>
#include <concino/io/detail/vtk_xml/xml_scanner.hpp>

#include <bit>
#include <cstring>

namespace concino::detail {

/// Passes the numbers of an array to a writer, in order.
using vtk_number_source = function_ref<void(function_ref<void(const void*)>)>;

/// Writes a file in two passes over its arrays, if it is binary: the tags with the position of each array, then their
/// bytes.
template<class Context>  // write_context, as in vtk_output.hpp
class vtk_xml_output {
  Context& c_;
  bool binary_, wide_, data_pass_ = false;
  std::uint64_t offset_ = 0;

 public:
  /// `largest`: no array has more bytes.
  vtk_xml_output(Context& c, std::uint64_t largest) : c_(c), binary_(c.options.binary), wide_(largest > 0xFFFFFFFFu) {}

  void begin(const char* type) {
    c_.out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\"1.0\" byte_order=\""
           << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian") << "\" header_type=\""
           << (wide_ ? "UInt64" : "UInt32") << "\">\n";
  }
  /// Writes a tag. In the second pass there are none.
  template<class... T>
  void tag(const T&... parts) {
    if (!data_pass_) (c_.out << ... << parts) << '\n';
  }
  /// Calls write() for the tags and, if the file is binary, again for the bytes.
  void arrays(function_ref<void()> write) {
    write();
    if (!binary_) return;
    c_.out << "<AppendedData encoding=\"raw\">\n_";
    data_pass_ = true;
    write();
    data_pass_ = false;
    c_.out << "\n</AppendedData>\n";
  }

  /// Writes an array of n values of several numbers. values(use) calls use(value) for each.
  void array(std::string_view array_name, vtk_property_type type, std::uint64_t n, std::string_view more,
             vtk_number_source values) {
    const std::size_t size = vtk_names_of(type.number).size, bytes = type.components * size;
    if (!data_pass_) {
      c_.out << "<DataArray type=\"" << vtk_names_of(type.number).xml << "\" Name=\"" << xml_text(array_name) << '"';
      if (type.components > 1) c_.out << " NumberOfComponents=\"" << type.components << '"';
      c_.out << more << " format=\"" << (binary_ ? "appended" : "ascii") << '"';
      if (binary_) {
        c_.out << " offset=\"" << offset_ << "\"/>\n";
        offset_ += n * bytes + (wide_ ? 8 : 4);
        return;
      }
      c_.out << ">\n";
      values([&](const void* value) {
        for (std::size_t k = 0; k < type.components; ++k) {
          if (k) c_.out << ' ';
          write_vtk_number(c_.out, type.number, static_cast<const unsigned char*>(value) + k * size);
        }
        c_.out << '\n';
      });
      c_.out << "</DataArray>\n";
      return;
    }
    raw(wide_ ? n * bytes : static_cast<std::uint32_t>(n * bytes));
    values([&](const void* value) { c_.out << std::string_view(static_cast<const char*>(value), bytes); });
  }

 private:
  void raw(std::uint64_t header) {
    const auto low = static_cast<std::uint32_t>(header);
    c_.out << (wide_ ? std::string_view(reinterpret_cast<const char*>(&header), 8)
                     : std::string_view(reinterpret_cast<const char*>(&low), 4));
  }
};

/// Writes the properties of an array list as arrays of n values.
template<class Context, class Value>
void write_vtk_xml_arrays(vtk_xml_output<Context>& out, const std::vector<vtk_output_array>& all, std::size_t n,
                          std::string_view more, const Value& value) {
  for (const vtk_output_array& a : all) {
    const auto values = [&](function_ref<void(const void*)> use) {
      for (std::size_t i = 0; i < n; ++i) use(value(a, i));
    };
    out.array(a.name, a.type, n, more, values);
  }
}

/// The property of verts and polys whose values are numbers that they have in all pieces of a mesh.
inline constexpr std::string_view global_id = "global_id";

/// The attribute of a tag that says which of these arrays holds such numbers; empty if none does.
inline const char* global_ids_attribute(const std::vector<vtk_output_array>& all) {
  for (const vtk_output_array& a : all)
    if (a.name == global_id && a.type.number < vtk_number::float32 && a.type.components == 1)
      return " GlobalIds=\"global_id\"";
  return "";
}

/// The attributes of the tag around these arrays of verts that say which of them are normals, textures and numbers.
inline std::string active_vert_arrays(const std::vector<vtk_output_array>& all) {
  std::string active;
  for (const vtk_output_array& a : all) {
    if (a.name == "normal" && a.type.number == vtk_number::float64 && a.type.components == 3)
      active += " Normals=\"normal\"";
    if (a.name == "texture" && a.type.number == vtk_number::float64 && a.type.components == 2)
      active += " TCoords=\"texture\"";
  }
  return active += global_ids_attribute(all);
}

/// Writes <Points>, and <PointData> before it.
template<class Context>
void write_vtk_xml_points(vtk_xml_output<Context>& out, Context& c, const flat_mesh& m,
                          const vtk_output_arrays<Context>& arrays) {
  if (!arrays.of_verts.empty()) {
    out.tag("<PointData", active_vert_arrays(arrays.of_verts), ">");
    write_vtk_xml_arrays(out, arrays.of_verts, m.points.size(), "",
                         [](const vtk_output_array& a, std::size_t i) { return a.value(i); });
    out.tag("</PointData>");
  }
  out.tag("<Points>");
  const auto points = [&](function_ref<void(const void*)> use) {
    for (const vec3& p : m.points) {
      use(&p);
      c.report_progress();
    }
  };
  out.array("Points", {vtk_number::float64, 3}, m.points.size(), "", points);
  out.tag("</Points>");
}

}  // namespace concino::detail
