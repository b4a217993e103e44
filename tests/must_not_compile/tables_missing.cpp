// expect in 10 lines: mesh_traits<M> needs tables: static const auto& tables[(]const M&[)]
// The message names the member that the base class needs, not the first verb that is missing because of it. Concepts are false without an error.
#include <concino/mesh/indexed_base.hpp>

struct mine {};
template<>
struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {};
static_assert(!concino::SurfaceMesh<mine> && !concino::PrimalGraph<mine> && !concino::DualGraph<mine>);

int main() { concino::explain_surface_mesh<mine>(); }
