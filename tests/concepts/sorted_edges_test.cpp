// adj_p2e and adj_f2e sort the edges if the traits define edges_in_order = false, and do not change them otherwise.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/concepts/views.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

/// A mesh that lists the edges of polys and faces in a random order, which depends on the seed.
template<class M>
struct shuffled : M {
  unsigned seed = 0;
};

struct tet_volume : user_mesh::volume {
  using volume::volume;
};
template<class M> struct in_order : M {};

template<class X>
std::vector<X> shuffle(std::vector<X> r, unsigned seed) {
  std::mt19937 random(seed);
  std::shuffle(r.begin(), r.end(), random);
  return r;
}

}  // namespace

template<>
struct concino::mesh_traits<tet_volume> : mesh_traits<user_mesh::volume> {
  static constexpr int arity = 4;
};
template<class M>
struct concino::mesh_traits<shuffled<M>> : mesh_traits<M> {
  using T = mesh_traits<M>;
  static auto adj_p2e(const shuffled<M>& m, typename T::poly p) { return shuffle(T::adj_p2e(m, p), m.seed); }
  static auto adj_f2e(const shuffled<M>& m, user_mesh::facet f) { return shuffle(T::adj_f2e(m, f), m.seed); }
};
template<>
struct concino::mesh_traits<in_order<user_mesh::surface>> : mesh_traits<user_mesh::surface> {
  static constexpr bool edges_in_order = true;
};


// Models with edges_in_order = false that lack a member needed for sorting: their concepts are false, and no errors.
enum class without { nothing, adj_p2v, adj_e2v, adj_v2e, adj_e2p, adj_f2v, adj_e2f };
template<without What, int Arity = 0> struct bare_polygons {};
template<without What> struct bare_faces {};
template<without What, int Arity>
struct concino::mesh_traits<bare_polygons<What, Arity>> {
  using M = bare_polygons<What, Arity>;
  using vert = user_mesh::vertex;
  using edge = user_mesh::segment;
  using poly = user_mesh::cell;
  static constexpr int dimension = Arity == 4 ? 3 : 2;
  static constexpr int arity = Arity;
  static constexpr bool edges_in_order = false;
  static std::array<edge, 6> adj_p2e(const M&, poly) { return {}; }
  static std::array<vert, 4> adj_p2v(const M&, poly) requires(What != without::adj_p2v) { return {}; }
  static std::array<vert, 2> adj_e2v(const M&, edge) requires(What != without::adj_e2v) { return {}; }
  static std::array<edge, 2> adj_v2e(const M&, vert) requires(What != without::adj_v2e) { return {}; }
  static std::array<poly, 2> adj_e2p(const M&, edge) requires(What != without::adj_e2p) { return {}; }
};
template<without What>
struct concino::mesh_traits<bare_faces<What>> {
  using M = bare_faces<What>;
  using vert = user_mesh::vertex;
  using edge = user_mesh::segment;
  using face = user_mesh::facet;
  static constexpr int dimension = 3;
  static constexpr bool edges_in_order = false;
  static std::array<edge, 4> adj_f2e(const M&, face) { return {}; }
  static std::array<vert, 4> adj_f2v(const M&, face) requires(What != without::adj_f2v) { return {}; }
  static std::array<vert, 2> adj_e2v(const M&, edge) requires(What != without::adj_e2v) { return {}; }
  static std::array<edge, 2> adj_v2e(const M&, vert) requires(What != without::adj_v2e) { return {}; }
  static std::array<face, 2> adj_e2f(const M&, edge) requires(What != without::adj_e2f) { return {}; }
};

namespace {

template<class M> concept lists_edges_of_polys = requires(const M& m, cn::poly_t<M> p) { cn::adj_p2e(m, p); };
template<class M> concept lists_facets_of_polys = requires(const M& m, cn::poly_t<M> p) { cn::adj_p2facet(m, p); };
template<class M> concept lists_edges_of_faces = requires(const M& m, cn::face_t<M> f) { cn::adj_f2e(m, f); };

}  // namespace

static_assert(lists_edges_of_polys<bare_polygons<without::nothing>> && lists_facets_of_polys<bare_polygons<without::nothing>>);
static_assert(!lists_edges_of_polys<bare_polygons<without::adj_p2v>> && !lists_facets_of_polys<bare_polygons<without::adj_p2v>>);
static_assert(!lists_edges_of_polys<bare_polygons<without::adj_e2v>> && !lists_edges_of_polys<bare_polygons<without::adj_v2e>>);
static_assert(!lists_edges_of_polys<bare_polygons<without::adj_e2p>> && !cn::SurfaceMesh<bare_polygons<without::nothing>>);
static_assert(lists_edges_of_polys<bare_polygons<without::nothing, 4>> && lists_edges_of_polys<bare_polygons<without::adj_v2e, 4>>);
static_assert(!lists_edges_of_polys<bare_polygons<without::adj_p2v, 4>> && !lists_edges_of_polys<bare_polygons<without::adj_e2v, 4>>);
static_assert(lists_edges_of_faces<bare_faces<without::nothing>> && !lists_edges_of_faces<bare_faces<without::adj_f2v>>);
static_assert(!lists_edges_of_faces<bare_faces<without::adj_e2v>> && !lists_edges_of_faces<bare_faces<without::adj_v2e>>);
static_assert(!lists_edges_of_faces<bare_faces<without::adj_e2f>>);

