// Reads the points and cells of the pieces of .vtu and .vtp files into a grid.
#pragma once

#include <concino/io/detail/corners.hpp>
#include <concino/io/detail/vtk_grid.hpp>
#include <concino/io/detail/vtk_xml_tags.hpp>
#include <concino/mesh/limits.hpp>

#include <algorithm>

namespace concino::detail {

class vtk_xml_cells : public vtk_xml_data {
  static constexpr std::int64_t max_index = 0xFFFFFFFE;

 protected:
  vtk_grid& grid_;
  vtk_xml_index index_;
  std::vector<std::size_t> first_point_, first_cell_;  // of each piece, and the end

  vtk_xml_cells(const read_context& in, vtk_grid& grid) : vtk_xml_data(in), grid_(grid) {}

  /// Null if there is none.
  const vtk_xml_array* find(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    auto e = std::partition_point(index_.entries.begin(), index_.entries.end(), [&](const vtk_xml_entry& x) { return x.piece < piece; });
    for (; e != index_.entries.end() && e->piece == piece; ++e)
      if (e->part == part && (name.empty() || e->array.name == name)) return &e->array;
    return nullptr;
  }
  const vtk_xml_array& need(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    const vtk_xml_array* const a = find(piece, part, name);
    if (!a) fail(index_.pieces[piece].at, {"the array \"", name.empty() ? "Points" : name, "\""}, {"a piece without it"});
    return *a;
  }

