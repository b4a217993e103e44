// The archetype of editable meshes: a mesh with points that has set_point and rewire, and nothing else that changes it.
#pragma once

#include <concino/concepts/archetypes/traits.hpp>
#include <concino/concepts/editable.hpp>

namespace concino::archetypes {

// The arity says which new polys a cavity may list, and how, so it is not hidden.
template<class M> inline constexpr parts editable_parts = mesh | points | arity;

/// A view of a mesh that changes it.
template<class M>
class editable : public archetype<M, editable_parts<M>> {
  M* m_;

 public:
  constexpr explicit editable(M& m) : archetype<M, editable_parts<M>>(m), m_(&m) {}
  constexpr M& base_to_change() { return *m_; }
};

}  // namespace concino::archetypes

namespace concino {

template<class M>
struct mesh_traits<archetypes::editable<M>> : mesh_traits<archetypes::archetype<M, archetypes::editable_parts<M>>> {
 private:
  using A = archetypes::editable<M>;
  using v = archetypes::opaque<vert_t<M>, vert_tag>;
  using p = archetypes::opaque<poly_t<M>, poly_tag>;

  // The arrays of the cavity are not copied: an opaque descriptor has the same bytes as the one that it contains.
  template<class D, class Base>
  static id_span<Base> in(const id_span<D>& list) {
    const auto* const first = archetypes::access::base_array<Base>(list.begin());
    return {first, first + list.size()};
  }

 public:
  template<class X>
  static void set_point(A& a, const v& x, const X& at) {
    traits<M>::set_point(a.base_to_change(), archetypes::access::base(x), at);
  }
  static void rewire(A& a, const cavity_of<v, p>& c, const cavity_result_of<v, p>& made) {
    const cavity<M> lists{in<p, poly_t<M>>(c.polys), in<v, vert_t<M>>(c.verts), c.points, c.corners, c.ends,
                          c.poly_ends, c.kept, c.removed};
    traits<M>::rewire(
        a.base_to_change(), lists,
        {archetypes::access::base_array<vert_t<M>>(made.verts), archetypes::access::base_array<poly_t<M>>(made.polys)});
  }
};

}  // namespace concino
