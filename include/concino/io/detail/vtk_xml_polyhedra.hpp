// Reads the polyhedra of .vtu files, in the layout before version 2.3 of the format, and in that of shared faces since then.
#pragma once

#include <concino/io/detail/vtk_xml_reader.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Reads volumes too. A template only so that programs without volumes need not compile it.
template<class Contents>
class vtk_xml_volume_reader : public vtk_xml_reader {
  static constexpr std::int64_t max_index = 0xFFFFFFFE;

 public:
  vtk_xml_volume_reader(const read_context& in, vtk_grid& grid) : vtk_xml_reader(in, grid) { reads_polyhedra_ = true; }

 private:
  /// Replaces the verts of polyhedra by their faces.
  [[gnu::noinline, gnu::cold]] void polyhedra(std::size_t p, std::size_t first) override {
    has_faces_ = true;
    std::uint32_t* const ends = grid_.cell_ends.data() + first_cell_[p];
    const std::size_t num_cells = grid_.size() - first_cell_[p];
    std::vector<vert_id> verts;
    if (first == 0) verts.swap(grid_.verts);
    else verts.assign(grid_.verts.begin() + static_cast<std::ptrdiff_t>(first), grid_.verts.end());
    const auto part = vtk_xml_part::cells;
    const bool is_new = !find(p, part, "faces");
    const vtk_xml_array& faces = need(p, part, is_new && find(p, part, "polyhedron_to_faces") ? "polyhedron_to_faces" : "faces");
    // The list of faces is read behind the room for the verts of other cells, and changed in place: what is written never reaches what is not read yet.
    const std::size_t list_begin = first + (is_new ? 0 : num_verts_of_others(first_cell_[p], first));
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
    if (cell_ends.size() < num_cells) fail_array(faces, {"an end for each of ", num_cells, " cells"}, {cell_ends.size()});
    if (is_new) check_shared_faces(cell_faces, face_ends, face_verts.size());
    const std::size_t size = is_new ? cell_faces.size() : grid_.verts.size() - list_begin;
    std::size_t written = first, at_list = 0, from = 0;
    for (std::size_t c = 0; c < num_cells; ++c) {
      const std::size_t verts_end = ends[c] - first;
      if (grid_.types[first_cell_[p] + c] != vtk_polyhedron) {
        if (is_new) grid_.verts.resize(written + (verts_end - from));
        std::copy(verts.data() + from, verts.data() + verts_end, grid_.verts.data() + written);
        written += verts_end - from;
      } else {
        const auto end = static_cast<std::size_t>(cell_ends[c]);
        if (cell_ends[c] < 0 || end < at_list || end > size) fail_array(faces, {"ends of polyhedra that increase to ", size}, {cell_ends[c]});
        if (is_new) {
          listed_faces(faces, p, cell_faces, face_ends, face_verts, static_cast<std::int64_t>(at_list), cell_ends[c]);
          written = grid_.verts.size();
        } else {
          vert_id* const all = grid_.verts.data();
          written = static_cast<std::size_t>(face_stream(faces, p, list, all + list_begin, at_list, end, all + written) - all);
        }
        at_list = end;
      }
      if (written > max_ids) fail_to_count("corners of faces");
      ends[c] = static_cast<std::uint32_t>(written);
      from = verts_end;
    }
    grid_.verts.resize(written);
  }
  /// The number of verts of the cells of a piece that are no polyhedra.
  std::size_t num_verts_of_others(std::size_t first_cell, std::size_t first_vert) const {
    std::size_t n = 0, from = first_vert;
    for (std::size_t c = first_cell; c < grid_.size(); from = grid_.cell_ends[c++])
      if (grid_.types[c] != vtk_polyhedron) n += grid_.cell_ends[c] - from;
    return n;
  }
  /// Errors: unsupported if the faces of all polyhedra have far more corners than the file lists.
  void check_shared_faces(const std::vector<std::int64_t>& cell_faces, const std::vector<std::int64_t>& face_ends, std::size_t num_verts) const {
    std::uint64_t corners = 0;
    for (const std::int64_t f : cell_faces) {
      if (f < 0 || static_cast<std::size_t>(f) >= face_ends.size()) continue;
      const std::int64_t n = face_ends[static_cast<std::size_t>(f)] - (f ? face_ends[static_cast<std::size_t>(f) - 1] : 0);
      if (n > 0) corners += std::min<std::uint64_t>(static_cast<std::uint64_t>(n), num_verts);
    }
    check_poly_corners(corners, num_verts, cell_faces.size(), core::joined({in_.name, ": "}));
  }
  /// The number of integers in an array of any length.
  std::uint64_t length_of(const vtk_xml_array& a) {
    if (a.format != "ascii") return count_numbers(a);
    std::uint64_t n = 0;
    bool in_word = false;
    for (const char* c = a.begin; c != a.end; ++c) {
      n += !is_space(*c) && !in_word;
      in_word = !is_space(*c);
    }
    return n;
  }
  std::vector<std::int64_t> integers(const vtk_xml_array& a) {
    std::vector<std::int64_t> all;
    const std::uint64_t n = length_of(a);
    require_numbers(a, n);
    core::reserve_large(all, n);
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) { all.insert(all.end(), values, values + count); });
    return all;
  }
  /// The first of the integers of a list that are too large or negative, for errors. They become "no id".
  struct id_list {
    std::size_t first_bad = ~std::size_t{0};
    std::int64_t bad = 0;

    std::int64_t number(std::size_t k, vert_id id) const { return k == first_bad ? bad : std::int64_t{id.raw()}; }
  };
  /// Appends integers to the verts of the grid, as ids.
  id_list append_ids(const vtk_xml_array& a) {
    const std::uint64_t n = length_of(a);
    require_numbers(a, n);
    id_list list;
    std::vector<vert_id>& ids = grid_.verts;
    const std::size_t before = ids.size();
    core::reserve_large(ids, before + n);
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) {
      std::uint64_t all = 0;
      const std::size_t at_ids = ids.size();
      ids.resize(at_ids + count);
      vert_id* const some = ids.data() + at_ids;
      for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<std::uint64_t>(values[i]);
        all |= x;
        some[i] = vert_id{static_cast<std::uint32_t>(x)};
      }
      for (std::size_t i = 0; all > max_index && i < count; ++i) {
        if (values[i] >= 0 && values[i] <= max_index) continue;
        some[i] = vert_id{};
        if (list.first_bad == ~std::size_t{0}) list.first_bad = at_ids - before + i, list.bad = values[i];
      }
    });
    return list;
  }
  /// Copies the number of faces of a polyhedron, and for each the number of its verts and these, from begin to end of a list.
  /// Result: the end of the copy.
  vert_id* face_stream(const vtk_xml_array& a, std::size_t p, const id_list& list, const vert_id* source, std::size_t begin, std::size_t end, vert_id* to) {
    const std::uint64_t bound = index_.pieces[p].points, first = first_point_[p];
    const auto fail_at = [&](const char* what, std::size_t k) {
      if (k == end) fail_array(a, {what}, {"the end of the polyhedron"});
      fail_array(a, {what}, {list.number(k, source[k])});
    };
    std::size_t k = begin;
    if (k == end || source[k].raw() >= end - k) fail_at("the number of faces of a polyhedron", k);
    const std::uint32_t faces = source[k].raw();
    *to++ = source[k++];
    for (std::uint32_t f = 0; f < faces; ++f) {
      if (k == end || source[k].raw() >= end - k) fail_at("the number of verts of a face", k);
      const std::size_t last = k + 1 + source[k].raw();
      for (*to++ = source[k++]; k < last; ++k) {
        if (source[k].raw() >= bound) fail_array(a, {"point indices below ", bound}, {list.number(k, source[k])});
        *to++ = vert_id{static_cast<std::uint32_t>(first + source[k].raw())};
      }
    }
    return to;
  }
  /// The same from lists of faces and of their verts.
  void listed_faces(const vtk_xml_array& a, std::size_t p, const std::vector<std::int64_t>& cell_faces, const std::vector<std::int64_t>& face_ends,
                    const std::vector<std::int64_t>& face_verts, std::int64_t begin, std::int64_t end) {
    grid_.verts.push_back(vert_id{end - begin});
    for (; begin < end; ++begin) {
      const std::int64_t f = cell_faces[static_cast<std::size_t>(begin)];
      if (f < 0 || static_cast<std::size_t>(f) >= face_ends.size()) fail_array(a, {"face indices below ", face_ends.size()}, {f});
      const std::int64_t from = f ? face_ends[static_cast<std::size_t>(f) - 1] : 0, to = face_ends[static_cast<std::size_t>(f)];
      if (from < 0 || to < from || static_cast<std::size_t>(to) > face_verts.size()) fail_array(a, {"ends of faces that increase to ", face_verts.size()}, {to});
      if (grid_.verts.size() + static_cast<std::size_t>(to - from) > max_ids) fail_to_count("corners of faces");
      grid_.verts.push_back(vert_id{to - from});
      for (std::int64_t i = from; i < to; ++i) push_vert(a, p, face_verts[static_cast<std::size_t>(i)]);
    }
  }
};

}  // namespace concino::detail
