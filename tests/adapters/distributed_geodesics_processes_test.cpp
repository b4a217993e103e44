// Heat geodesics on distributed meshes equal those of one process, on any partition. Every test also passes on one
// process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_heat_geodesics.hpp>

#include <concino/fields/heat_geodesics.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template<class M>
using sources_of = std::vector<std::pair<vert_t<M>, double>>;

/// The sources of the whole mesh among the verts of this process.
template<class M>
sources_of<distributed<M>> own_sources(const distributed<M>& d, const sources_of<M>& sources) {
  sources_of<distributed<M>> own;
  for (const auto v : verts(d))
    for (const auto& [w, x] : sources)
      if (d.global_number(v) == w.raw() && !d.is_ghost(v)) own.emplace_back(v, x);
  return own;
}

/// The largest difference at local verts, relative to the largest distance.
template<class M>
double difference(const M& m, const vert_map<distributed<M>, double>& found, const vert_map<M, double>& expected) {
  double worst = 0, largest = 0;
  for (const double x : expected.values())
    if (x < infinity) largest = std::max(largest, x);
  for (const auto v : verts(found.mesh())) {
    const double x = found[v], y = expected[vert_at(m, found.mesh().global_number(v))];
    if (x != y) worst = std::max(worst, std::abs(x - y));
  }
  return worst / largest;
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: heat geodesics equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const unsigned last = static_cast<unsigned>(num_verts(m) - 1);
  const sources_of<M> all_sources[] = {{{vert_t<M>{1}, 0.0}}, {{vert_t<M>{2}, 0.25}, {vert_t<M>{7}, 0.0}, {vert_t<M>{last - 2}, 1.0}, {vert_t<M>{last}, 0.0}}};
  for (const auto& sources : all_sources) {
    const auto expected = heat_geodesics(m, sources, {}, ldlt());
    for (const auto& part : parts_of(m)) {
      const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
      const auto own = own_sources(d, sources);
      CHECK(difference(m, heat_geodesics(d, own, {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
      CHECK(difference(m, heat_geodesics(d, own), expected) < 1e-4);
    }
  }
}
