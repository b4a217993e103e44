// Reverses the winding of polys: polygons run the other way round, cells become their mirror images.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/saved_edit.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

namespace detail {

/// Polys that are replaced by their reverses, with the same verts.
template<class M>
class winding_cavity {
  const M& m_;
  std::vector<poly_t<M>> polys_;
  std::vector<vert_t<M>> verts_;
  core::local_numbers numbers_;
  std::vector<unsigned> corners_, ends_, poly_ends_;
  std::vector<unsigned> old_corners_, old_ends_;  // in the order of adj_p2v

  void add_corner(unsigned v) { corners_.push_back(v); }
  void end_list() { ends_.push_back(static_cast<unsigned>(corners_.size())); }

  /// The first corner of a polygon stays the first.
  void add_reverse(const poly_t<M>&, const unsigned* corners, std::size_t n)
    requires SurfaceMesh<M>
  {
    add_corner(corners[0]);
    for (std::size_t k = n; k > 1; --k) add_corner(corners[k - 1]);
    end_list();
  }
  void add_reverse(const poly_t<M>&, const unsigned* corners, std::size_t n)
    requires(VolumeMesh<M> && arity_v<M> > 0)
  {
    const standard_cell& cell = standard_cell_of(arity_v<M> == 4 ? cell_shape::tet : cell_shape::hex);
    for (std::size_t k = 0; k < n; ++k) add_corner(corners[cell.mirrored[k]]);
    end_list();
  }
  /// Faces run counter-clockwise seen from outside, so those that are outward now are reversed.
  void add_reverse(const poly_t<M>& p, const unsigned*, std::size_t)
    requires(VolumeMesh<M> && arity_v<M> == 0)
  {
    for (const face_t<M> f : adj_p2f(m_, p)) {
      const std::size_t first = corners_.size();
      for (const vert_t<M> v : adj_f2v(m_, f)) add_corner(numbers_.find(index_of(m_, v)));
      if (face_is_outward(m_, p, f))
        std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end());
      end_list();
    }
    poly_ends_.push_back(static_cast<unsigned>(ends_.size()));
  }

  template<class T>
  static id_span<T> span(const std::vector<T>& v) { return {v.data(), v.data() + v.size()}; }

  void replace(M& m) {
    std::vector<poly_t<M>> made(polys_.size());
    rewire(m,
           cavity<M>{span(polys_), span(verts_), {}, span(corners_), span(ends_), span(poly_ends_), polys_.size(), 0},
           cavity_result<M>{nullptr, made.data()});
  }

  /// The value at a corner stays at its vert.
  void replace_with_values(M& m) {
    correspondence origins;
    for (const poly_t<M>& p : polys_) {
      auto corner = static_cast<std::uint32_t>(traits<M>::first_corner(m, p));
      for (std::size_t n = num_elements(adj_p2v(m, p)); n > 0; --n) origins.corners.add(corner++);
    }
    carried_values values(traits<M>::properties(m), origins, origins);
    std::vector<unsigned> corner_at(verts_.size());
    const auto for_each_replaced = [&](const auto& save) {
      for (std::size_t i = 0; i < origins.corners.size(); ++i) save(element_kind::corner, origins.corners.only(i));
    };
    replace_saved(m, for_each_replaced, [&] { replace(m); });
    write(m, values, corner_at.data());
  }
  void write(const M& m, carried_values& values, unsigned* corner_at) const noexcept {
    for (std::size_t p = 0, i = 0; p < polys_.size(); ++p) {
      for (; i < old_ends_[p]; ++i) corner_at[old_corners_[i]] = static_cast<unsigned>(i);
      std::size_t corner = traits<M>::first_corner(m, polys_[p]);
      for (const vert_t<M> v : adj_p2v(m, polys_[p]))
        values.write(element_kind::corner, corner_at[numbers_.find(index_of(m, v))], corner++);
    }
  }

 public:
  explicit winding_cavity(const M& m) : m_(m) {}

  void add(const poly_t<M>& p) {
    const std::size_t first = old_corners_.size();
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const unsigned number = numbers_.add(index_of(m_, v));
      if (number == verts_.size()) verts_.push_back(v);
      old_corners_.push_back(number);
    }
    old_ends_.push_back(static_cast<unsigned>(old_corners_.size()));
    polys_.push_back(p);
    add_reverse(p, old_corners_.data() + first, old_corners_.size() - first);
  }
  void apply(M& m) {
    if (polys_.empty()) return;
    if constexpr (carries_values<M>)
      if (traits<M>::properties(m).has(element_kind::corner)) return replace_with_values(m);
    replace(m);
  }
};

}  // namespace detail

/// Reverses the winding of p. A polygon lists its verts the other way round, from the same first one. A tet or hex
/// becomes its mirror image, in the standard order and with the opposite volume. The outward faces of a general
/// polyhedron become inward, the inward ones outward.
/// Needs:  EditableMesh M, a poly of m.
/// Result: none. All elements keep their descriptors. Named properties stay at their elements, those of corners at the
///         same verts.
/// Cost:   the elements at the verts of p, but O(mesh) the first time.
/// Errors: invalid_mesh if p is not a poly of m; unsupported if the library of m cannot link neighbours of different
///         winding. The mesh is unchanged then, also if memory runs out.
template<EditableMesh M>
void flip_winding(M& m, poly_t<M> p) {
  detail::check_element(m, p, "flip_winding", "poly");
  detail::winding_cavity<M> c(m);
  c.add(p);
  c.apply(m);
}

/// Reverses the winding of all polys, as above.
/// Needs:  EditableMesh M.
/// Result: none. All elements keep their descriptors. Named properties stay at their elements, those of corners at the
///         same verts.
/// Cost:   O(elements) time and memory.
/// Errors: none of its own. If memory runs out, the mesh is unchanged.
template<EditableMesh M>
void flip_winding(M& m) {
  detail::winding_cavity<M> c(m);
  for (const poly_t<M> p : polys(m)) c.add(p);
  c.apply(m);
}

}  // namespace concino
