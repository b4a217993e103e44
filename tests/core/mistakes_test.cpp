#include <concino/core/mistakes.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/io/field.hpp>
#include <concino/mesh/trimesh.hpp>

#include <doctest/doctest.h>

#include <string>
#include <type_traits>
#include <vector>

namespace cn = concino;

namespace {

struct foreign {};
using pure_mesh = std::remove_cvref_t<decltype(cn::only_surface_mesh(std::declval<const cn::trimesh&>()))>;
using pure_vert = cn::vert_t<pure_mesh>;
using mesh = const cn::trimesh&;

// A requires-expression can check these calls without an error: deleted functions make it false.
template<class M, class S> concept can_dijkstra = requires(M&& m, const S& s) { cn::dijkstra(static_cast<M&&>(m), s); };
template<class M, class S> concept can_dijkstra_by_ones = requires(M&& m, const S& s) { cn::dijkstra(static_cast<M&&>(m), s, [](auto, auto) { return 1.0; }); };
template<class M, class S> concept can_bfs = requires(M&& m, const S& s) { cn::bfs(static_cast<M&&>(m), {s, s}, {.max_hops = 2}); };
template<class M, class S> concept can_harmonic = requires(M&& m, const S& s) { cn::harmonic_map(static_cast<M&&>(m), {{s, 1.0}}, {.exponent = 2}); };
template<class M> concept can_verts = requires(M&& m) { cn::verts(m); };
template<class M> concept can_map = requires(M&& m) { cn::make_vert_map<double>(static_cast<M&&>(m)); };
template<class M, class P> concept can_measure = requires(M&& m, const P& p) { cn::measure(static_cast<M&&>(m), p); };
template<class M, class U> concept can_save = requires(M&& m, const U& u) { cn::save_field(u, static_cast<M&&>(m), std::string()); };

static_assert(can_dijkstra<mesh, cn::vert_id> && can_dijkstra<mesh, std::vector<cn::poly_id>>);
static_assert(!can_dijkstra<const foreign&, cn::vert_id> && !can_dijkstra<cn::trimesh, cn::vert_id> && !can_dijkstra<mesh, int>);
static_assert(!can_dijkstra<mesh, std::vector<int>> && !can_dijkstra<mesh, cn::edge_id>);
static_assert(!can_dijkstra<const pure_mesh&, pure_vert> && can_dijkstra_by_ones<const pure_mesh&, pure_vert> && can_dijkstra_by_ones<pure_mesh, pure_vert>);
static_assert(can_bfs<mesh, cn::vert_id> && !can_bfs<const foreign&, cn::vert_id> && !can_bfs<mesh, int> && !can_bfs<cn::trimesh, cn::vert_id>);
static_assert(can_harmonic<mesh, cn::vert_id> && !can_harmonic<const foreign&, cn::vert_id> && !can_harmonic<mesh, int> && !can_harmonic<cn::trimesh, cn::vert_id>);
static_assert(can_verts<mesh> && can_verts<cn::trimesh> && !can_verts<const foreign&> && !can_verts<int>);
static_assert(can_map<mesh> && can_map<pure_mesh> && !can_map<cn::trimesh> && !can_map<const foreign&> && !can_map<int>);
static_assert(can_measure<mesh, cn::poly_id> && can_measure<cn::trimesh, cn::poly_id> && !can_measure<mesh, int> && !can_measure<const foreign&, int>);
static_assert(can_save<mesh, cn::vert_map<cn::trimesh, float>> && can_save<mesh, cn::poly_map<cn::trimesh, cn::vec3>> && !can_save<mesh, cn::edge_map<cn::trimesh, double>>);
static_assert(!can_save<mesh, cn::vert_map<cn::trimesh, std::string>> && !can_save<const foreign&, cn::vert_map<cn::trimesh, double>>);

// Options and values of wrong types are rejected too, before the body is compiled.
inline constexpr auto always = [](auto) { return true; };
using graph = std::remove_cvref_t<decltype(cn::only_primal_graph(std::declval<const cn::trimesh&>()))>;
template<class M> concept can_cross = requires(const M& m, const cn::vert_t<M>& v) { cn::bfs(m, v, {.may_cross = always}); };
template<class M> concept can_cross_by_length = requires(const M& m, const cn::vert_t<M>& v) {
  cn::dijkstra(m, v, [](auto, auto) { return 1.0; }, {.may_cross = always});
};
template<class M> concept can_enter = requires(const M& m, const cn::vert_t<M>& v) { cn::bfs(m, v, {.may_enter = always}); };
static_assert(can_cross<cn::trimesh> && can_cross_by_length<cn::trimesh> && can_enter<cn::trimesh> && can_enter<graph>);
static_assert(!can_cross<graph> && !can_cross_by_length<graph>);
template<class D> concept can_prescribe = requires(mesh m, const D& values) { cn::harmonic_map(m, values); };
template<class V> concept can_prepare = requires(mesh m, const V& fixed) { cn::prepare_harmonic_map(m, fixed); };
static_assert(can_prescribe<std::vector<std::pair<cn::vert_id, double>>> && !can_prescribe<std::vector<std::pair<cn::poly_id, double>>>);
static_assert(!can_prescribe<std::vector<cn::vert_id>> && !can_prescribe<cn::harmonic_map_options> && !can_prescribe<int>);
static_assert(can_prepare<std::vector<cn::vert_id>> && !can_prepare<std::vector<cn::poly_id>> && !can_prepare<cn::vert_id>);

// A user's function that accepts the call is preferred, wherever it is declared: vec3 makes the names of concino visible.
struct base {};
struct derived : base {};
double measure(const base&, const cn::vec3&) { return 7; }

// A mesh whose descriptors are plain numbers accepts numbers.
struct cycle { int n; };

}  // namespace

