// Compares eigenfunctions, if Spectra is installed.
#pragma once

#include <agreement/algorithms/virtual_elements.hpp>

#include <concino/adapters/spectra.hpp>

namespace concino::agreement {

struct vibrations {
  static constexpr const char* name = "eigenfunctions";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if (!all_polys_have_measure(both.native)) return false;
    const auto here = eigenfunctions(both.native, 3);
    const auto there = eigenfunctions(both.other, 3);
    expect(here.isolated == there.isolated, "as many verts of no poly");
    const double scale = std::max(1.0, here.values.back());
    for (std::size_t i = 0; i < here.values.size(); ++i) {
      INFO(here.values[i] << " and " << there.values[i]);
      expect(std::abs(here.values[i] - there.values[i]) <= 1e-8 * scale, "the eigenvalue");
      // functions of equal eigenvalues are any basis of the eigenspace, so each is only checked against its own equation
      const auto& u = there.functions[i];
      Eigen::VectorXd x(static_cast<Eigen::Index>(u.values().size()));
      for (std::size_t k = 0; k < u.values().size(); ++k) x[static_cast<Eigen::Index>(k)] = u.values()[k];
      const Eigen::VectorXd error = laplacian(both.other) * x + there.values[i] * (mass_matrix(both.other) * x);
      expect(error.norm() <= 1e-7 * scale * x.norm(), "the function is one of that eigenvalue");
    }
    return true;
  }
};

}  // namespace concino::agreement
