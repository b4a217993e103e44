// Sums and extremes over distributed meshes: total_measure(d), statistics(d, u).
// Needs: MPI (Debian: petsc-dev brings it; libopenmpi-dev).
#pragma once

#include <concino/adapters/distributed.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/fields/statistics.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

/// What statistics of a distributed mesh returns, as field_statistics: of all processes, and the same on each.
struct distributed_statistics {
  double min = 0, max = 0;               // 0 if no value is finite
  std::uint64_t min_at = 0, max_at = 0;  // global numbers of where these are, the first of several
  double mean = 0;                       // weighted by areas or volumes
  double deviation = 0;                  // the root of the mean of the squares of differences to the mean
  double integral = 0;                   // in units of u times area or volume
  std::uint64_t count = 0;               // of finite values
  std::uint64_t not_finite = 0;          // how many are infinite or not a number; they are left out
};

namespace detail {

/// An extreme value, and the number of the element that has it.
struct extreme {
  double value;
  std::uint64_t number;
};

/// The least value of all processes, the lowest number of several.
inline extreme min_over_processes(extreme own, MPI_Comm communicator) {
  double value = own.value;
  (MPI_Allreduce)(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MIN, communicator);
  std::uint64_t number = own.value == value ? own.number : std::numeric_limits<std::uint64_t>::max();
  (MPI_Allreduce)(MPI_IN_PLACE, &number, 1, MPI_UINT64_T, MPI_MIN, communicator);
  return {value, number};
}

/// weight(x) of the elements that belong to this process.
template<class M, class Elements, class U, class Weight>
distributed_statistics gather_over_processes(const distributed<M>& m, const Elements& elements, const U& u,
                                             const Weight& weight) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  extreme low{infinity, 0}, high{infinity, 0};
  std::uint64_t counts[] = {0, 0};
  std::vector<double> values, weights;
  for (const auto x : elements) {
    if (m.is_ghost(x)) continue;
    const double value = static_cast<double>(u[x]);
    ++counts[std::isfinite(value) ? 0 : 1];
    if (!std::isfinite(value)) continue;
    if (value < low.value || (value == low.value && m.global_number(x) < low.number)) low = {value, m.global_number(x)};
    if (-value < high.value || (-value == high.value && m.global_number(x) < high.number))
      high = {-value, m.global_number(x)};
    values.push_back(value);
    weights.push_back(weight(x));
  }
  const MPI_Comm all = m.communicator();
  (MPI_Allreduce)(MPI_IN_PLACE, counts, 2, MPI_UINT64_T, MPI_SUM, all);
  distributed_statistics r;
  r.count = counts[0], r.not_finite = counts[1];
  if (r.count == 0) return r;
  low = min_over_processes(low, all), high = min_over_processes(high, all);
  r.min = low.value, r.min_at = low.number, r.max = -high.value, r.max_at = high.number;
  double total_weight = 0;
  for (const double w : weights) total_weight += w;
  (MPI_Allreduce)(MPI_IN_PLACE, &total_weight, 1, MPI_DOUBLE, MPI_SUM, all);
  const bool is_weighted = total_weight > 0 && std::isfinite(total_weight);
  const double whole = is_weighted ? total_weight : static_cast<double>(r.count);
  double sum = 0, squares = 0;  // of differences to the least value, then to the mean: large constants lose no digits
  for (std::size_t k = 0; k < values.size(); ++k) sum += (is_weighted ? weights[k] : 1) * (values[k] - r.min);
  (MPI_Allreduce)(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, all);
  r.mean = r.min + sum / whole;
  for (std::size_t k = 0; k < values.size(); ++k)
    squares += (is_weighted ? weights[k] : 1) * (values[k] - r.mean) * (values[k] - r.mean);
  (MPI_Allreduce)(MPI_IN_PLACE, &squares, 1, MPI_DOUBLE, MPI_SUM, all);
  r.deviation = std::sqrt(squares / whole);
  r.integral = is_weighted ? r.mean * total_weight : 0;
  return r;
}

}  // namespace detail

/// total_measure of the whole mesh. All its processes call it together.
/// Needs:  a distributed mesh.
/// Result: the sum of the measures of all polys, each counted once; the same on every process.
/// Cost:   O(size of the part) time, and one sum over the processes.
/// Errors: none.
template<class M>
double total_measure(const distributed<M>& m) {
  double sum = total_measure(owned_part(m));
  (MPI_Allreduce)(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, m.communicator());
  return sum;
}

/// statistics of the whole mesh. All its processes call it together.
/// Needs:  a distributed mesh; u[v] is a number for each of its local verts, or u[p] for each of its local polys. Those
///         of ghosts are not read.
/// Result: see distributed_statistics; the same on every process.
/// Cost:   O(size of the part) time, and some sums over the processes.
/// Errors: those of vert_masses, for values at verts, thrown on all processes.
template<class M, class U>
  requires requirement::gives_numbers<U, vert_t<M>> distributed_statistics statistics(const distributed<M>& m,
                                                                                      const U& u) {
    auto mass = make_vert_map<double>(m, 0.0);
    detail::on_all(m.communicator(), [&] {
      const auto part = owned_part(m);
      const auto of_part = vert_masses(part);
      for (const vert_t<M> v : verts(part)) mass[v] = of_part[v];
    });
    m.exchange(static_cast<const vert_t<M>*>(nullptr)).to_owners(mass.data(), [](double& sum, double x) { sum += x; });
    return detail::gather_over_processes(m, verts(m), u, [&](const vert_t<M>& v) { return mass[v]; });
  }
template<class M, class U>
  requires(requirement::gives_numbers<U, poly_t<M>> && !requirement::gives_numbers<U, vert_t<M>>)
distributed_statistics statistics(const distributed<M>& m, const U& u) {
  return detail::gather_over_processes(m, polys(m), u, [&](const poly_t<M>& p) { return std::abs(measure(m, p)); });
}

}  // namespace concino
