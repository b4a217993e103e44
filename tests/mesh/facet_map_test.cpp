#include <concino/mesh/facet_map.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/maps.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> concept has_facet_maps = requires { make_facet_map<double>(std::declval<M>(), 0.0); };

}  // namespace

TEST_CASE_TEMPLATE("facet maps: have a value per edge of a surface, per face of a volume", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  auto count = make_facet_map<int>(m);
  static_assert(std::same_as<decltype(count), facet_map<const M&, int>> && WritableMap<decltype(count), facet_t<M>, int>);
  static_assert(has_facet_maps<const M&> && !has_facet_maps<M>);
  CHECK(count.values().size() == facet_index_bound(m));
  for (const auto p : polys(m))
    for (const auto x : adj_p2facet(m, p)) ++count[x];
  for (const auto x : facets(m)) CHECK((count[x] == 1) == is_boundary(m, x));
  const auto weak = only_mesh(m);
  const auto same = make_facet_map<double>(weak, 2.5);
  for (const auto x : facets(weak)) CHECK(same[x] == 2.5);
  static_assert(has_facet_maps<decltype(weak)> && !has_facet_maps<decltype(only_primal_graph(m))&>);
}
