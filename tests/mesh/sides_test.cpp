// What lies across the sides of polys that share several sides, or sides with many polys.
#include <concino/mesh/sides.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace concino;
using concino::detail::across;
using concino::detail::make_rows;
using concino::detail::sides;

namespace {

using list = std::vector<unsigned>;

/// polys[p] are the facets of poly p.
struct linked {
  sides<edge_id, 0> all;
  bool repeats = false;

  explicit linked(const std::vector<list>& polys) {
    detail::offsets lengths{0};
    unsigned facets = 0;
    for (const list& p : polys) {
      lengths.push_back(static_cast<std::uint32_t>(p.size()));
      for (const unsigned f : p) facets = std::max(facets, f + 1);
    }
    all = {make_rows<edge_id>(lengths), make_rows<across>(lengths)};
    for (unsigned f = 0; f < facets; ++f) all.add_facet();
    for (unsigned p = 0; p < polys.size(); ++p)
      for (unsigned k = 0; k < polys[p].size(); ++k) all.link(p, k, edge_id{polys[p][k]});
    repeats = all.finish();
  }
};

/// The polys across each side are those with a facet in common, each once.
void are_right(const sides<edge_id, 0>& all, const std::vector<list>& polys) {
  for (unsigned p = 0; p < polys.size(); ++p) {
    std::set<unsigned> expected;
    for (unsigned q = 0; q < polys.size(); ++q)
      for (const unsigned f : polys[q])
        if (p != q && std::count(polys[p].begin(), polys[p].end(), f)) expected.insert(q);
    std::vector<unsigned> found;
    for (const poly_id q : all.polys(poly_id{p})) found.push_back(q.raw());
    std::sort(found.begin(), found.end());
    CHECK(found == std::vector<unsigned>(expected.begin(), expected.end()));
  }
}

list numbers(unsigned first, unsigned n) {
  list r;
  for (unsigned i = 0; i < n; ++i) r.push_back(first + i);
  return r;
}

}  // namespace

TEST_CASE("sides: it is known whether some poly meets another across two sides, of polys with few sides and with many") {
  for (const unsigned n : {3u, 6u, 24u, 25u, 40u}) {
    const list ring = numbers(0, n), apart = numbers(n, n);
    list one = apart, two = apart, first_two = apart, last_two = apart;
    one[1] = 0;
    two[0] = 0, two[2] = 2;
    first_two[0] = 1, first_two[1] = 0;
    last_two[n - 1] = n - 1, last_two[n - 2] = n - 2;
    for (const list& other : {apart, one}) {
      CHECK_FALSE(linked({ring, other}).repeats);
      are_right(linked({ring, other}).all, {ring, other});
    }
    for (const list& other : {two, first_two, last_two, ring}) {
      CHECK(linked({ring, other}).repeats);
      are_right(linked({ring, other}).all, {ring, other});
      CHECK(linked({other, ring}).repeats);
      are_right(linked({other, ring}).all, {other, ring});
    }
  }
}

TEST_CASE("sides: three polys at a facet repeat nothing, unless two of them meet again") {
  for (const unsigned n : {4u, 30u}) {
    const list ring = numbers(0, n);
    list a = numbers(100, n), b = numbers(200, n), again = b;
    a[0] = b[0] = again[0] = 1;
    again[n - 1] = n - 1;
    CHECK_FALSE(linked({ring, a, b}).repeats);
    are_right(linked({ring, a, b}).all, {ring, a, b});
    CHECK(linked({ring, a, again}).repeats);
    are_right(linked({ring, a, again}).all, {ring, a, again});
    // the number of a facet with three polys is no number of a poly
    list c = numbers(300, n);
    c[0] = n - 2;
    CHECK_FALSE(linked({c, ring, a, b}).repeats);
    are_right(linked({c, ring, a, b}).all, {c, ring, a, b});
    are_right(linked({c, a, ring, b}).all, {c, a, ring, b});
  }
}

TEST_CASE("sides: between the sides that lead to the same poly some lead nowhere") {
  const list ring = numbers(0, 40);
  list every_other = numbers(100, 40);
  for (unsigned i = 0; i < 40; i += 2) every_other[i] = i;
  are_right(linked({ring, every_other}).all, {ring, every_other});
  are_right(linked({every_other, ring}).all, {every_other, ring});
}
