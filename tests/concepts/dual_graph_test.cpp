// A type with only polys models DualGraph.
#include <concino/concepts/dual_graph.hpp>

#include <support/models.hpp>

#include <doctest/doctest.h>

#include <array>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {
struct chain { unsigned n = 0; };  // polys in pairs of neighbours: 0-1 2-3 ...
}  // namespace

template<>
struct concino::mesh_traits<chain> {
  using poly = poly_id;
  static id_range<poly_id> polys(const chain& c) { return id_range<poly_id>(c.n); }
  static unsigned num_polys(const chain& c) { return c.n; }
  static unsigned poly_index_bound(const chain& c) { return c.n; }
  static unsigned index_of(const chain&, poly_id p) { return p.raw(); }
  static std::array<poly_id, 1> adj_p2p(const chain&, poly_id p) { return {poly_id{p.raw() ^ 1u}}; }
};
static_assert(models_in_all_forms<chain>(cn::testing::dual_graph));

TEST_CASE("a user's struct for pairs of polys models DualGraph") {
  cn::explain_dual_graph<const chain&>();
  const chain c{4};
  std::size_t n = 0;
  for (auto p : cn::polys(c))
    for (auto q : cn::adj_p2p(c, p)) n = 10 * n + cn::index_of(c, q);
  CHECK(n == 1032);
}