template<>
struct concino::mesh_traits<cycle> {
  struct numbers {
    int n;
    struct iterator {
      int i;
      int operator*() const { return i; }
      iterator& operator++() { return ++i, *this; }
      bool operator!=(iterator o) const { return i != o.i; }
    };
    iterator begin() const { return {0}; }
    iterator end() const { return {n}; }
  };
  struct two {
    int values[2];
    const int* begin() const { return values; }
    const int* end() const { return values + 2; }
  };
  using vert = int;
  static numbers verts(const cycle& c) { return {c.n}; }
  static std::size_t num_verts(const cycle& c) { return static_cast<std::size_t>(c.n); }
  static std::size_t vert_index_bound(const cycle& c) { return static_cast<std::size_t>(c.n); }
  static std::size_t index_of(const cycle&, int v) { return static_cast<std::size_t>(v); }
  static two adj_v2v(const cycle& c, int v) { return {{(v + 1) % c.n, (v + c.n - 1) % c.n}}; }
};

// Incomplete traits. What has all members of a graph, or of a mesh, is not incomplete.
namespace {
struct half_cycle {};
struct no_surface {};
}  // namespace
template<>
struct concino::mesh_traits<half_cycle> { using vert = int; };
template<>
struct concino::mesh_traits<no_surface> : mesh_traits<cycle> { [[maybe_unused]] static constexpr int dimension = 2; };
template<class M> inline constexpr bool is_incomplete = cn::requirement::is_incomplete<M>;
static_assert(is_incomplete<half_cycle> && is_incomplete<const half_cycle&> && is_incomplete<no_surface>);
static_assert(!is_incomplete<foreign> && !is_incomplete<int> && !is_incomplete<cycle>);
static_assert(!is_incomplete<mesh> && !is_incomplete<pure_mesh> && !is_incomplete<graph>);
static_assert(!is_incomplete<decltype(cn::only_dual_graph(std::declval<mesh>()))> && !is_incomplete<decltype(cn::dual(std::declval<mesh>()))>);
static_assert(!can_bfs<const half_cycle&, int> && !can_bfs<half_cycle, int> && !can_measure<const half_cycle&, int> && !can_harmonic<const no_surface&, int>);

TEST_CASE("mistakes: a viable function is preferred to the deleted overloads") {
  CHECK(measure(derived{}, cn::vec3{}) == 7);
  const cycle c{6};
  CHECK(cn::bfs(c, 0)[3] == 3);
  CHECK(cn::bfs(c, {0, 2})[4] == 2);
  CHECK(cn::dijkstra(c, 0, [](int, int) { return 2.0; })[2] == 4);
}

TEST_CASE("mistakes: a sentence keeps its text") {
  constexpr cn::mistake::sentence s("give it a name");
  CHECK(std::string(s.text) == "give it a name");
}
