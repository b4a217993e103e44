// Options and results of deformations by handles.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>

#include <vector>

namespace concino {

/// The edges that are to be as rigid as possible together, by the rotation of a vert.
enum class rigid_cells : unsigned char {
  spokes,          // those at the vert, with the weights of the Laplacian; negative ones are made positive
  spokes_and_rims  // those of all polys at the vert, with the weights of the polys, whatever their signs
};

struct prepare_deform_options {
  rigid_cells rigidity = rigid_cells::spokes;  // which edges a rotation is fitted to
  concino::progress progress = nullptr;   // called with "factorising"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

struct deform_options {
  int max_iterations = 100;  // >= 0; 0: the start
  double tolerance = 1e-4;   // the iteration ends when the energy falls by less than this part; 0 to 1
};

/// A deformed shape.
template<class M>
struct deform_result {
  vert_map<M, vec3> points;      // for with_points(m, x.points), or to set the points of m
  std::vector<double> energies;  // of the start and after each iteration; none is larger than the one before. In units
                                 // of those of the discretisation times length^2
  bool has_converged = false;    // by the tolerance; else max_iterations were reached
};

}  // namespace concino
