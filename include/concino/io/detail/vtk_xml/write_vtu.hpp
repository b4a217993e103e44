// The writer of .vtu files, in the layout that every version of VTK reads: as text, or with appended raw bytes.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_output.hpp>
#include <concino/io/detail/vtk_xml/vtu_format.hpp>

namespace concino::detail {

template<class Context>  // write_context, as in vtk_output.hpp
class vtu_writer {
  Context& c_;
  flat_mesh& m_;
  vtk_output_arrays<Context> arrays_;
  vtk_cell_list<Context> cells_;
  std::uint64_t num_verts_ = 0, num_face_numbers_ = 0;  // of the lists of verts, and of faces of polyhedra
  std::vector<vert_id> scratch_;

  /// The verts of a cell, each once.
  std::span<const vert_id> verts_of(std::size_t i) {
    const std::span<const vert_id> all = cells_.verts(i);
    if (cells_.type(i) != vtk_polyhedron) return all;
    scratch_.clear();
    for (std::size_t at = 1; at < all.size(); at += 1 + all[at].raw())
      scratch_.insert(scratch_.end(), all.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                      all.begin() + static_cast<std::ptrdiff_t>(at + 1 + all[at].raw()));
    std::sort(scratch_.begin(), scratch_.end());
    scratch_.erase(std::unique(scratch_.begin(), scratch_.end()), scratch_.end());
    return scratch_;
  }

  /// Writes an array of integers, of 64 bits.
  template<class Visit>
  void integers(vtk_xml_output<Context>& out, const char* name, std::uint64_t n, const Visit& visit) {
    const auto values = [&](function_ref<void(const void*)> use) {
      visit([&](std::int64_t x) { use(&x); });
    };
    out.array(name, {vtk_number::int64, 1}, n, "", values);
  }

  void cells(vtk_xml_output<Context>& out) {
    out.tag("<Cells>");
    integers(out, "connectivity", num_verts_, [&](const auto& use) {
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        for (const vert_id v : verts_of(i)) use(v.raw());
        c_.report_progress();
      }
    });
    integers(out, "offsets", cells_.size(), [&](const auto& use) {
      std::int64_t end = 0;
      for (std::size_t i = 0; i < cells_.size(); ++i) use(end += static_cast<std::int64_t>(verts_of(i).size()));
    });
    const auto types = [&](function_ref<void(const void*)> use) {
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto type = static_cast<std::uint8_t>(cells_.type(i));
        use(&type);
      }
    };
    out.array("types", {vtk_number::uint8, 1}, cells_.size(), "", types);
    if (num_face_numbers_) faces(out);
    out.tag("</Cells>");
  }
  void faces(vtk_xml_output<Context>& out) {
    integers(out, "faces", num_face_numbers_, [&](const auto& use) {
      for (std::size_t i = 0; i < cells_.size(); ++i)
        if (cells_.type(i) == vtk_polyhedron)
          for (const vert_id v : cells_.verts(i)) use(v.raw());
    });
    integers(out, "faceoffsets", cells_.size(), [&](const auto& use) {
      std::int64_t end = 0;
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        const bool has_faces = cells_.type(i) == vtk_polyhedron;
        if (has_faces) end += static_cast<std::int64_t>(cells_.verts(i).size());
        use(has_faces ? end : -1);
      }
    });
  }

 public:
  /// is_piece: all properties are written, so that every piece of a mesh has the same arrays.
  vtu_writer(Context& c, flat_mesh& m, bool is_piece = false)
      : c_(c), m_(m), arrays_(c, m, false, is_piece), cells_(c, m) {
    if (arrays_.any_of_faces()) cells_.add_faces(c, [&](std::size_t f) { return arrays_.face_has_value(f); });
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      num_verts_ += verts_of(i).size();
      if (cells_.type(i) == vtk_polyhedron) num_face_numbers_ += cells_.verts(i).size();
    }
  }

  const vtk_output_arrays<Context>& arrays() const { return arrays_; }

  void write() {
    vtk_xml_output<Context> out(c_, std::max<std::uint64_t>({8 * num_verts_, 8 * num_face_numbers_, 72 * cells_.size(),
                                                             72 * m_.points.size()}));
    out.begin("UnstructuredGrid");
    const auto of_elements = [](const vtk_output_array& a, std::size_t i) { return a.value(i); };
    const auto all = [&] {
      out.tag("<UnstructuredGrid>");
      if (!arrays_.of_mesh.empty()) {
        out.tag("<FieldData>");
        write_vtk_xml_arrays(out, arrays_.of_mesh, 1, " NumberOfTuples=\"1\"", of_elements);
        out.tag("</FieldData>");
      }
      out.tag("<Piece NumberOfPoints=\"", m_.points.size(), "\" NumberOfCells=\"", cells_.size(), "\">");
      write_vtk_xml_points(out, c_, m_, arrays_);
      cells(out);
      if (!arrays_.of_cells.empty()) {
        out.tag("<CellData", global_ids_attribute(arrays_.of_cells), ">");
        write_vtk_xml_arrays(out, arrays_.of_cells, cells_.size(), "", [&](const vtk_output_array& a, std::size_t i) {
          return i < m_.num_polys ? a.value(i) : a.face_value(cells_.faces[i - m_.num_polys]);
        });
        out.tag("</CellData>");
      }
      out.tag("</Piece>");
      out.tag("</UnstructuredGrid>");
    };
    out.arrays(all);
    out.tag("</VTKFile>");
  }
};

}  // namespace concino::detail

namespace concino {

template<std::same_as<write_context> Context>
void vtu_format::write(Context& c, flat_mesh& m) { detail::vtu_writer<Context>(c, m).write(); }

}  // namespace concino
