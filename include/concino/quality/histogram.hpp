// Histograms of quality metrics, and how many polys a solver may not like.
#pragma once

#include <concino/quality/poly_quality.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

struct histogram_options {
  std::size_t bins = 10;                                     // >= 1
  double low = std::numeric_limits<double>::quiet_NaN();     // where the first bin begins; NaN: at the smallest finite
                                                             // value
  double high = std::numeric_limits<double>::quiet_NaN();    // where the last bin ends, >= low; NaN: at the largest
                                                             // finite value
  double mean_size = 0;                                      // as in quality_options
};

/// How the values of a metric are distributed. All counts together are the number of polys.
struct quality_histogram {
  double low = 0, high = 0;         // of all bins, which have the same width; a value between two bins belongs to the
                                    // upper one, `high` to the last one
  std::vector<std::size_t> counts;  // per bin
  std::size_t below = 0, above = 0;  // values less than low and greater than high, infinite ones among them
  std::size_t undefined = 0;        // NaN: polys with points that are not finite
  std::size_t unacceptable = 0;     // values that are not is_acceptable(what, shape of the poly, value), NaN among
                                    // them. They are counted above too
  double min_value = 0, max_value = 0;  // of the finite values; 0 if there are none
  double mean = 0;                  // likewise

  /// Where a bin begins.
  double start_of(std::size_t bin) const {
    return low + (high - low) * (static_cast<double>(bin) / static_cast<double>(counts.size()));
  }
};

namespace detail {

/// One poly of a histogram.
struct shaped_value {
  double value;
  poly_shape shape;
};
quality_histogram histogram_of(metric what, const std::vector<shaped_value>& values, const histogram_options& options);

}  // namespace detail

/// The histogram of a quality metric over all polys.
/// Needs:  EmbeddedMesh.
/// Result: see quality_histogram.      Cost: that of quality for every poly, parallel; 16 bytes per poly for the time
///         of the call.
/// Errors: invalid_argument if there are no bins, or low or high is infinite, or low > high; else as quality.
template<EmbeddedMesh M>
quality_histogram histogram(const M& m, metric what, const histogram_options& options = {}) {
  const detail::metric_rows rows(what);
  const double mean_size = detail::chosen_mean_size(m, rows, {options.mean_size});
  poly_map<M, detail::shaped_value> value(m, poly_index_bound(m), detail::shaped_value{});
  detail::for_each_quality(m, rows, mean_size, [&](const poly_t<M>& p, double q, poly_shape shape) {
    value[p] = {q, shape};
  });
  std::vector<detail::shaped_value> values;
  values.reserve(num_polys(m));
  for (const poly_t<M> p : polys(m)) values.push_back(value[p]);
  return detail::histogram_of(what, values, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void histogram(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void histogram(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/quality/detail/histogram.ipp>
#endif
