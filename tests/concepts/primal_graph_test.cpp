// PrimalGraph requires six members of mesh_traits. It is false for other types, never an error.
#include <concino/concepts/primal_graph.hpp>

#include <support/models.hpp>

#include <doctest/doctest.h>

#include <array>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {
struct ring_graph { unsigned n = 0; };
}  // namespace

template<>
struct concino::mesh_traits<ring_graph> {
  using vert = vert_id;
  static id_range<vert_id> verts(const ring_graph& g) { return id_range<vert_id>(g.n); }
  static unsigned num_verts(const ring_graph& g) { return g.n; }
  static unsigned vert_index_bound(const ring_graph& g) { return g.n; }
  static unsigned index_of(const ring_graph&, vert_id v) { return v.raw(); }
  static std::array<vert_id, 2> adj_v2v(const ring_graph& g, vert_id v) {
    return {vert_id{(v.raw() + 1) % g.n}, vert_id{(v.raw() + g.n - 1) % g.n}};
  }
};

namespace {
static_assert(models_in_all_forms<ring_graph>(cn::testing::primal_graph));

// Ranges of other types are rejected here, missing members in tests/must_not_compile/explain.
struct wrong_range : ring_graph {};
struct wrong_count : ring_graph {};
}  // namespace
template<>
struct concino::mesh_traits<wrong_range> : mesh_traits<ring_graph> {
  static std::array<unsigned, 2> adj_v2v(const ring_graph&, vert_id) { return {}; }
};
template<>
struct concino::mesh_traits<wrong_count> : mesh_traits<ring_graph> {
  static vert_id num_verts(const ring_graph&) { return {}; }
};
static_assert(models_in_all_forms<wrong_range>(cn::testing::nothing) && models_in_all_forms<wrong_count>(cn::testing::nothing));

TEST_CASE("a user's struct for a ring of verts models PrimalGraph") {
  cn::explain_primal_graph<ring_graph>();
  const ring_graph g{5};
  std::size_t n = 0;
  for (auto v : cn::verts(g))
    for (auto w : cn::adj_v2v(g, v)) n += cn::index_of(g, w);
  CHECK(n == 20);
}
