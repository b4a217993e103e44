// The worst poly of a mesh by a quality metric.
#pragma once

#include <concino/quality/poly_quality.hpp>

namespace concino {

/// A poly and the value of a metric.
template<class M>
struct poly_value {
  poly_t<M> poly;
  double value;
};

/// The worst poly of m by a metric: auto w = worst(m, metric::aspect_ratio); w.poly; w.value.
/// Needs:  EmbeddedMesh.
/// Result: the first poly than which no other one is worse (is_worse): one with a point that is not finite, if there is
///         one, where the value is NaN.
/// Cost:   that of quality for every poly; parallel.
/// Errors: invalid_mesh if m has no polys; else as quality.
template<EmbeddedMesh M>
poly_value<M> worst(const M& m, metric what, const quality_options& options = {}) {
  const auto value = quality(m, what, options);
  const auto& all = polys(m);
  auto it = all.begin();
  const auto end = all.end();
  if (!(it != end)) core::throw_joined<invalid_mesh>({"worst: the mesh has no polys"});
  poly_t<M> found = *it;
  double found_value = value[found];
  for (++it; it != end; ++it) {
    const poly_t<M> p = *it;
    if (!is_worse(what, value[p], found_value)) continue;
    found = p;
    found_value = value[p];
  }
  return {found, found_value};
}

// What to write instead of calls that cannot compile.
template<class... T> void worst(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void worst(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
