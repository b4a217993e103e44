// Checks that every generated mesh must pass.
#pragma once

#include <concino/geometry/measure.hpp>
#include <concino/validate.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

/// The Euler characteristic: verts - edges + faces, minus polys in volumes.
template<AnyMesh M>
int euler(const M& m) {
  const int chi = static_cast<int>(num_verts(m)) - static_cast<int>(num_edges(m));
  if constexpr (VolumeMesh<M>) return chi + static_cast<int>(num_faces(m)) - static_cast<int>(num_polys(m));
  else return chi + static_cast<int>(num_polys(m));
}

/// Checks that all laws hold, that the mesh is a connected oriented manifold with this Euler characteristic, and that no element is degenerate,
/// inverted or isolated.
template<AnyMesh M>
void check_sound(const M& m, int chi) {
  CHECK(check_laws(m).empty());
  const auto report = validate(m, {.kinds = defect_kinds().without({defect_kind::non_planar})});
  for (const auto& d : report) CHECK_MESSAGE(false, d.what);
  CHECK(report.facts.manifold);
  CHECK(report.facts.orientable);
  CHECK(report.facts.components == 1);
  CHECK(euler(m) == chi);
  for (const poly_t<M> p : polys(m)) CHECK(measure(m, p) > 0);
}

}  // namespace concino::testing