static_assert(std::same_as<decltype(cn::adj_p2e(std::declval<const in_order<user_mesh::surface>&>(), user_mesh::cell())), std::vector<user_mesh::segment>>);
static_assert(cn::ElementRange<decltype(cn::adj_p2e(std::declval<const user_mesh::surface&>(), user_mesh::cell())), user_mesh::segment>);
static_assert(cn::ElementRange<decltype(cn::adj_f2e(std::declval<const user_mesh::volume&>(), user_mesh::facet())), user_mesh::segment>);
static_assert(cn::ElementRange<decltype(cn::adj_p2e(std::declval<const tet_volume&>(), user_mesh::cell())), user_mesh::segment>);
static_assert(cn::SurfaceMesh<shuffled<user_mesh::surface>> && cn::VolumeMesh<shuffled<user_mesh::volume>> && cn::TetMesh<shuffled<tet_volume>>);

namespace {

template<class M, class Verts, class Edges>
void follow(const M& m, const Verts& loop, const Edges& sides) {
  std::vector<cn::vert_t<M>> ring;
  for (const cn::vert_t<M> v : loop) ring.push_back(v);
  for (int walk = 0; walk < 2; ++walk) {
    std::size_t k = 0;
    for (const cn::edge_t<M> e : sides) {
      REQUIRE(k < ring.size());
      const auto &a = ring[k], &b = ring[(k + 1) % ring.size()];
      const auto ends = cn::end_verts(m, e);
      CHECK(((ends.first == a && ends.second == b) || (ends.first == b && ends.second == a)));
      ++k;
    }
    CHECK(k == ring.size());
  }
}

template<class M>
void polys_in_order(const M& m) {
  for (const cn::poly_t<M> p : cn::polys(m)) follow(m, cn::adj_p2v(m, p), cn::adj_p2e(m, p));
}
template<class M>
void faces_in_order(const M& m) {
  for (const cn::face_t<M> f : cn::faces(m)) follow(m, cn::adj_f2v(m, f), cn::adj_f2e(m, f));
}
template<class M>
void tets_in_order(const M& m) {
  const std::pair<std::size_t, std::size_t> ends[6] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  for (const cn::poly_t<M> p : cn::polys(m)) {
    std::vector<cn::vert_t<M>> corner;
    for (const cn::vert_t<M> v : cn::adj_p2v(m, p)) corner.push_back(v);
    std::size_t k = 0;
    for (const cn::edge_t<M> e : cn::adj_p2e(m, p)) {
      REQUIRE(k < 6);
      const auto &a = corner[ends[k].first], &b = corner[ends[k].second];
      const auto of = cn::end_verts(m, e);
      CHECK(((of.first == a && of.second == b) || (of.first == b && of.second == a)));
      ++k;
    }
    CHECK(k == 6);
  }
}

struct points_of {
  const user_mesh::surface* m;
  const std::array<double, 3>& operator[](user_mesh::vertex v) const { return m->points[static_cast<std::size_t>(v.i)]; }
};

/// A polygon of n verts, and a triangle at one of its edges.
user_mesh::surface long_polygon(int n) {
  std::vector<std::array<double, 3>> x;
  user_mesh::polygon ring, fan;
  for (int i = 0; i < n; ++i) x.push_back({std::cos(i * 6.28 / n), std::sin(i * 6.28 / n), 0}), ring.push_back(n - 1 - i);
  x.push_back({0, 0, 1});
  return {x, {ring, {0, 1, n}}};
}

}  // namespace

TEST_CASE("sorted edges: edges of polygons are sorted, also through views") {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const shuffled<user_mesh::surface> s{user_mesh::surface_example(), seed};
    polys_in_order(s);
    polys_in_order(cn::only_mesh(s));
    const points_of points{&s};
    polys_in_order(cn::with_points(s, points));
    for (const int n : {7, 8, 9, 10, 20}) polys_in_order(shuffled<user_mesh::surface>{long_polygon(n), seed});
  }
  const auto twice = in_order<user_mesh::surface>{user_mesh::surface_example()};
  CHECK(cn::adj_p2e(twice, user_mesh::cell{0}).size() == 3);
}

TEST_CASE("sorted edges: edges of faces and tets are sorted") {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const shuffled<user_mesh::volume> w{user_mesh::volume_example(), seed};
    faces_in_order(w);
    faces_in_order(cn::only_mesh(w));
    const shuffled<tet_volume> two{tet_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                                              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 4, 2}, {1, 3, 4}, {2, 4, 3}},
                                              {{{0, true}, {1, true}, {2, true}, {3, true}}, {{3, false}, {4, true}, {5, true}, {6, true}}}),
                                   seed};
    tets_in_order(two);
    faces_in_order(two);
    tets_in_order(cn::only_fixed_arity_mesh(two));
  }
}

TEST_CASE("sorted edges: a missing edge breaks a law, but nothing is read out of bounds") {
  user_mesh::surface s = user_mesh::surface_example();
  s.es.erase(s.es.begin() + 1);  // descriptors of edges are positions, so poly 0 now has too few edges
  std::size_t met = 0;
  for ([[maybe_unused]] const auto e : cn::adj_p2e(s, user_mesh::cell{0})) ++met;
  CHECK(met == 3);
}
