// Prescribed derivatives across the boundary (Neumann conditions), and their load on the verts there.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/fields/detail/problems/dirichlet.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/mesh/facet_map.hpp>
#include <concino/operators/corner_gradients.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Calls share(vert, the integral of the vert's hat function over the facet). For an edge it is half its length at each
/// end. A face uses the fan of triangles of the gradients of polyhedra, projected along the vector area. So the sum is
/// the length or area, and linear functions are integrated exactly.
template<AnyMesh M, class F>
void integrate_over(const M& m, const facet_t<M>& x, F&& share) {
  if constexpr (SurfaceMesh<M>) {  // an edge needs no fan of triangles
    const double half = edge_length(m, x) / 2;
    for (const vert_t<M> v : adj_e2v(m, x)) share(v, half);
  } else {
    std::vector<vert_t<M>> corner;
    std::vector<vec3> around, shares;
    const vec3 mean = shape_of(m, adj_f2v(m, x)).mean;
    for (const vert_t<M> v : adj_f2v(m, x)) {
      corner.push_back(v);
      around.push_back(to_vec3(point(m, v)) - mean);
    }
    const vec3 area = integrate_fan(around, 1, [&](std::size_t, const vec3& s) { shares.push_back(s); });
    const double size = norm(area);
    if (size == 0) return;
    for (std::size_t i = 0; i < corner.size(); ++i) share(corner[i], dot(shares[i], area / size));
  }
}

/// An edge or face in messages.
struct facet_by_index {
  template<class M>
  std::string operator()(const M& m, const facet_t<M>& x) const {
    return core::joined({dimension_v<M> == 2 ? "edge " : "face ", index_of(m, x)});
  }
};

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_bad_flux(const char* caller, const std::string& facet,
                                                                  const char* what) {
  core::throw_joined<invalid_argument>({caller, ": the flux given at ", facet, what});
}

/// name(m, facet): the facet in messages.
/// Errors: invalid_mesh if a flux is given at what is no edge or face of m, or at one that is not on the boundary;
///         invalid_argument if one is not finite, or two different ones are given at one facet.
template<class T, AnyMesh M, class N, class Name = facet_by_index>
void add_fluxes(const M& m, const N& fluxes, right_hand_sides<T>& load, const char* caller, const Name& name = {}) {
  constexpr bool is_surface = dimension_v<M> == 2;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!(fluxes.begin() != fluxes.end())) return;
  auto known = make_facet_map<T>(m, same_in_all_components<T>(none));
  for (const auto& [facet, number] : fluxes) {
    const facet_t<M> x = facet;
    const T flux = as_field_value<T>(number);
    if (!contains(m, x))
      core::throw_joined<invalid_mesh>(
          {caller, is_surface
                       ? ": a flux is given at something that is not an edge of the mesh; take edges from edges(m)"
                       : ": a flux is given at something that is not a face of the mesh; take faces from faces(m)"});
    const std::size_t polys = num_elements(adj_facet2p(m, x));
    if (polys != 1)
      core::throw_joined<invalid_mesh>({caller, ": a flux is given at ", name(m, x), ", which has ", polys,
                                        " polys; give fluxes on the boundary only, where there is one poly"});
    T& before = known[x];
    const bool again = !std::isnan(field_component(before, 0));
    for (std::size_t k = 0; k < component_count<T>; ++k) {
      if (!std::isfinite(field_component(flux, k))) throw_bad_flux(caller, name(m, x), " is not finite");
      if (again && field_component(before, k) != field_component(flux, k))
        throw_bad_flux(caller, name(m, x), " differs from another one given there; keep one");
    }
    if (again) continue;
    before = flux;
    integrate_over(m, x, [&](const vert_t<M>& v, double size) {
      for (std::size_t k = 0; k < component_count<T>; ++k)
        load[k][static_cast<Eigen::Index>(index_of(m, v))] += size * field_component(flux, k);
    });
  }
}

/// The right-hand side M f + S of a mesh at this size. In units, u is f times length^2, and a flux times length.
/// product: M f. name: see add_fluxes.
template<class T, class M, class N, class Name = facet_by_index>
right_hand_sides<T> poisson_load(const views::scaled<M>& at, right_hand_sides<T>&& product, const N& fluxes,
                                 const char* caller, const Name& name = {}) {
  const auto enlarge = [&] {
    if (at.exponent() == 0) return;
    for (auto& column : product)
      for (Eigen::Index i = 0; i < column.size(); ++i) column[i] = std::ldexp(column[i], at.exponent());
  };
  enlarge();
  add_fluxes<T>(at, fluxes, product, caller, name);
  enlarge();
  return std::move(product);
}

}  // namespace detail

}  // namespace concino
