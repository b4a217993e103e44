// Constructs generated meshes of any type, native or not, from flat arrays, and checks the arguments of generators.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/number_text.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace concino {

namespace requirement {

/// A mesh that can be generated: from flat arrays (the six native meshes), or by adding verts and polys one by one.
template<class M> concept can_be_generated = AnyMesh<M> && (is_constructible_from_arrays<M> || is_built_by_adding<M>);

}  // namespace requirement

namespace detail {

/// Constructs a surface from polygons.
/// Errors: unsupported if M refuses a polygon.
template<class M>
M construct_from_arrays(surface_arrays a) {
  if constexpr (from_surface<M>) {
    return M(std::move(a));
  } else {
    const polygonmesh m(std::move(a));
    return convert<M>(m);
  }
}

/// Splits each quad into two triangles, from its first vert to its third.
inline surface_arrays cut_quads(surface_arrays quads) {
  surface_arrays a{std::move(quads.points), {}, {}, 3};
  a.verts.reserve(quads.verts.size() / 2 * 3);
  for (std::size_t i = 0; i < quads.verts.size(); i += 4)
    for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u}) a.verts.push_back(quads.verts[i + k]);
  return a;
}

/// Constructs a surface from quads, which are split if M has triangles.
template<class M>
M construct_from_quads(surface_arrays quads) {
  // quads are split into triangles
  if constexpr (arity_v<M> == 3) return construct_from_arrays<M>(cut_quads(std::move(quads)));
  else return construct_from_arrays<M>(std::move(quads));
}

/// Splits each hex into six tets. Every quad is split at its vert of the smallest number, so that two hexes that share
/// it agree. In a grid that is numbered row by row, the six tets surround one diagonal of the cube.
/// Source: Kuhn 1960; Dompierre, Labbe, Vallet, Camarero 1999, "How to subdivide pyramids, prisms and hexahedra into
///         tetrahedra".
inline cell_arrays tets_of(cell_arrays hexes) {
  cell_arrays a{std::move(hexes.points), {}, 4};
  a.verts.reserve(hexes.verts.size() * 3);
  for (std::size_t i = 0; i < hexes.verts.size(); i += 8) {
    const vert_id* const v = hexes.verts.data() + i;
    const vert_id apex = *std::min_element(v, v + 8);
    for (const auto& f : hex_shape::face_vert) {
      std::size_t least = 0;
      bool has_apex = false;
      for (std::size_t k = 0; k < 4; ++k) {
        has_apex = has_apex || v[f[k]] == apex;
        if (v[f[k]] < v[f[least]]) least = k;
      }
      if (has_apex) continue;
      const vert_id a0 = v[f[least]], a1 = v[f[(least + 1) % 4]], a2 = v[f[(least + 2) % 4]],
                    a3 = v[f[(least + 3) % 4]];
      // faces are counter-clockwise seen from outside, so these are reversed
      a.verts.insert(a.verts.end(), {a0, a2, a1, apex, a0, a3, a2, apex});
    }
  }
  return a;
}

/// Constructs a volume from hexes: as hexes, as polyhedra, or split into tets.
template<class M>
M construct_from_hexes(cell_arrays hexes) {
  if constexpr (arity_v<M> == 4) {  // hexes are split into tets
    if constexpr (from_cells<M>) {
      return M(tets_of(std::move(hexes)));
    } else {
      const tetmesh m(tets_of(std::move(hexes)));
      return convert<M>(m);
    }
  } else if constexpr (from_cells<M>) {
    return M(std::move(hexes));
  } else {
    const hexmesh m(std::move(hexes));
    return convert<M>(m);
  }
}

/// Throws if there are more elements than 32-bit descriptors. For volumes, `polys` counts hexes.
template<class M>
void check_element_counts(const char* what, const char* option, double vert_count, double polys) {
  double corners = polys * 4;
  if constexpr (dimension_v<M> == 3) {  // the number of corners depends on the kind of mesh
    corners = polys * 24;  // six tets of four, or six faces of four
    if (arity_v<M> == 4) polys *= 6;
  } else {
    if (arity_v<M> == 3) polys *= 2;
    corners = polys * 6;
  }
  if (polys < 1073741823.0 && vert_count < 4294967295.0 && corners < 4294967295.0) return;
  core::throw_joined<invalid_argument>({what, ": ", option, " asks for ", core::number_text(polys), " polys and ",
                                        core::number_text(vert_count),
                                        " verts; at most 2^30 polys and 2^32 verts and corners fit"});
}

inline void check_positive(const char* what, const char* option, double x) {
  if (!(x > 0 && x <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {what, ": ", option, " is ", core::number_text(x), "; it must be finite and above 0"});
}
inline void check_finite(const char* what, const char* option, const vec3& x) {
  for (const std::size_t k : {0u, 1u, 2u})
    if (!std::isfinite(x[k]))
      core::throw_joined<invalid_argument>({what, ": ", option,
                                            k == 0   ? ".x"
                                            : k == 1 ? ".y"
                                                     : ".z",
                                            " is not finite"});
}
inline void check_at_least(const char* what, const std::string& option, std::size_t value, std::size_t least) {
  if (value < least)
    core::throw_joined<invalid_argument>({what, ": ", option, " is ", value, "; it must be at least ", least});
}

}  // namespace detail

}  // namespace concino
