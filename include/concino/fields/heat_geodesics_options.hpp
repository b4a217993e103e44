// The options of heat geodesics.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>

namespace concino {

/// averaged:  the sum of both kinds of heat. It is the most accurate, and costs one more factorisation and
/// back-substitution if there is a boundary. neumann:   no heat flows through the boundary. Distances are too round
/// near it. dirichlet: the boundary absorbs all heat, which bends distances the other way.
enum class heat_boundary { averaged, neumann, dirichlet };

struct heat_geodesics_options {
  double time = 0;                                        // how long heat flows, in units of length^2, finite; 0: the
                                                          // default, see heat_geodesics
  concino::heat_boundary boundary = concino::heat_boundary::averaged;  // boundary conditions of the heat
  bool clamp = false;                                     // to the range between straight lines and paths over the
                                                          // mesh, see heat_geodesics
  concino::progress progress = nullptr;                   // called with "heat geodesics" and "factorising"
  concino::profiler* profiler = nullptr;                  // measures the call and its steps
};

}  // namespace concino
