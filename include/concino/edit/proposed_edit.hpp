// proposed_edit: an edit of polys that is about to be made, for invariants, which decide whether it is allowed.
// `invariant` holds any of them.
//
//   auto small = [](const cn::proposed_edit& e) {
//     return e.num_new_polys() < 40 ? cn::permission{} : cn::permission{cn::refusal::invariant, "too many polys"};
//   };
//   cn::edge_collapse(m, e, {.keep = {cn::no_inversion, small}});
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/edit/permission.hpp>

#include <concepts>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

/// What a new poly comes from: old polys with successive numbers.
struct poly_origin {
  unsigned first, count;
};

/// The polygon of a poly, or its faces, which run counter-clockwise seen from outside: lists of local numbers of verts.
class proposed_lists {
  std::span<const unsigned> corners_, ends_;  // of all polys
  std::size_t first_, last_;

  std::size_t start(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1]; }

 public:
  proposed_lists(std::span<const unsigned> corners, std::span<const unsigned> ends, std::size_t first,
                 std::size_t last)
      : corners_(corners), ends_(ends), first_(first), last_(last) {}
  std::size_t size() const { return last_ - first_; }
  std::span<const unsigned> operator[](std::size_t i) const {
    return corners_.subspan(start(first_ + i), ends_[first_ + i] - start(first_ + i));
  }
  /// The corners of all lists.
  std::span<const unsigned> all() const { return corners_.subspan(start(first_), start(last_) - start(first_)); }
};

/// Verts have local numbers: the existing ones, then the new ones. Polys are lists of `corners_per_poly` of these, in
/// the order of adj_p2v; in edits of polys with any number of verts, see old_lists and new_lists.
struct proposed_edit {
  static constexpr unsigned none = ~0u;

  unsigned corners_per_poly = 0;               // 3: triangles, 4: tets, 0: polys with any number of verts
  unsigned dimension = 0;                      // if it is 0: of polygons 2, of polyhedra 3
  std::span<const std::size_t> verts;          // index_of the existing verts
  std::span<const vec3> points_before;         // of existing verts
  std::span<const vec3> points_after;          // of all verts
  std::span<const std::size_t> old_polys;      // index_of the polys that change: first those that are replaced, then
                                               // those that only have a vert that moves
  std::span<const unsigned> old_corners;       // of these
  std::span<const unsigned> new_corners;       // of the new polys, and of those that only have a vert that moves
  std::span<const poly_origin> origins;        // of these, in old_polys
  unsigned removed_vert = none;                // it becomes one with `kept_vert`
  unsigned kept_vert = none;
  const void* mesh = nullptr;                  // the mesh, and what the invariants of this library ask about it
  const void* cavity = nullptr;
  const void* mesh_type = nullptr;
  // If corners_per_poly is 0: where lists end in the corners, and polys in the lists.
  std::span<const unsigned> old_ends, old_poly_ends, new_ends, new_poly_ends;

  std::size_t num_old_polys() const { return old_polys.size(); }
  std::size_t num_new_polys() const { return origins.size(); }
  /// The corners of a poly; if corners_per_poly is 0, those of all its lists.
  std::span<const unsigned> old_poly(std::size_t k) const {
    if (corners_per_poly == 0) return old_lists(k).all();
    return old_corners.subspan(k * corners_per_poly, corners_per_poly);
  }
  std::span<const unsigned> new_poly(std::size_t k) const {
    if (corners_per_poly == 0) return new_lists(k).all();
    return new_corners.subspan(k * corners_per_poly, corners_per_poly);
  }
  /// If corners_per_poly is 0: the polygon of a poly, or its faces.
  proposed_lists old_lists(std::size_t k) const {
    return {old_corners, old_ends, k == 0 ? 0 : old_poly_ends[k - 1], old_poly_ends[k]};
  }
  proposed_lists new_lists(std::size_t k) const {
    return {new_corners, new_ends, k == 0 ? 0 : new_poly_ends[k - 1], new_poly_ends[k]};
  }
};

/// Any callable that takes a const proposed_edit& and returns a permission, and can be copied byte by byte, such as a
/// lambda that captures references, up to six pointers.
class invariant {
  static constexpr std::size_t max_size = 6 * sizeof(void*);

  alignas(void*) unsigned char callable_[max_size];
  permission (*call_)(const void*, const proposed_edit&);

 public:
  template<class F>
    requires(!std::same_as<F, invariant> && std::is_invocable_r_v<permission, const F&, const proposed_edit&> &&
             std::is_trivially_copyable_v<F> && sizeof(F) <= max_size && alignof(F) <= alignof(void*))
  invariant(const F& f)
      : call_([](const void* callable, const proposed_edit& e) {
          return permission((*static_cast<const F*>(callable))(e));
        }) {
    ::new (static_cast<void*>(callable_)) F(f);
  }

  permission operator()(const proposed_edit& e) const { return call_(callable_, e); }
};

/// Options of an edit. A list that is used often is made once, as making it allocates memory.
struct edit_options {
  std::vector<invariant> keep = {};  // the edit is refused if one of these refuses it; they are asked in this order,
                                     // before anything changes
};

}  // namespace concino
