// Reads the polyhedra of .vtu files, in the layout before version 2.3 of the format, and in that of shared faces since
// then.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_face_lists.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace concino::detail {

/// Reads volumes too. A template only so that programs without volumes need not compile it.
template<class Contents>
class vtk_xml_volume_reader : public vtk_xml_face_lists<vert_id> {
 public:
  vtk_xml_volume_reader(const read_context& in, vtk_grid& grid) : vtk_xml_face_lists(in, grid) {
    reads_polyhedra_ = true;
  }

 private:
  /// Puts the faces of polyhedra between the verts of other cells.
  void polyhedra(std::size_t p, std::size_t first) override {
    has_faces_ = true;
    std::uint32_t* const ends = grid_.cell_ends.data() + first_cell_[p];
    const std::size_t num_cells = grid_.size() - first_cell_[p];
    std::vector<vert_id> others(grid_.verts.begin() + static_cast<std::ptrdiff_t>(first), grid_.verts.end());
    const auto part = vtk_xml_part::cells;
    const bool is_new = !find(p, part, "faces");
    const vtk_xml_array& faces =
        need(p, part, is_new && find(p, part, "polyhedron_to_faces") ? "polyhedron_to_faces" : "faces");
    // The list of faces is read behind the room for the verts of other cells, and changed in place: what is written
    // never reaches what is not read yet.
    const std::size_t list_begin = first + (is_new ? 0 : others.size());
    id_list list;
    grid_.verts.resize(list_begin);
    if (!is_new) list = append_ids(faces);
    const std::vector<std::int64_t> cell_ends = integers(need(p, part, is_new ? "polyhedron_offsets" : "faceoffsets"));
    std::vector<std::int64_t> cell_faces, face_ends, face_verts;
    if (is_new) {
      cell_faces = integers(faces);
      face_ends = integers(need(p, part, "face_offsets"));
      face_verts = integers(need(p, part, "face_connectivity"));
    }
    if (cell_ends.size() < num_cells)
      fail_array(faces, {"an end for each of ", num_cells, " cells"}, {cell_ends.size()});
    if (is_new) check_shared_faces(cell_faces, face_ends, face_verts.size());
    const std::size_t size = is_new ? cell_faces.size() : grid_.verts.size() - list_begin;
    std::size_t written = first, at_list = 0, other = 0, from = first;
    for (std::size_t c = 0; c < num_cells; ++c) {
      const std::size_t num_verts = ends[c] - from;
      from = ends[c];
      if (grid_.types[first_cell_[p] + c] != vtk_polyhedron) {
        if (is_new) grid_.verts.resize(written + num_verts);
        std::copy_n(others.data() + other, num_verts, grid_.verts.data() + written);
        other += num_verts;
        written += num_verts;
      } else {
        const auto end = static_cast<std::size_t>(cell_ends[c]);
        if (cell_ends[c] < 0 || end < at_list || end > size)
          fail_array(faces, {"ends of polyhedra that increase to ", size}, {cell_ends[c]});
        if (is_new) {
          listed_faces(faces, p, cell_faces, face_ends, face_verts, static_cast<std::int64_t>(at_list), cell_ends[c]);
          written = grid_.verts.size();
        } else {
          const vert_id* const source = grid_.verts.data() + list_begin + at_list;
          const std::size_t n = length_of_faces(faces, p, list, source, at_list, end);
          std::memmove(grid_.verts.data() + written, source, n * sizeof *source);
          add_to_listed_verts(grid_.verts.data() + written, static_cast<std::uint32_t>(first_point_[p]));
          written += n;
        }
        at_list = end;
      }
      if (written > max_ids) fail_to_count("corners of faces");
      ends[c] = static_cast<std::uint32_t>(written);
    }
    grid_.verts.resize(written);
  }
  /// The same from lists of faces and of their verts.
  void listed_faces(const vtk_xml_array& a, std::size_t p, const std::vector<std::int64_t>& cell_faces,
                    const std::vector<std::int64_t>& face_ends, const std::vector<std::int64_t>& face_verts,
                    std::int64_t begin, std::int64_t end) {
    grid_.verts.push_back(vert_id{end - begin});
    for (; begin < end; ++begin) {
      const std::int64_t f = cell_faces[static_cast<std::size_t>(begin)];
      if (f < 0 || static_cast<std::size_t>(f) >= face_ends.size())
        fail_array(a, {"face indices below ", face_ends.size()}, {f});
      const std::int64_t from = f ? face_ends[static_cast<std::size_t>(f) - 1] : 0,
                         to = face_ends[static_cast<std::size_t>(f)];
      if (from < 0 || to < from || static_cast<std::size_t>(to) > face_verts.size())
        fail_array(a, {"ends of faces that increase to ", face_verts.size()}, {to});
      if (grid_.verts.size() + static_cast<std::size_t>(to - from) > max_ids) fail_to_count("corners of faces");
      grid_.verts.push_back(vert_id{to - from});
      for (std::int64_t i = from; i < to; ++i) push_vert(a, p, face_verts[static_cast<std::size_t>(i)]);
    }
  }
};

}  // namespace concino::detail
