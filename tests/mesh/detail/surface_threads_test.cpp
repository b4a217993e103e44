#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

using cn::testing::with_num_threads;

/// All adjacencies of a surface, and how its lists end.
template<class M>
std::vector<unsigned> lists(const cn::surface_arrays& arrays, int threads) {
  const with_num_threads fixed(threads);
  const M m(arrays);
  std::vector<unsigned> all;
  const auto add = [&](const auto& list) {
    for (const auto x : list) all.push_back(x.raw());
    all.push_back(~0u);
  };
  for (const auto v : cn::verts(m)) add(cn::adj_v2v(m, v)), add(cn::adj_v2e(m, v)), add(cn::adj_v2p(m, v));
  for (const auto e : cn::edges(m)) add(cn::adj_e2v(m, e)), add(cn::adj_e2p(m, e));
  for (const auto p : cn::polys(m)) add(cn::adj_p2v(m, p)), add(cn::adj_p2e(m, p)), add(cn::adj_p2p(m, p));
  return all;
}

/// A grid of more than 50,000 corners, whose verts have random numbers.
template<class M>
cn::surface_arrays large_grid(std::mt19937& random) {
  cn::surface_arrays a = cn::testing::grid_arrays<M>(130);
  REQUIRE(a.verts.size() > 50'000);  // smaller ones are built in one thread
  std::vector<unsigned> number(a.points.size());
  for (unsigned v = 0; v < number.size(); ++v) number[v] = v;
  std::shuffle(number.begin(), number.end(), random);
  for (cn::vert_id& v : a.verts) v = cn::vert_id{number[v.raw()]};
  return a;
}

/// The first corner of a poly.
template<class M>
std::size_t corner(const cn::surface_arrays& a, std::size_t poly) {
  if (cn::arity_v<M> > 0) return poly * cn::arity_v<M>;
  return a.offsets[poly];
}

template<class M>
void add_poly(cn::surface_arrays& a, std::vector<cn::vert_id> verts) {
  a.verts.insert(a.verts.end(), verts.begin(), verts.end());
  if (cn::arity_v<M> == 0) a.offsets.push_back(static_cast<unsigned>(a.verts.size()));
}

}  // namespace

TEST_CASE_TEMPLATE("surfaces: the same for any number of threads", M, cn::trimesh, cn::quadmesh, cn::polygonmesh) {
  std::mt19937 random(1);
  cn::surface_arrays a = large_grid<M>(random);
  CHECK(lists<M>(a, 1) == lists<M>(a, 2));
  if (cn::arity_v<M> == 0) {
    std::vector<cn::vert_id> many;  // too many for a search
    for (unsigned v = 0; v < 100; ++v) many.push_back(cn::vert_id{v * 17});
    add_poly<M>(a, many);
    CHECK(lists<M>(a, 1) == lists<M>(a, 2));
  }
  std::vector<cn::vert_id> other(a.verts.data() + corner<M>(a, 5000), a.verts.data() + corner<M>(a, 5001));
  add_poly<M>(a, other);  // covers another one: both polys have one neighbour behind several edges
  std::reverse(other.begin(), other.end());
  CHECK(lists<M>(a, 1) == lists<M>(a, 2));
  add_poly<M>(a, other);  // edges of three polys
  CHECK(lists<M>(a, 1) == lists<M>(a, 2));
}

TEST_CASE_TEMPLATE("surfaces: errors name the first bad poly for any number of threads", M, cn::trimesh, cn::quadmesh, cn::polygonmesh) {
  std::mt19937 random(2);
  cn::surface_arrays a = large_grid<M>(random);
  a.verts[corner<M>(a, 9000)] = cn::vert_id{1'000'000};
  a.verts[corner<M>(a, 9001)] = a.verts[corner<M>(a, 9001) + 1];
  a.verts[corner<M>(a, 10000)] = cn::vert_id{2'000'000};
  for (const int threads : {1, 2}) {
    const with_num_threads fixed(threads);
    CHECK_THROWS_WITH_AS(M{a}, doctest::Contains("poly 9000 names vert 1000000"), cn::invalid_mesh);
  }
}
