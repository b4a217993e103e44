// The constants that turn the integral of the gradient of heat geodesics into distances.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The integral of the gradient is known up to a constant in each component, and it is too round at a source. The
/// constant is fitted to bounds of the distances near the sources; tighter bounds have more weight.
///
/// Verts are used up to `near` times `decay` from a source, if the path over the mesh is longer than the straight line
/// by at most `max_doubt` of it. The numbers are not round, as those of regular grids are: rounding must not decide
/// which verts are used. Where the distance from the nearest source is only rounding, as at the corners of a square
/// around a source in its centre, verts are not used. Where no vert is used, the distance at the sources is right.
class distance_constants {
  static constexpr double near = 2 + 1e-6, max_doubt = 0.2 + 1e-6, rounding = 1e-6;

  double decay_;
  std::vector<double> sum_, weight_, sum_at_sources_, sources_;  // by component

 public:
  /// decay: the root of the time.
  distance_constants(std::size_t components, double decay)
      : decay_(decay), sum_(components), weight_(components), sum_at_sources_(components), sources_(components) {}

  /// Paths that are longer are not used.
  static double longest_path(double decay) { return (1 + max_doubt) * near * decay; }

  /// A vert: its straight distance from the sources, the length of the path, and the least initial distance in its
  /// component.
  void add(std::size_t component, double straight, double path, double least, double mass, double potential) {
    const double off = straight - least, doubt = path - straight;
    if (!(off > rounding * decay_ && off <= near * decay_ && doubt <= max_doubt * off)) return;
    const double trust = off / (doubt + 0.01 * off), w = mass * trust * trust;
    sum_[component] += w * (straight + doubt / 2 - potential);
    weight_[component] += w;
  }
  void add_source(std::size_t component, double path, double potential) {
    sum_at_sources_[component] += path - potential;
    sources_[component] += 1;
  }
  /// Calls f(sums) for all sums by component, for example to add those of other processes.
  template<class F>
  void for_each_sum(F f) {
    f(sum_), f(weight_), f(sum_at_sources_), f(sources_);
  }

  double operator()(std::size_t component) const {
    return weight_[component] > 0 ? sum_[component] / weight_[component]
                                  : sum_at_sources_[component] / sources_[component];
  }
};

}  // namespace concino::detail
