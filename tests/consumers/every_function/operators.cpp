#include "call.hpp"

#include <concino/operators.hpp>
#include <concino/operators/stability.hpp>
#include <concino/operators/stiffness.hpp>

void call_operators() {
  const auto flow = [](const auto& m) { return cn::gradient(m, heights(m)); };
  call("explain_discretisation", [](auto& m) { cn::explain_discretisation<cn::virtual_elements_t, std::remove_reference_t<decltype(m)>>(); }, all);
  call("gradient", [](auto& m) { cn::gradient(m, heights(m)); }, all);
  call("vert_gradient", [](auto& m) { cn::vert_gradient(m, heights(m)); }, all);
  call("divergence", [&](auto& m) { cn::divergence(m, flow(m)); }, all);
  call("rotated", [&](auto& m) { cn::rotated(m, flow(m)); }, surfaces);
  call("gradient_matrix", [](auto& m) { cn::gradient_matrix(m); }, all);
  call("vert_gradient_matrix", [](auto& m) { cn::vert_gradient_matrix(m); }, all);
  call("divergence_matrix", [](auto& m) { cn::divergence_matrix(m); }, all);
  call("laplacian", [](auto& m) {
    cn::laplacian(m);
    cn::laplacian(m, cn::uniform);
  }, all);
  call("laplacian", [](auto& m) { cn::laplacian(m, cn::cotangent); }, kinds<cn::trimesh, cn::tetmesh>());
  call("lower_stiffness", [](auto& m) { cn::lower_stiffness(m, cn::virtual_elements); }, all);
  call("with_stiffness", [](auto& m) {
    const auto nothing = [](const auto&) { return Eigen::SparseMatrix<double>(); };
    cn::with_stiffness(m, cn::virtual_elements, nothing, nothing);
  }, all);
  call("stability", [](auto& m) { cn::stability(m, first(cn::polys(m))); }, all);
  call("regular_eigenvalue_ratio", [](auto&) { cn::regular_eigenvalue_ratio(6); }, kinds<cn::polygonmesh>());
  call("vert_masses", [](auto& m) { cn::vert_masses(m); }, all);
  call("mass_matrix", [](auto& m) { cn::mass_matrix(m); }, all);
  call("poly_masses", [](auto& m) { cn::poly_masses(m); }, all);
  call("poly_mass_matrix", [](auto& m) { cn::poly_mass_matrix(m); }, all);
}
