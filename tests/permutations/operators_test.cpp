// Operators do not depend on the order in which a mesh is stored.
#include <concino/operators.hpp>
#include <concino/operators/de_goes.hpp>
#include <concino/operators/virtual_refinement.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// A matrix times random values at verts, as values at verts: differences of any entry show.
template<class M>
vert_map<M, double> times_values(const Eigen::SparseMatrix<double>& a, const stored_mesh<M>& x) {
  const auto u = x.vert_values();
  Eigen::VectorXd in(a.cols());
  for (const vert_id v : x.verts) in[static_cast<Eigen::Index>(v.raw())] = u[v];
  const Eigen::VectorXd out = a * in;
  auto r = make_vert_map<double>(x.mesh, 0.0);
  for (const vert_id v : x.verts) r[v] = out[static_cast<Eigen::Index>(v.raw())];
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("operators do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const bool is_concave = check.name().starts_with("agglomerate");  // unsupported by virtual refinement
    check.at_verts("laplacian", [](const s& x) { return times_values(laplacian(x.mesh), x); });
    check.at_verts("mass_matrix", [](const s& x) { return times_values(mass_matrix(x.mesh, {.lumped = false}), x); });
    check.at_verts("vert_masses", [](const s& x) { return vert_masses(x.mesh); });
    if (!is_concave) check.at_verts("virtual_refinement", [](const s& x) { return times_values(laplacian(x.mesh, virtual_refinement), x); });
    check.at_verts("uniform", [](const s& x) { return times_values(laplacian(x.mesh, uniform), x); });
    if constexpr (SurfaceMesh<M>) check.at_verts("de_goes", [](const s& x) { return times_values(laplacian(x.mesh, de_goes), x); });
    if constexpr (TriMesh<M> || TetMesh<M>) check.at_verts("cotangent", [](const s& x) { return times_values(laplacian(x.mesh, cotangent), x); });
    check.at_polys("gradient", [](const s& x) { return gradient(x.mesh, x.vert_values()); });
    check.at_verts("vert_gradient", [](const s& x) { return vert_gradient(x.mesh, x.vert_values()); });
    check.at_verts("divergence", [](const s& x) { return divergence(x.mesh, x.poly_vectors()); });
  });
}
