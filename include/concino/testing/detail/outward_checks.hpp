// Checks face_is_outward by the points: it says which side of a face is inside, and a poly has a positive volume.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/outward_vector.hpp>
#include <concino/testing/detail/adjacencies.hpp>

#include <string>
#include <vector>

namespace concino::testing::detail {

/// KIT7: a third of the sum of centroid times outward vector over the faces of each poly, which is its volume, is
/// positive. At most four findings.
template<VolumeMesh M, class Finding>
  requires Embedded<M>
void check_outward(const M& m, const std::string& state, std::vector<Finding>& findings) {
  std::size_t count = 0;
  for (const poly_t<M> p : polys(m)) {
    const vec3 origin = vert_mean(m, p);
    double sum = 0;
    for (const face_t<M> f : adj_p2f(m, p)) {
      vec3 centre;
      double n = 0;
      for (const vert_t<M> v : adj_f2v(m, f)) centre += to_vec3(point(m, v)) - origin, ++n;
      sum += dot(centre / n, outward_vector(m, p, f));
    }
    if (sum > 0) continue;
    if (count++ == 4) return;
    const std::string witness = name('p', index_of(m, p));
    findings.push_back({"KIT7", state,
                        concino::core::joined(
                            {"the volume of ", witness, ", computed from its faces as face_is_outward turns them, is ",
                             core::number_text(sum / 3),
                             ", not positive: face_is_outward is wrong, or the data (then see turned_polys)"}),
                        witness});
  }
}

}  // namespace concino::testing::detail
