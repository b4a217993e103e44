// The lowest element that contains a point of a mesh, checked, and the polys that contain that element.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/detail/lowest_element_search.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <concepts>
#include <variant>

namespace concino::detail {

/// Calls f(p) for each poly that contains the element of x.
template<EmbeddedMesh M, class F>
void for_each_poly_at(const M& m, const mesh_point<M>& x, const F& f) {
  const auto each = [&](const auto& some) {
    for (const poly_t<M> p : some) f(p);
  };
  std::visit([&](const auto& y) {
    if constexpr (requires { y.edge; }) each(adj_e2p(m, y.edge));
    else if constexpr (std::same_as<decltype(y), const vert_t<M>&>) each(adj_v2p(m, y));
    else if constexpr (std::same_as<decltype(y), const poly_t<M>&>) f(y);
    else each(adj_f2p(m, y));
  }, x.element);
}

/// As lowest_element, called by `caller`; role: what the place is, for messages.
template<EmbeddedMesh M>
mesh_point<M> lowest_element_of(const M& m, const mesh_point<M>& x, const char* caller, const char* role) {
  const auto check = [&](const auto& y, const char* kind, const char* all) {
    if (!contains(m, y))
      core::throw_joined<invalid_mesh>({caller, ": the ", role, ", ", kind, ' ', index_of(m, y), ", is no ", kind,
                                        " of the mesh; take it from ", all, "(m)"});
  };
  const auto place = [&](const auto& y, [[maybe_unused]] const char* kind) {
    const auto found = lowest_element_search<M>(m, caller)(y, x.position);
    if constexpr (!requires { y.edge; })
      if (!(found.away <= 1e-6))
        core::throw_joined<invalid_argument>(
            {caller, ": the position of the ", role, " is not in ", kind, ' ', index_of(m, y), ", but ",
             core::number_text(found.away),
             " of its diameter away; take the nearest point, as bounding_tree(m).closest(x)"});
    return found.place;
  };
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) {
    check(*v, "vert", "verts");
    return place(*v, "vert");
  }
  if (const auto* e = std::get_if<edge_point<M>>(&x.element)) {
    check(e->edge, "edge", "edges");
    if (!(e->parameter >= 0 && e->parameter <= 1))
      core::throw_joined<invalid_argument>(
          {caller, ": the ", role, " is on an edge, but its parameter is not in [0, 1]"});
    return place(*e, "edge");
  }
  if (const auto* p = std::get_if<poly_t<M>>(&x.element)) check(*p, "poly", "polys");
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    if (const auto* f = std::get_if<face_t<M>>(&x.element)) check(*f, "face", "faces");
  if (!is_finite(x.position))
    core::throw_joined<invalid_argument>({caller, ": the position of the ", role, " is not finite"});
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    if (const auto* f = std::get_if<face_t<M>>(&x.element)) return place(*f, "face");
  return place(std::get<poly_t<M>>(x.element), "poly");
}

/// The point of poly p that is nearest to x, at the lowest element that contains it.
/// Errors: invalid_mesh if p has points that are not finite.
template<EmbeddedMesh M>
mesh_point<M> nearest_mesh_point(const M& m, const poly_t<M>& p, const vec3& x, const char* caller) {
  return lowest_element_search<M>(m, caller)(p, x).place;
}

}  // namespace concino::detail