  [[gnu::noinline]] void points(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].points;
    if (n == 0) return;
    const vtk_xml_array& a = need(p, vtk_xml_part::points, "");
    if (a.components != 3) fail_array(a, {"three components"}, {a.components});
    if (n > max_ids || grid_.points.size() + n > max_ids) fail_to_count("points");
    require_numbers(a, 3 * n);
    const std::size_t first = grid_.points.size();
    if (a.type == vtk_number::float64) {
      grid_.points.resize(first + n);
      read_array(a, 3 * n, grid_.points.data() + first);
    } else {
      core::reserve_large(grid_.points, first + n);
      double x[3];
      unsigned k = 0;
      for_each_part<double>(a, 3 * n, [&](const double* values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          x[k++] = values[i];
          if (k == 3) grid_.points.push_back({x[0], x[1], x[2]}), k = 0;
        }
      });
    }
    for (std::size_t i = first; i < grid_.points.size(); ++i)
      if (!is_finite(grid_.points[i])) fail_array(a, {"finite coordinates"}, {"others at point ", i - first});
  }

  /// Checks a vert of a piece, and adds its number in the grid.
  void push_vert(const vtk_xml_array& a, std::size_t p, std::int64_t v) {
    if (v < 0 || static_cast<std::uint64_t>(v) >= index_.pieces[p].points) fail_array(a, {"point indices below ", index_.pieces[p].points}, {v});
    grid_.verts.push_back(vert_id{first_point_[p] + static_cast<std::size_t>(v)});
  }

  /// The ends of n lists, which do not decrease.
  std::vector<std::uint32_t> ends_of(const vtk_xml_array& a, std::uint64_t n) {
    require_numbers(a, n);
    std::vector<std::uint32_t> ends;
    core::reserve_large(ends, n);
    std::int64_t last = 0;
    for_each_integer(a, n, [&](std::int64_t e) {
      if (e < last || e > static_cast<std::int64_t>(max_ids)) fail_array(a, {"ends that do not decrease"}, {e, " after ", last});
      ends.push_back(static_cast<std::uint32_t>(last = e));
    });
    return ends;
  }

  /// Adds cells whose verts end at `ends` in the array.
  void lists(const vtk_xml_array& a, std::size_t p, const std::vector<std::uint32_t>& ends) {
    const std::uint64_t total = ends.empty() ? 0 : ends.back();
    if (grid_.verts.size() + total > max_ids) fail_to_count("corners");
    const auto before = static_cast<std::uint32_t>(grid_.verts.size());
    require_numbers(a, total);
    core::reserve_large(grid_.verts, grid_.verts.size() + total);
    const std::uint64_t bound = index_.pieces[p].points, first = first_point_[p];
    for_each_integers(a, total, [&](const std::int64_t* values, std::size_t count) {
      const std::size_t at_verts = grid_.verts.size();
      grid_.verts.resize(at_verts + count);
      vert_id* const to = grid_.verts.data() + at_verts;
      bool fits = true;
      for (std::size_t i = 0; i < count; ++i) {
        fits = fits && static_cast<std::uint64_t>(values[i]) < bound;
        to[i] = vert_id{static_cast<std::uint32_t>(first + static_cast<std::uint64_t>(values[i]))};
      }
      for (std::size_t i = 0; !fits && i < count; ++i) push_vert(a, p, values[i]);  // throws
    });
    core::reserve_large(grid_.cell_ends, grid_.cell_ends.size() + ends.size());
    for (const std::uint32_t e : ends) grid_.cell_ends.push_back(before + e);
  }

  [[gnu::noinline]] void polydata_cells(std::size_t p, unsigned list) {
    const std::uint64_t n = index_.pieces[p].lists[list];
    if (n == 0) return;
    constexpr std::uint8_t types[] = {2, 4, 6, 7};
    const auto part = static_cast<vtk_xml_part>(list);
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const std::vector<std::uint32_t> ends = ends_of(need(p, part, "offsets"), n);
    if (!ends.empty() && ends.back() > 0) {
      lists(need(p, part, "connectivity"), p, ends);
    } else {
      grid_.cell_ends.insert(grid_.cell_ends.end(), ends.size(), static_cast<std::uint32_t>(grid_.verts.size()));
    }
    grid_.types.insert(grid_.types.end(), n, types[list]);
  }

  [[gnu::noinline]] void grid_cells(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].cells;
    if (n == 0) return;
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const vtk_xml_array& types = need(p, vtk_xml_part::cells, "types");
    const std::vector<std::uint32_t> ends = ends_of(need(p, vtk_xml_part::cells, "offsets"), n);
    require_numbers(types, n);
    core::reserve_large(grid_.types, grid_.types.size() + n);
    bool any_polyhedron = false;
    for_each_integer(types, n, [&](std::int64_t t) {
      if (t < 0 || t > 255) fail_array(types, {"cell types from 0 to 255"}, {t});
      any_polyhedron = any_polyhedron || t == vtk_polyhedron;
      grid_.types.push_back(static_cast<std::uint8_t>(t));
    });
    const std::size_t first = grid_.verts.size();
    if (ends.back() > 0) lists(need(p, vtk_xml_part::cells, "connectivity"), p, ends);
    else grid_.cell_ends.insert(grid_.cell_ends.end(), ends.size(), static_cast<std::uint32_t>(first));
    if (any_polyhedron) polyhedra(p, first, ends);
  }

 private:
  /// Replaces the verts of polyhedra by their faces.
  [[gnu::noinline, gnu::cold]] void polyhedra(std::size_t p, std::size_t first, const std::vector<std::uint32_t>& ends) {
    std::vector<vert_id> verts;
    if (first == 0) verts.swap(grid_.verts);
    else verts.assign(grid_.verts.begin() + static_cast<std::ptrdiff_t>(first), grid_.verts.end());
    grid_.verts.resize(first);
    const auto part = vtk_xml_part::cells;
    const bool is_new = !find(p, part, "faces");
    const vtk_xml_array& faces = need(p, part, is_new && find(p, part, "polyhedron_to_faces") ? "polyhedron_to_faces" : "faces");
    id_list list = is_new ? id_list{} : ids(faces);
    const std::vector<std::int64_t> cell_ends = integers(need(p, part, is_new ? "polyhedron_offsets" : "faceoffsets"));
    std::vector<std::int64_t> cell_faces, face_ends, face_verts;
    if (is_new) {
      cell_faces = integers(faces);
      face_ends = integers(need(p, part, "face_offsets"));
      face_verts = integers(need(p, part, "face_connectivity"));
    }
    if (cell_ends.size() < ends.size()) fail_array(faces, {"an end for each of ", ends.size(), " cells"}, {cell_ends.size()});
    if (is_new) check_shared_faces(cell_faces, face_ends, face_verts.size());
    // The list of polyhedra alone is changed in place.
    const std::size_t size = is_new ? cell_faces.size() : list.ids.size();
    const auto is_polyhedron = [](std::uint8_t t) { return t == vtk_polyhedron; };
    const bool in_place = !is_new && first == 0 && std::all_of(grid_.types.begin() + static_cast<std::ptrdiff_t>(first_cell_[p]), grid_.types.end(), is_polyhedron);
    if (in_place) grid_.verts.swap(list.ids);
    else if (!is_new) core::reserve_large(grid_.verts, first + verts.size() + size);
    const vert_id* const source = in_place ? grid_.verts.data() : list.ids.data();
    std::size_t written = first, at_list = 0;
    for (std::size_t c = 0; c < ends.size(); ++c) {
      const std::uint32_t from = c ? ends[c - 1] : 0;
      if (grid_.types[first_cell_[p] + c] != vtk_polyhedron) {
        grid_.verts.insert(grid_.verts.end(), verts.begin() + from, verts.begin() + ends[c]);
        written = grid_.verts.size();
      } else {
        const auto end = static_cast<std::size_t>(cell_ends[c]);
        if (cell_ends[c] < 0 || end < at_list || end > size) fail_array(faces, {"ends of polyhedra that increase to ", size}, {cell_ends[c]});
        if (is_new) {
          listed_faces(faces, p, cell_faces, face_ends, face_verts, static_cast<std::int64_t>(at_list), cell_ends[c]);
          written = grid_.verts.size();
        } else {
          if (!in_place) grid_.verts.resize(written + end - at_list);
          written = static_cast<std::size_t>(face_stream(faces, p, list, source, at_list, end, grid_.verts.data() + written) - grid_.verts.data());
          if (!in_place) grid_.verts.resize(written);
        }
        at_list = end;
      }
      if (written > max_ids) fail_to_count("corners of faces");
      grid_.cell_ends[first_cell_[p] + c] = static_cast<std::uint32_t>(written);
    }
    grid_.verts.resize(written);
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
  /// Integers as ids. Those that are too large or negative become "no id"; the first of them is remembered, for errors.
  struct id_list {
    std::vector<vert_id> ids;
    std::size_t first_bad = ~std::size_t{0};
    std::int64_t bad = 0;

    std::int64_t number(std::size_t k, vert_id id) const { return k == first_bad ? bad : std::int64_t{id.raw()}; }
  };
  id_list ids(const vtk_xml_array& a) {
    const std::uint64_t n = length_of(a);
    require_numbers(a, n);
    id_list list;
    core::reserve_large(list.ids, n);
    std::vector<vert_id> some;
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) {
      std::uint64_t all = 0;
      some.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<std::uint64_t>(values[i]);
        all |= x;
        some[i] = vert_id{static_cast<std::uint32_t>(x)};
      }
      for (std::size_t i = 0; all > max_index && i < count; ++i) {
        if (values[i] >= 0 && values[i] <= max_index) continue;
        some[i] = vert_id{};
        if (list.first_bad == ~std::size_t{0}) list.first_bad = list.ids.size() + i, list.bad = values[i];
      }
      list.ids.insert(list.ids.end(), some.begin(), some.end());
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
