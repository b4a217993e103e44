// Reads the lists of the faces of polyhedra in .vtu files.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_id_list.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_reader.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Reads arrays of integers of any length, and checks that the lists of faces in them have the right lengths.
template<class Vert>  // vert_id, as in face_merger
class vtk_xml_face_lists : public vtk_xml_reader {
 protected:
  using id_list = vtk_id_list<Vert>;

  vtk_xml_face_lists(const read_context& in, vtk_grid& grid) : vtk_xml_reader(in, grid) {}
  ~vtk_xml_face_lists() = default;

  /// Errors: unsupported if the faces of all polyhedra have far more corners than the file lists.
  void check_shared_faces(const std::vector<std::int64_t>& cell_faces, const std::vector<std::int64_t>& face_ends,
                          std::size_t num_verts) const {
    std::uint64_t corners = 0;
    for (const std::int64_t f : cell_faces) {
      if (f < 0 || static_cast<std::size_t>(f) >= face_ends.size()) continue;
      const std::int64_t n =
          face_ends[static_cast<std::size_t>(f)] - (f ? face_ends[static_cast<std::size_t>(f) - 1] : 0);
      if (n > 0) corners += std::min<std::uint64_t>(static_cast<std::uint64_t>(n), num_verts);
    }
    check_poly_corners(corners, num_verts, cell_faces.size(), core::joined({in_.name, ": "}));
  }
  std::vector<std::int64_t> integers(const vtk_xml_array& a) {
    std::vector<std::int64_t> all;
    const std::uint64_t n = count_numbers(a);
    require_numbers(a, n);
    all.reserve(n);
    for_each_integers(
        a, n, [&](const std::int64_t* values, std::size_t count) { all.insert(all.end(), values, values + count); });
    return all;
  }
  /// Appends the integers of an array to the verts of the grid.
  id_list append_ids(const vtk_xml_array& a) {
    const std::uint64_t n = count_numbers(a);
    require_numbers(a, n);
    id_list list;
    grid_.verts.reserve(grid_.verts.size() + n);
    for_each_integers(a, n,
                      [&](const std::int64_t* values, std::size_t count) { list.append(values, count, grid_.verts); });
    return list;
  }
  /// The length of the list of a polyhedron, as far as it is used: the number of its faces, and for each the number of
  /// its verts and these. The list begins at `begin` in its array, and ends at most at `end`.
  std::size_t length_of_faces(const vtk_xml_array& a, std::size_t p, const id_list& list, const Vert* source,
                              std::size_t begin, std::size_t end) {
    const std::uint64_t bound = index_.pieces[p].points;
    const std::size_t n = end - begin;
    const auto fail_at = [&](const char* what, std::size_t k) {
      if (k == n) fail_array(a, {what}, {"the end of the polyhedron"});
      fail_array(a, {what}, {list.number(begin + k, source[k])});
    };
    std::size_t k = 0;
    if (k == n || source[k].raw() >= n - k) fail_at("the number of faces of a polyhedron", k);
    const bool are_verts = list.largest < bound;  // nearly always
    for (std::uint32_t left = source[k++].raw(); left > 0; --left) {
      if (k == n || source[k].raw() >= n - k) fail_at("the number of verts of a face", k);
      const std::size_t last = k + 1 + source[k].raw();
      for (std::size_t i = k + 1; !are_verts && i < last; ++i)
        if (source[i].raw() >= bound)
          fail_array(a, {"point indices below ", bound}, {list.number(begin + i, source[i])});
      k = last;
    }
    return k;
  }
};

}  // namespace concino::detail
