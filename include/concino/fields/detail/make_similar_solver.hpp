// A solver for a prepared problem to keep, like the one that its caller hands in.
#pragma once

#include <concepts>
#include <memory>

namespace concino::detail {

/// Made of the caller's options where it has them. Not a copy: factors are large, and Eigen's cannot be copied.
template<class Solver>
std::unique_ptr<Solver> make_similar_solver(const Solver& solver) {
  if constexpr (requires { Solver(solver.options()); }) return std::make_unique<Solver>(solver.options());
  else if constexpr (std::default_initializable<Solver>) return std::make_unique<Solver>();
  else return std::make_unique<Solver>(solver);
}

}  // namespace concino::detail
