// Powers of the Laplacian, and the systems of harmonic maps on the native meshes; see laplace_system.hpp.
#pragma once

#include <concino/fields/detail/problems/laplace_system.hpp>

#include <cstddef>
#include <utility>
#include <vector>

#ifdef CONCINO_COMPILED
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#endif

namespace concino::detail {

CONCINO_INLINE Eigen::SparseMatrix<double> polyharmonic(const Eigen::SparseMatrix<double>& a,
                                                        const std::vector<double>& mass, int exponent) {
  std::vector<double> inverse_mass(mass.size());
  for (std::size_t i = 0; i < mass.size(); ++i) inverse_mass[i] = mass[i] > 0 ? 1 / mass[i] : 1;
  Eigen::SparseMatrix<double> k = scaled_product(a, inverse_mass, a);
  for (int n = 2; n < exponent; ++n) {
    Eigen::SparseMatrix<double> next = scaled_product(a, inverse_mass, k);
    k.swap(next);
  }
  return k;
}

#ifdef CONCINO_COMPILED

template<class M, class D>
constrained_system<M> precompiled_laplace_system(const M& m, constrained_verts<M>&& constrained,
                                                 const D& discretisation, int exponent, const char* caller) {
  return unit_laplace_system(m, std::move(constrained), discretisation, exponent, caller);
}

#define CONCINO_DEFINE_LAPLACE_SYSTEMS(MESH)                                                                 \
  template constrained_system<MESH> precompiled_laplace_system(const MESH&, constrained_verts<MESH>&&,       \
                                                               const virtual_elements_t&, int, const char*); \
  template constrained_system<MESH> precompiled_laplace_system(const MESH&, constrained_verts<MESH>&&,       \
                                                               const uniform_t&, int, const char*)
CONCINO_DEFINE_LAPLACE_SYSTEMS(trimesh);
CONCINO_DEFINE_LAPLACE_SYSTEMS(quadmesh);
CONCINO_DEFINE_LAPLACE_SYSTEMS(polygonmesh);
CONCINO_DEFINE_LAPLACE_SYSTEMS(tetmesh);
CONCINO_DEFINE_LAPLACE_SYSTEMS(hexmesh);
CONCINO_DEFINE_LAPLACE_SYSTEMS(polyhedralmesh);
#undef CONCINO_DEFINE_LAPLACE_SYSTEMS

#endif

}  // namespace concino::detail
