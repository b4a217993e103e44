// Grading: moves verts so that cells grow from one end of the mesh to the other.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/common/finite.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace concino {

/// Moves every vert along each axis from x to min + (max - min) ((x - min) / (max - min))^power, within the bounding
/// box of m.
/// Needs:  MutablePoints M with verts; powers above 0: above 1 cells are small at min, below 1 at max.
/// Result: m, with the same bounding box. Coordinates along an axis do not change if m has no extent there or the power
///         is 1.
/// Cost:   O(V) time, O(V) memory.
/// Errors: invalid_argument if a power is not finite or not above 0; invalid_mesh that names a vert without a finite
///         point, or says that m is wider than the largest double. m is then unchanged.
template<MutablePoints M>
  requires requirement::has_verts<M> && (!std::is_const_v<M>)
void grade(M& m, const vec3& powers) {
  for (const std::size_t k : {0u, 1u, 2u})
    if (!(powers[k] > 0 && powers[k] <= std::numeric_limits<double>::max()))
      core::throw_joined<invalid_argument>({"grade: the power along ",
                                            std::string(k == 0   ? "x"
                                                        : k == 1 ? "y"
                                                                 : "z"),
                                            " is ", core::number_text(powers[k]), "; it must be finite and above 0"});
  detail::check_points_finite("grade", m);
  const box b = bounding_box(m);
  if (!b.is_empty() && !is_finite(b.max - b.min))
    throw invalid_mesh("grade: the size of the mesh exceeds the largest double; nothing was moved");
  std::vector<vec3> moved;
  for (const vert_t<M> v : verts(m)) {
    vec3 x = to_vec3(point(m, v));
    for (const std::size_t k : {0u, 1u, 2u}) {
      const double extent = b.max[k] - b.min[k];
      if (powers[k] == 1 || !(extent > 0) || x[k] == b.max[k]) continue;
      x[k] = b.min[k] + extent * std::pow((x[k] - b.min[k]) / extent, powers[k]);
    }
    moved.push_back(x);
  }
  std::size_t k = 0;
  for (const vert_t<M> v : verts(m)) set_point(m, v, moved[k++]);
}

// What to write instead of calls that cannot compile.
template<class... T> void grade(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void grade(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
