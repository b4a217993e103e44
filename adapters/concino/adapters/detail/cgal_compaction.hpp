// Garbage collection of a CGAL::Surface_mesh that changes nothing if memory runs out.
//
// CGAL's collect_garbage() moves elements into the gaps, renumbers the links, calls a visitor, and then copies its
// arrays to smaller ones. If there is no memory for the copies, it leaves arrays of different sizes and wrong counts.
// So the visitor cuts the arrays, and corrects the counts, itself.
#pragma once

#include <concino/adapters/detail/cgal_surface_kernel.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cstdint>
#include <numeric>
#include <optional>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace concino::detail {

/// The property to which collect_garbage() writes new numbers. Added before, since it cannot be found without memory
/// for its name.
template<class Mesh, class X>
class cgal_index_map {
  Mesh& m_;
  typename Mesh::template Property_map<X, X> map_;

 public:
  cgal_index_map(Mesh& m, const char* name) : m_(m), map_(m.template add_property_map<X, X>(name).first) {}
  cgal_index_map(const cgal_index_map&) = delete;
  cgal_index_map& operator=(const cgal_index_map&) = delete;
  ~cgal_index_map() {
    if (map_) m_.template remove_property_map<X>(map_);
  }
  /// CGAL has removed the property.
  void release() noexcept { map_.reset(); }
};

/// Whether a copy of a value of this type never fails.
template<class... T>
bool is_one_of(const std::type_info& type) {
  return ((type == typeid(T)) || ...);
}

template<class P>
class cgal_compaction {
  using kernel = cgal_surface_kernel<P>;
  using mesh = typename kernel::mesh;
  using vert = typename kernel::vert;
  using halfedge = typename kernel::halfedge;
  using edge = typename kernel::edge;
  using poly = typename kernel::poly;

  mesh& m_;
  std::optional<mesh> backup_;  // of a mesh that may lose values while CGAL moves them
  cgal_index_map<mesh, vert> vert_map_;
  cgal_index_map<mesh, halfedge> halfedge_map_;
  cgal_index_map<mesh, poly> poly_map_;
  std::vector<std::uint32_t> verts_, edges_, polys_;  // old numbers, by new ones
  bool is_renumbered_ = false;

  static std::vector<std::uint32_t> identity(std::size_t n) {
    std::vector<std::uint32_t> all(n);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  void release_maps() noexcept { vert_map_.release(), halfedge_map_.release(), poly_map_.release(); }

  /// Whether copies of all values that users added never fail, as far as their types are known. The first `num_own`
  /// properties are CGAL's own.
  template<class X>
  static bool has_safe_values(mesh& m, std::size_t num_own) {
    const auto names = m.template properties<X>();
    for (std::size_t i = num_own; i < names.size(); ++i)
      if (!is_one_of<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long,
                     float, double, vec3, vert, halfedge, edge, poly, uncopied<typename kernel::edits>>(
              m.template property_type<X>(names[i])) &&
          !(std::is_nothrow_copy_constructible_v<P> && m.template property_type<X>(names[i]) == typeid(P)))
        return false;
    return true;
  }
  static bool has_safe_values(mesh& m) {
    return std::is_nothrow_copy_constructible_v<P> && std::is_nothrow_copy_assignable_v<P> &&
           has_safe_values<vert>(m, 3) && has_safe_values<halfedge>(m, 1) && has_safe_values<edge>(m, 1) &&
           has_safe_values<poly>(m, 2);
  }

 public:
  /// Allocates all memory that is needed.
  explicit cgal_compaction(mesh& m)
      : m_(m), backup_(has_safe_values(m) ? std::nullopt : std::optional<mesh>(std::in_place, m)),
        vert_map_(m, "v:garbage-collection"), halfedge_map_(m, "h:garbage-collection"),
        poly_map_(m, "f:garbage-collection"), verts_(identity(m.number_of_vertices())),
        edges_(identity(m.number_of_edges())), polys_(identity(m.number_of_faces())) {}

  /// Errors: what the copies of values throw. The mesh is as before then.
  void make() {
    if (!m_.has_garbage()) return;
    try {
      m_.collect_garbage(*this);
    } catch (...) {
      if (is_renumbered_) return;  // there is no memory for copies of the arrays, so they keep their capacities
      if (backup_) {
        release_maps();
        m_ = std::move(*backup_);
      }
      throw;
    }
  }
  /// The visitor of CGAL.
  template<class Verts, class Halfedges, class Polys>
  void operator()(const Verts& vert_before, const Halfedges& halfedge_before, const Polys& poly_before) noexcept {
    for (unsigned i = 0; i < verts_.size(); ++i) verts_[i] = vert_before[vert(i)].idx();
    for (unsigned i = 0; i < edges_.size(); ++i) edges_[i] = halfedge_before[halfedge(2 * i)].idx() / 2;
    for (unsigned i = 0; i < polys_.size(); ++i) polys_[i] = poly_before[poly(i)].idx();
    kernel::forget_removed(m_);
    m_.resize(static_cast<unsigned>(verts_.size()), static_cast<unsigned>(edges_.size()),
              static_cast<unsigned>(polys_.size()));
    release_maps();
    is_renumbered_ = true;
  }
  /// After make().
  correspondence origins() noexcept {
    return {
        element_origins(std::move(verts_)), element_origins(std::move(edges_)), {}, element_origins(std::move(polys_))};
  }
};

}  // namespace concino::detail
