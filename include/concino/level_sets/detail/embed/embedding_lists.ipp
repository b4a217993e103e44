// Lists for rewire of the parts of polys; see embedding_lists.hpp.
#pragma once

#include <concino/level_sets/detail/embed/embedding_lists.hpp>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <utility>

namespace concino::detail {

/// Collects new polys in any order, and sorts one of each old poly to the front.
class embedding_collector {
  struct new_poly {
    std::uint32_t old;
    std::size_t first, last;  // of its lists in lists_
  };
  const std::vector<level_place>& places_;
  const std::vector<std::uint32_t>& vert_indices_;
  embedding_lists& result_;
  std::vector<std::uint32_t> number_of_vert_;
  std::vector<unsigned> corners_;
  std::vector<std::size_t> lists_{0};  // where each list of corners ends; the first entry is its beginning
  std::vector<new_poly> polys_;

  bool is_old(const level_place& x) const { return x.kind == level_place::vert && vert_indices_[x.above] != ~0u; }

 public:
  embedding_collector(const std::vector<level_place>& places, const std::vector<std::uint32_t>& vert_indices,
                      embedding_lists& result)
      : places_(places), vert_indices_(vert_indices), result_(result), number_of_vert_(vert_indices.size(), ~0u) {
    result_.number_of_place.assign(places.size(), ~0u);
  }

  /// Makes room for about so many polys with so many lists of corners.
  void reserve(std::size_t num_polys, std::size_t num_lists) {
    corners_.reserve(4 * num_lists), lists_.reserve(num_lists + 1), polys_.reserve(num_polys);
  }
  void add_vert(std::uint32_t v) {
    if (vert_indices_[v] == ~0u || number_of_vert_[v] != ~0u) return;
    number_of_vert_[v] = static_cast<std::uint32_t>(result_.verts.size());
    result_.verts.push_back(v);
  }
  /// After all existing verts.
  void add_new_place(std::uint32_t place) {
    if (is_old(places_[place]) || result_.number_of_place[place] != ~0u) return;
    result_.number_of_place[place] = static_cast<std::uint32_t>(result_.places.size());
    result_.places.push_back(place);
  }
  unsigned number(std::uint32_t place) const {
    const level_place& x = places_[place];
    return is_old(x) ? number_of_vert_[x.above]
                     : static_cast<unsigned>(result_.verts.size()) + result_.number_of_place[place];
  }
  void add_list(std::span<const unsigned> list) {
    corners_.insert(corners_.end(), list.begin(), list.end());
    lists_.push_back(corners_.size());
  }
  /// Ends a poly, which has the lists since the last one.
  void end_poly(std::uint32_t old) {
    polys_.push_back({old, polys_.empty() ? 0 : polys_.back().last, lists_.size() - 1});
  }

  void finish(bool are_polyhedra) {
    std::vector<std::size_t> order;
    std::vector<unsigned char> is_first(polys_.size(), 0);
    order.reserve(polys_.size());
    result_.corners.reserve(corners_.size()), result_.ends.reserve(lists_.size()),
        result_.origins.reserve(polys_.size());
    for (std::size_t i = 0; i < polys_.size(); ++i) {
      is_first[i] = i == 0 || polys_[i].old != polys_[i - 1].old;
      if (is_first[i]) order.push_back(i);
    }
    for (std::size_t i = 0; i < polys_.size(); ++i)
      if (!is_first[i]) order.push_back(i);
    for (const std::size_t i : order) {
      for (std::size_t l = polys_[i].first; l < polys_[i].last; ++l) {
        result_.corners.insert(result_.corners.end(), corners_.data() + lists_[l], corners_.data() + lists_[l + 1]);
        result_.ends.push_back(static_cast<unsigned>(result_.corners.size()));
      }
      if (are_polyhedra) result_.poly_ends.push_back(static_cast<unsigned>(result_.ends.size()));
      result_.origins.push_back(polys_[i].old);
    }
  }
  void add_cut(std::initializer_list<std::uint32_t> some_places) {
    result_.cut_places.insert(result_.cut_places.end(), some_places);
    result_.cut_ends.push_back(static_cast<std::uint32_t>(result_.cut_places.size()));
  }
  /// Adds a face on the level set, in the triangles of list_embedding() if asked for. Those whose verts have no numbers
  /// belong to cells that do not change.
  void add_cut_face(std::vector<std::uint32_t> face, bool triangulate) {
    if (!triangulate) {
      result_.cut_places.insert(result_.cut_places.end(), face.begin(), face.end());
      result_.cut_ends.push_back(static_cast<std::uint32_t>(result_.cut_places.size()));
      return;
    }
    if (face.size() > 3)
      std::rotate(face.begin(),
                  std::min_element(face.begin(), face.end(), [&](auto a, auto b) { return number(a) < number(b); }),
                  face.end());
    for (std::size_t k = 1; k + 1 < face.size(); ++k) add_cut({face[0], face[k], face[k + 1]});
  }
};

/// The list, rotated so that it begins with its smallest number.
CONCINO_INLINE std::vector<unsigned> from_smallest(std::vector<unsigned> list) {
  std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
  return list;
}

CONCINO_INLINE embedding_lists list_embedding(const poly_parts& parts, const crossed_surface& s, bool triangulate) {
  embedding_lists result;
  embedding_collector all(parts.places, s.vert_indices, result);
  const auto changes = [&](std::size_t i) { return !parts.parts[i].is_whole; };
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    const std::uint32_t p = parts.parts[i].poly;
    if (!changes(i) || (!result.old_polys.empty() && result.old_polys.back() == p)) continue;
    result.old_polys.push_back(p);
    for (std::uint32_t k = s.first_corner[p]; k < s.first_corner[p + 1]; ++k) all.add_vert(s.verts[k]);
  }
  for (std::size_t i = 0; i < parts.parts.size(); ++i)
    for (std::uint32_t k = parts.parts[i].first; changes(i) && k < parts.parts[i].last; ++k)
      all.add_new_place(parts.part_places[k]);
  std::uint32_t old = ~0u, before = ~0u;
  std::vector<unsigned> list;
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    if (!changes(i)) continue;
    const poly_parts::part& x = parts.parts[i];
    if (x.poly != before) ++old, before = x.poly;
    list.clear();
    for (std::uint32_t k = x.first; k < x.last; ++k) list.push_back(all.number(parts.part_places[k]));
    if (!triangulate) {
      all.add_list(list);
      all.end_poly(old);
      continue;
    }
    list = from_smallest(std::move(list));
    for (std::size_t k = 1; k + 1 < list.size(); ++k) {
      const unsigned triangle[] = {list[0], list[k], list[k + 1]};
      all.add_list(triangle);
      all.end_poly(old);
    }
  }
  for (const auto& [a, b] : parts.cut_edges) all.add_cut({a, b});
  all.finish(false);
  return result;
}

