// The writer of legacy VTK files, version 3.0: an UNSTRUCTURED_GRID, as text or big-endian.
#pragma once

#include <concino/io/detail/text/encoded_name.hpp>
#include <concino/io/detail/vtk/vtk_format.hpp>
#include <concino/io/detail/vtk/vtk_output.hpp>

#include <bit>

namespace concino::detail {

template<class Context>  // write_context, as in vtk_output.hpp
class vtk_writer {
  Context& c_;
  flat_mesh& m_;
  bool binary_;
  vtk_output_arrays<Context> arrays_;
  vtk_cell_list<Context> cells_;

  void integer(std::uint32_t i) {
    if (!binary_) {
      c_.out << i;
      return;
    }
    for (int shift = 24; shift >= 0; shift -= 8) c_.out << static_cast<char>((i >> shift) & 255);
  }
  void blank() {
    if (!binary_) c_.out << ' ';
  }
  void end_line() {
    if (!binary_) c_.out << '\n';
  }
  void numbers(vtk_property_type type, const unsigned char* bytes) {
    const std::size_t size = vtk_names_of(type.number).size;
    if (binary_) {
      unsigned char swapped[72];
      std::memcpy(swapped, bytes, type.components * size);
      if constexpr (std::endian::native == std::endian::little) swap_bytes(swapped, type.components, size);
      c_.out << std::string_view(reinterpret_cast<const char*>(swapped), type.components * size);
      return;
    }
    for (std::size_t k = 0; k < type.components; ++k) {
      if (k) c_.out << ' ';
      write_vtk_number(c_.out, type.number, bytes + k * size);
    }
    c_.out << '\n';
  }

  /// A name without blanks: other characters than letters, digits and the like are written as %XX.
  static std::string encoded(std::string_view name) {
    std::string r;
    for (const char c : name) {
      const bool is_first_of_keyword = r.empty() && name == "METADATA";
      if (is_plain_in_name(c) && !is_first_of_keyword) r += c;
      else append_encoded(r, c);
    }
    return r;
  }

  template<class Value>
  void field(const std::vector<vtk_output_array>& all, std::size_t n, const Value& value) {
    c_.out << "FIELD FieldData " << all.size() << '\n';
    for (const vtk_output_array& a : all) {
      c_.out << encoded(a.name) << ' ' << a.type.components << ' ' << n << ' ' << vtk_names_of(a.type.number).legacy
             << '\n';
      if (binary_ && a.type.number == vtk_number::bit) bits(a, n, value);
      else
        for (std::size_t i = 0; i < n; ++i) numbers(a.type, value(a, i));
      if (binary_) c_.out << '\n';
    }
  }
  /// Eight to a byte, the first one highest.
  template<class Value>
  void bits(const vtk_output_array& a, std::size_t n, const Value& value) {
    for (std::size_t i = 0; i < n; i += 8) {
      unsigned byte = 0;
      for (std::size_t k = i; k < i + 8; ++k) byte = byte << 1 | (k < n && *value(a, k) != 0 ? 1u : 0u);
      c_.out << static_cast<char>(byte);
    }
  }

  void cells() {
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) numbers += cells_.verts(i).size() + 1;
    if (numbers > 0x7FFFFFFFu || m_.points.size() > 0x7FFFFFFFu)
      c_.throw_cannot_hold(".vtk", {"so many cells"}, ".vtu");
    c_.out << "CELLS " << cells_.size() << ' ' << numbers << '\n';
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::span<const vert_id> verts = cells_.verts(i);
      integer(static_cast<std::uint32_t>(verts.size()));
      for (const vert_id v : verts) {
        blank();
        integer(v.raw());
      }
      end_line();
      c_.report_progress();
    }
    if (binary_) c_.out << '\n';
    c_.out << "CELL_TYPES " << cells_.size() << '\n';
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      integer(cells_.type(i));
      end_line();
    }
    if (binary_) c_.out << '\n';
  }

 public:
  vtk_writer(Context& c, flat_mesh& m) : c_(c), m_(m), binary_(c.options.binary), arrays_(c, m, true), cells_(c, m) {
    if (arrays_.any_of_faces()) cells_.add_faces(c, [&](std::size_t f) { return arrays_.face_has_value(f); });
  }

  void write() {
    c_.out << "# vtk DataFile Version 3.0\nconcino\n"
           << (binary_ ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\n";
    const auto of_elements = [](const vtk_output_array& a, std::size_t i) { return a.value(i); };
    if (!arrays_.of_mesh.empty()) field(arrays_.of_mesh, 1, of_elements);
    c_.out << "POINTS " << m_.points.size() << " double\n";
    for (const vec3& p : m_.points) {
      numbers({vtk_number::float64, 3}, reinterpret_cast<const unsigned char*>(&p));
      c_.report_progress();
    }
    if (binary_) c_.out << '\n';
    cells();
    if (!arrays_.of_verts.empty()) {
      c_.out << "POINT_DATA " << m_.points.size() << '\n';
      field(arrays_.of_verts, m_.points.size(), of_elements);
    }
    if (!arrays_.of_cells.empty()) {
      c_.out << "CELL_DATA " << cells_.size() << '\n';
      field(arrays_.of_cells, cells_.size(), [&](const vtk_output_array& a, std::size_t i) {
        return i < m_.num_polys ? a.value(i) : a.face_value(cells_.faces[i - m_.num_polys]);
      });
    }
  }
};

}  // namespace concino::detail

namespace concino {

template<std::same_as<write_context> Context>
void vtk_format::write(Context& c, flat_mesh& m) { detail::vtk_writer<Context>(c, m).write(); }

}  // namespace concino
