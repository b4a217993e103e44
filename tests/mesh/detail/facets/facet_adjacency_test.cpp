// The neighbours of polys that share several facets, or facets with many polys.
#include <concino/mesh/detail/facets/facet_adjacency.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

using namespace concino;
using concino::detail::encoded_neighbour;
using concino::detail::make_jagged_array;
using concino::detail::facet_adjacency;

namespace {

using list = std::vector<unsigned>;

/// Checks that the neighbours of each poly p, which has the facets polys[p], are all polys with a common facet, each once.
void are_right(const std::vector<list>& polys, bool first_is_known) {
  detail::offsets lengths{0};
  unsigned facets = 0;
  for (const list& p : polys) {
    lengths.push_back(static_cast<std::uint32_t>(p.size()));
    for (const unsigned f : p) facets = std::max(facets, f + 1);
  }
  facet_adjacency<edge_id, 0> all(make_jagged_array<edge_id>(lengths), make_jagged_array<encoded_neighbour>(lengths));
  for (unsigned f = 0; f < facets; ++f) all.add_facet();
  std::vector<facet_adjacency<edge_id, 0>::incidence> first_incidence(facets);
  for (unsigned p = 0; p < polys.size(); ++p)
    for (unsigned k = 0; k < polys[p].size(); ++k) {
      const edge_id f{polys[p][k]};
      if (first_is_known && all.is_owned(f)) {
        all.link(p, k, f, first_incidence[f.raw()]);
      } else {
        first_incidence[f.raw()] = {p, k};
        all.link(p, k, f);
      }
    }
  all.finish();
  for (unsigned p = 0; p < polys.size(); ++p) {
    std::set<unsigned> expected;
    for (unsigned q = 0; q < polys.size(); ++q)
      for (const unsigned f : polys[q])
        if (p != q && std::count(polys[p].begin(), polys[p].end(), f)) expected.insert(q);
    std::vector<unsigned> found;
    for (const poly_id q : all.polys(poly_id{p})) found.push_back(q.raw());
    std::vector<unsigned> called;
    all.polys(poly_id{p}).for_each([&](poly_id q) { called.push_back(q.raw()); });
    CHECK(called == found);
    std::sort(found.begin(), found.end());
    CHECK(found == std::vector<unsigned>(expected.begin(), expected.end()));
  }
}

void are_right(const std::vector<list>& polys) {
  are_right(polys, false);
  are_right(polys, true);
}

list numbers(unsigned first, unsigned n) {
  list r;
  for (unsigned i = 0; i < n; ++i) r.push_back(first + i);
  return r;
}

}  // namespace

TEST_CASE("facet_adjacency: finds neighbours that share one facet or several, also of large polys") {
  for (const unsigned n : {3u, 6u, 24u, 25u, 40u, 80u}) {
    const list ring = numbers(0, n), apart = numbers(n, n);
    list one = apart, two = apart, first_two = apart, last_two = apart;
    one[1] = 0;
    two[0] = 0, two[2] = 2;
    first_two[0] = 1, first_two[1] = 0;
    last_two[n - 1] = n - 1, last_two[n - 2] = n - 2;
    for (const list& other : {apart, one, two, first_two, last_two, ring}) {
      are_right({ring, other});
      are_right({other, ring});
    }
  }
}

TEST_CASE("facet_adjacency: two of three polys at a facet may share another facet") {
  for (const unsigned n : {4u, 30u, 80u}) {
    const list ring = numbers(0, n);
    list a = numbers(100, n), b = numbers(200, n), again = b, c = numbers(300, n);
    a[0] = b[0] = again[0] = 1;
    again[n - 1] = n - 1;
    c[0] = n - 2;
    are_right({ring, a, b});
    are_right({ring, a, again});
    are_right({again, a, ring});
    // the number of a facet with three polys is not taken for a poly
    are_right({c, ring, a, b});
    are_right({c, a, ring, b});
    are_right({c, a, ring, again});
  }
}

TEST_CASE("facet_adjacency: boundary facets may lie between facets to the same poly") {
  const list ring = numbers(0, 40);
  list every_other = numbers(100, 40);
  for (unsigned i = 0; i < 40; i += 2) every_other[i] = i;
  are_right({ring, every_other});
  are_right({every_other, ring});
}

TEST_CASE("facet_adjacency: neighbours at random non-manifold facets are right") {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    // few facets for many polys: nearly every facet is non-manifold, and their polys overlap
    const unsigned facet_count = round % 3 == 0 ? 8 : round % 3 == 1 ? 60 : 400, count = 2 + static_cast<unsigned>(random() % 30);
    std::vector<list> lists;
    for (unsigned p = 0; p < count; ++p) {
      list all = numbers(0, facet_count);
      std::shuffle(all.begin(), all.end(), random);
      all.resize(std::min<std::size_t>(facet_count, 3 + random() % (round % 2 ? 6 : 90)));
      lists.push_back(random() % 4 == 0 && p > 0 ? lists.back() : all);
    }
    are_right(lists);
  }
}

TEST_CASE("facet_adjacency: equal polys are neighbours, with and without others at their facets") {
  for (const unsigned n : {3u, 9u, 30u, 90u})
    for (const unsigned copies : {2u, 3u, 20u}) {
      std::vector<list> lists(copies, numbers(0, n));
      are_right(lists);
      for (unsigned f = 0; f < n; ++f) lists.push_back({f, n + 2 * f, n + 2 * f + 1});
      are_right(lists);
    }
}