CONCINO_INLINE embedding_lists list_embedding(const cell_parts& parts, const crossed_volume& v, bool triangulate) {
  embedding_lists result;
  embedding_collector all(parts.places, v.vert_indices, result);
  const auto changes = [&](const cell_parts::part& x) { return !x.is_whole; };
  for (const cell_parts::part& x : parts.parts) {
    if (!changes(x) || (!result.old_polys.empty() && result.old_polys.back() == x.cell)) continue;
    result.old_polys.push_back(x.cell);
    for (std::uint32_t k = v.first_corner[v.first_facet[x.cell]]; k < v.first_corner[v.first_facet[x.cell + 1]]; ++k)
      all.add_vert(v.verts[k]);
  }
  const auto for_each_face = [&](const cell_parts::part& x, const auto& f) {
    for (std::uint32_t k = x.first; k < x.last; ++k) f(parts.faces[parts.part_faces[k]], parts.outward[k] != 0);
  };
  for (const cell_parts::part& x : parts.parts) {
    if (!changes(x)) continue;
    for_each_face(x, [&](const cell_parts::face& f, bool) {
      for (std::uint32_t k = f.first; k < f.last; ++k) all.add_new_place(parts.face_places[k]);
    });
  }
  std::uint32_t old = ~0u, before = ~0u;
  all.reserve(triangulate ? parts.part_faces.size() : parts.parts.size(), parts.part_faces.size());
  std::vector<std::vector<unsigned>> lists;  // those of one part; `size` of them are used
  std::size_t size = 0;
  const auto list_corners = [&](const cell_parts::face& f, bool outward) {
    if (size == lists.size()) lists.emplace_back();
    std::vector<unsigned>& list = lists[size++];
    list.clear();
    for (std::uint32_t k = f.first; k < f.last; ++k) list.push_back(all.number(parts.face_places[k]));
    if (!outward) std::reverse(list.begin(), list.end());
  };
  for (const cell_parts::part& x : parts.parts) {
    if (!changes(x)) continue;
    if (x.cell != before) ++old, before = x.cell;
    size = 0;
    for_each_face(x, list_corners);
    if (!triangulate) {
      for (std::size_t i = 0; i < size; ++i) all.add_list(lists[i]);
      all.end_poly(old);
      continue;
    }
    unsigned top = ~0u;
    for (std::size_t i = 0; i < size; ++i) top = std::min(top, *std::min_element(lists[i].begin(), lists[i].end()));
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<unsigned>& list = lists[i];
      std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
      for (std::size_t k = 1; list[0] != top && k + 1 < list.size(); ++k) {
        const unsigned tet[] = {top, list[0], list[k], list[k + 1]};
        all.add_list(tet);
        all.end_poly(old);
      }
    }
  }
  std::vector<unsigned char> is_used(parts.faces.size(), 0);
  for (const std::uint32_t f : parts.part_faces) is_used[f] = 1;
  for (std::size_t i = 0; i < parts.faces.size(); ++i)
    if (const cell_parts::face& f = parts.faces[i]; f.is_cut && is_used[i])
      all.add_cut_face({parts.face_places.data() + f.first, parts.face_places.data() + f.last}, triangulate);
  all.finish(!triangulate);
  return result;
}

}  // namespace concino::detail
