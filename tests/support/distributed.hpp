// What tests of distributed meshes share: processes, partitions, and elements by their number.
#pragma once

#include <concino/adapters/distributed.hpp>
#include <concino/adapters/metis_partition.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/temporary.hpp>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace distributed_tests {

inline int rank() {
  int r = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &r);
  return r;
}
inline int number_of_processes() {
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}
inline bool is_first() { return rank() == 0; }

inline double sum_of_all(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return x;
}

/// Native meshes without deleted elements number verts and polys by index.
template<class M, class X>
std::uint64_t number(const M& m, const X& x) { return concino::index_of(m, x); }
template<class M>
auto vert_at(const M&, std::uint64_t i) { return concino::vert_t<M>{static_cast<unsigned>(i)}; }
template<class M>
auto poly_at(const M&, std::uint64_t i) { return concino::poly_t<M>{static_cast<unsigned>(i)}; }

/// Partitions for this number of processes: by METIS; every n-th poly, so that parts are scattered; all polys on the last process; and slabs of equal
/// numbers of polys, which are thin on small grids.
template<class M>
std::vector<concino::poly_map<M, int>> parts_of(const M& m) {
  const auto n = static_cast<std::size_t>(number_of_processes());
  std::vector<concino::poly_map<M, int>> r(4, concino::make_poly_map<int>(m, 0));
  r[0] = concino::partition(m, n, concino::metis).part;
  std::size_t i = 0;
  for (const auto p : concino::polys(m)) {
    r[1][p] = static_cast<int>(i % n);
    r[2][p] = static_cast<int>(n - 1);
    r[3][p] = static_cast<int>(i * n / concino::num_polys(m));
    ++i;
  }
  return r;
}

inline double magnitude(double x) { return std::abs(x); }
inline double magnitude(const concino::vec3& x) { return concino::norm(x); }

/// Between a map of a distributed mesh and one of the whole mesh, at the verts of this process and its ghosts, relative to the largest value of the latter.
template<class M, class X, class T>
double largest_difference(const concino::element_map<concino::distributed<M>, X, T>& u, const concino::element_map<M, X, T>& expected) {
  double worst = 0, largest = 0;
  for (const auto v : concino::verts(expected.mesh())) largest = std::max(largest, magnitude(expected[v]));
  for (const auto v : concino::verts(u.mesh()))
    worst = std::max(worst, magnitude(u[v] - expected[vert_at(expected.mesh(), u.mesh().global_number(v))]));
  return worst / largest;
}

/// A folder that all processes see, from the first one. Its end waits for all of them.
class shared_folder {
  std::optional<concino::testing::temporary_folder> own_;
  std::string path_;

 public:
  shared_folder() {
    if (is_first()) path_ = own_.emplace().path();
    int length = static_cast<int>(path_.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    path_.resize(static_cast<std::size_t>(length));
    MPI_Bcast(path_.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
  }
  shared_folder(const shared_folder&) = delete;
  shared_folder& operator=(const shared_folder&) = delete;
  ~shared_folder() { MPI_Barrier(MPI_COMM_WORLD); }
  std::string operator/(const std::string& file) const { return path_ + "/" + file; }
};

}  // namespace distributed_tests
