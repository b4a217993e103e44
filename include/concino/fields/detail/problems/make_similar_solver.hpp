// A new solver of the same type and with the same options as the caller's, for a prepared problem to keep.
#pragma once

#include <concepts>
#include <memory>

namespace concino::detail {

/// Constructed from the caller's options if it has them. Not a copy: factors are large, and Eigen's cannot be copied.
template<class Solver>
std::unique_ptr<Solver> make_similar_solver(const Solver& solver) {
  if constexpr (requires { Solver(solver.options()); }) return std::make_unique<Solver>(solver.options());
  else if constexpr (std::default_initializable<Solver>) return std::make_unique<Solver>();
  else return std::make_unique<Solver>(solver);
}

}  // namespace concino::detail
