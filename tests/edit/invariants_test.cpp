// Invariants of edits: each refuses what it should and nothing else, and a refused edit changes nothing.
#include <concino/edit.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/quality/poly_quality.hpp>
#include <concino/validate/validate.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>
#include <utility>

namespace cn = concino;
using cn::testing::edge_between_verts;
using cn::testing::raw;
using cn::testing::whole;
using lists = std::vector<std::vector<unsigned>>;
using points = std::vector<cn::vec3>;

namespace {

/// Runs the edit and checks that it is refused by an invariant and changes nothing.
template<class M, class F>
void invariant_refuses(M m, const F& edit) {
  const auto before = whole(m);
  const cn::permission p = edit(m);
  CHECK(p.reason == cn::refusal::invariant);
  CHECK_FALSE(p.why.empty());
  CHECK(whole(m) == before);
}

/// A random edit, refused unless the invariants hold.
template<class M>
cn::permission some_edit(M& m, std::mt19937& random, const std::vector<cn::invariant>& keep) {
  const auto edges = raw(cn::edges(m)), polys = raw(cn::polys(m));
  const cn::edge_id e{edges[random() % edges.size()]};
  const cn::poly_id p{polys[random() % polys.size()]};
  switch (random() % 5) {
    case 0: return cn::edge_split(m, e, 0.4, {keep});
    case 1: return cn::edge_collapse(m, e, {.keep = keep, .at = 0.5 * double(random() % 3)});
    case 2: return cn::edge_flip(m, e, {.keep = keep});
    case 3: return cn::poly_split(m, p, cn::to_vec3(cn::point(m, *cn::adj_p2v(m, p).begin())) * 0.2 + cn::detail::mean_of_verts(m, p) * 0.8, {keep});
    default:
      if constexpr (cn::VolumeMesh<M>) {
        const auto faces = raw(cn::faces(m));
        return cn::face_flip(m, cn::face_id{faces[random() % faces.size()]}, {keep});
      } else {
        return cn::edge_flip(m, e, {keep});
      }
  }
}

/// Two triangles that form a quadrilateral with a reflex angle at vert 2.
cn::trimesh dart() { return cn::trimesh(points{{0, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}}, lists{{0, 1, 2}, {0, 2, 3}}); }

}  // namespace

TEST_CASE("no_inversion: flips, splits and collapses of triangles") {
  invariant_refuses(dart(), [](auto& m) { return cn::edge_flip(m, edge_between_verts(m, 0, 2), {{cn::no_inversion}}); });
  invariant_refuses(dart(), [](auto& m) { return cn::poly_split(m, cn::poly_id{0}, {3, 3, 0}, {{cn::no_inversion}}); });
  invariant_refuses(dart(), [](auto& m) { return cn::poly_split(m, cn::poly_id{0}, {2, 0.5, 0}, {{cn::no_inversion}}); });  // on an edge: no area
  cn::trimesh m = dart();
  CHECK(cn::can_edge_flip(m, edge_between_verts(m, 0, 2)));
  CHECK_FALSE(cn::can_edge_flip(m, edge_between_verts(m, 0, 2), {{cn::no_inversion}}));
  CHECK(cn::poly_split(m, cn::poly_id{0}, {1.6, 0.7, 0}, {{cn::no_inversion}}));
  const cn::trimesh roof(points{{0, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 1, 1}}, lists{{0, 2, 1}, {0, 1, 3}});  // two planes at a right angle
  CHECK(cn::can_edge_flip(roof, edge_between_verts(roof, 0, 1), {{cn::no_inversion}}));
  const cn::trimesh folded(points{{0, 0, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, 0.01}}, lists{{0, 2, 1}, {0, 1, 3}});  // one on the other
  CHECK_FALSE(cn::can_edge_flip(folded, edge_between_verts(folded, 0, 1), {{cn::no_inversion}}));
}

TEST_CASE("no_inversion: flips after splits make no poly that validate reports or gradient refuses") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> where(0.1, 0.9), x(-2, 2);
  unsigned tried = 0, done = 0;
  for (unsigned round = 0; round < 500; ++round) {
    cn::trimesh m(points{{0, 0, 0}, {2.125, 0.375 + x(random) / 8, 0}, {x(random), 2, 0}, {x(random), -2, 0}}, lists{{0, 1, 2}, {1, 0, 3}});
    const auto v = cn::edge_split(m, edge_between_verts(m, 0, 1), where(random)).vert;
    for (const auto e : cn::edges(m)) {
      auto c = m;
      const auto ends = cn::end_verts(m, e);
      if (ends.first != v && ends.second != v) continue;
      ++tried;
      if (!cn::edge_flip(c, e, {.keep = {cn::no_inversion}})) continue;
      ++done;
      CHECK(cn::validate(c).count(cn::defect_kind::zero_size) == 0);
      CHECK_NOTHROW(cn::gradient(c, cn::make_vert_map<double>(c)));
    }
  }
  CHECK(tried == 2000);
  CHECK(done > 150);
}

TEST_CASE("no_inversion: a vert that is put on a face by rounding makes no tet that validate reports") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(0.1, 1);
  const cn::tetmesh tet(points{{0.1, 0.2, 0.3}, {1.3, 0.1, 0.2}, {0.2, 1.7, 0.1}, {0.3, 0.4, 1.9}}, lists{{0, 1, 2, 3}});
  unsigned refused = 0;
  for (unsigned round = 0; round < 300; ++round) {
    auto m = tet;
    const double a = x(random), b = x(random), c = x(random);
    const auto at = [&](unsigned i) { return cn::to_vec3(cn::point(m, cn::vert_id{i})); };
    const cn::vec3 on_face = (a * at(1) + b * at(2) + c * at(3)) / (a + b + c);
    if (!cn::poly_split(m, cn::poly_id{0}, on_face, {{cn::no_inversion}})) ++refused;
    CHECK(cn::validate(m).count(cn::defect_kind::zero_size) == 0);
  }
  CHECK(refused == 300);
}

TEST_CASE_TEMPLATE("no_inversion: random edits keep all orientations", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(2);
  M m = cn::testing::grid<M>(cn::dimension_v<M> == 2 ? 6 : 3);
  const double measure = cn::total_measure(m);
  unsigned done = 0, refused = 0;
  for (unsigned i = 0; i < 600; ++i) {
    const cn::permission p = some_edit(m, random, {cn::no_inversion});
    done += bool(p), refused += p.reason == cn::refusal::invariant;
  }
  CHECK(done > 150);
  CHECK(refused > 20);
  for (const auto p : cn::polys(m)) {
    const auto v = raw(cn::adj_p2v(m, p));
    const auto x = [&](unsigned i) { return cn::to_vec3(cn::point(m, cn::vert_id{v[i]})); };
    if constexpr (cn::dimension_v<M> == 2) CHECK(cn::orient2d(x(0), x(1), x(2)) == 1);
    else CHECK(cn::orient3d(x(0), x(1), x(2), x(3)) == 1);
  }
  CHECK(cn::total_measure(m) <= measure * (1 + 1e-12));  // collapses may cut corners off
  cn::testing::keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("min_quality: by metrics that are worse if smaller, and by one that is worse if larger", M, cn::trimesh, cn::tetmesh) {
  for (const auto& [what, limit] : {std::pair{cn::metric::mean_ratio, 0.15}, {cn::metric::scaled_jacobian, 0.15}, {cn::metric::aspect_ratio, 5.0}}) {
    std::mt19937 random(2);
    M m = cn::testing::grid<M>(cn::dimension_v<M> == 2 ? 6 : 3);
    unsigned done = 0, refused = 0;
    for (unsigned i = 0; i < 300; ++i) {
      const cn::permission p = some_edit(m, random, {cn::min_quality(limit, what), cn::no_inversion});
      done += bool(p), refused += p.reason == cn::refusal::invariant;
    }
    CHECK(done > 20);
    CHECK(refused > 20);
    for (const auto p : cn::polys(m)) CHECK_FALSE(cn::is_worse(what, cn::quality(m, p, what), limit));
  }
}

TEST_CASE_TEMPLATE("protect_edges: marked edges remain, also under random edits", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(3);
  M m = cn::testing::grid<M>(3);
  std::set<std::set<unsigned>> wanted;
  const auto is_marked = cn::edge_property<bool>(m, "marked");
  for (const auto e : cn::edges(m))
    if (random() % 8 == 0) is_marked[e] = true, wanted.insert(cn::testing::raw_set(cn::adj_e2v(m, e)));
  const std::vector<cn::invariant> keep{cn::protect_edges(m, is_marked)};
  unsigned refused = 0;
  for (unsigned i = 0; i < 200; ++i) {
    // new edges may take the descriptors of old ones: their marks are set anew, as the caller's rule for new elements would
    refused += some_edit(m, random, keep).reason == cn::refusal::invariant;
    for (const auto e : cn::edges(m)) is_marked[e] = wanted.count(cn::testing::raw_set(cn::adj_e2v(m, e))) > 0;
  }
  CHECK(refused > 10);
  std::set<std::set<unsigned>> now;
  for (const auto e : cn::edges(m))
    if (is_marked[e]) now.insert(cn::testing::raw_set(cn::adj_e2v(m, e)));
  CHECK(now == wanted);
}

TEST_CASE("protect_faces: a marked face remains") {
  cn::tetmesh m(points{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 2}, {1, 1, -2}}, lists{{0, 1, 2, 3}, {1, 0, 2, 4}});
  for (const auto f : cn::faces(m)) {
    const bool is_between = cn::num_elements(cn::adj_f2p(m, f)) == 2;
    if (!is_between) continue;
    const auto only = [f](cn::face_id x) { return x == f; };
    invariant_refuses(m, [&](auto& x) { return cn::face_flip(x, f, {{cn::protect_faces(x, only)}}); });
    invariant_refuses(m, [&](auto& x) { return cn::face_split(x, f, {1, 1, 0}, {{cn::protect_faces(x, only)}}); });
    invariant_refuses(m, [&](auto& x) { return cn::edge_split(x, edge_between_verts(x, 0, 1), 0.5, {{cn::protect_faces(x, only)}}); });
    CHECK(cn::can_edge_split(m, edge_between_verts(m, 0, 3), 0.5, {{cn::protect_faces(m, only)}}));
  }
  cn::tetmesh other = m;
  CHECK_THROWS_WITH_AS(cn::can_edge_split(other, cn::edge_id{0}, 0.5, {{cn::protect_faces(m, [](cn::face_id) { return true; })}}),
                       "protect_faces: the invariant was made for another mesh; make it with the mesh that is edited", cn::invalid_argument);
}

TEST_CASE_TEMPLATE("keep_labels: the boundary between two regions remains in place", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(3);
  M m = cn::testing::grid<M>(4);
  const auto label = cn::poly_property<int>(m, "label");
  const auto side = [&](cn::poly_id p) { return cn::detail::mean_of_verts(m, p).x < 0.5 ? 1 : 2; };
  for (const auto p : cn::polys(m)) label[p] = side(p);
  const std::vector<cn::invariant> keep{cn::keep_labels(m, label), cn::no_inversion};
  unsigned done = 0, refused = 0;
  for (unsigned i = 0; i < 400; ++i) {
    const cn::permission p = some_edit(m, random, keep);
    done += bool(p), refused += p.why.substr(0, 11) == "keep_labels";
    for (const auto x : cn::polys(m)) label[x] = side(x);  // as the caller's rule for new polys would
  }
  CHECK(done > 30);
  CHECK(refused > 10);
  for (const auto x : cn::facets(m)) {
    std::set<int> labels;
    for (const auto p : cn::adj_facet2p(m, x)) labels.insert(label[p]);
    if (labels.size() == 2)
      for (const auto v : cn::adj_facet2v(m, x)) CHECK(cn::point(m, v).x == doctest::Approx(0.5));
  }
}

TEST_CASE("max_distance: a corner of an open surface does not vanish") {
  const double scale = 0x1p400;
  cn::trimesh m(points{{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, scale, 0}, {0.5 * scale, 0, 0}}, lists{{0, 4, 3}, {4, 1, 2}, {4, 2, 3}});
  const auto tree = cn::bounding_tree(m);
  const std::vector<cn::invariant> keep{cn::max_distance(tree, 0.001 * scale)};
  invariant_refuses(m, [&](auto& x) { return cn::edge_collapse(x, edge_between_verts(x, 1, 2), {.keep = keep, .at = 0.0}); });
  invariant_refuses(m, [&](auto& x) { return cn::edge_collapse(x, edge_between_verts(x, 0, 3), {.keep = keep, .at = 0.5}); });
  const auto e = edge_between_verts(m, 0, 4);
  CHECK(cn::edge_collapse(m, e, {.keep = keep, .at = cn::end_verts(m, e).first == cn::vert_id{0} ? 0.0 : 1.0}));
  CHECK(cn::total_measure(m) == scale * scale);
}

TEST_CASE("max_distance: collapses of a sphere stay near it") {
  const cn::trimesh sphere = cn::icosphere(3);
  const auto tree = cn::bounding_tree(sphere);
  cn::trimesh m = sphere;
  const std::vector<cn::invariant> keep{cn::no_inversion, cn::max_distance(tree, 0.05)};
  std::mt19937 random(4);
  unsigned done = 0, refused = 0;
  for (unsigned i = 0; i < 800; ++i) {
    const auto edges = raw(cn::edges(m));
    const auto made = cn::edge_collapse(m, cn::edge_id{edges[random() % edges.size()]}, {.keep = keep, .at = 0});
    done += bool(made), refused += made.why.substr(0, 12) == "max_distance";
  }
  CHECK(done > 300);
  CHECK(refused > 10);
  for (const auto p : cn::polys(m)) CHECK(tree.closest(cn::detail::mean_of_verts(m, p)).distance <= 0.05);
  CHECK_THROWS_AS(cn::max_distance(tree, -1), cn::invalid_argument);
  cn::tetmesh t = cn::testing::grid<cn::tetmesh>(1);
  CHECK_THROWS_AS(cn::edge_split(t, cn::edge_id{0}, 0.5, {{cn::max_distance(tree, 1)}}), cn::invalid_argument);
}

TEST_CASE("invariants of the caller: what they are told, and exceptions") {
  cn::trimesh m(points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, lists{{0, 1, 2}, {0, 2, 3}});
  const auto before = whole(m);
  const cn::edge_id diagonal = edge_between_verts(m, 0, 2);
  unsigned asked = 0;
  const auto look = [&asked](const cn::proposed_edit& e) {
    ++asked;
    CHECK(e.corners_per_poly == 3);
    CHECK(e.num_old_polys() == 2);
    CHECK(e.num_new_polys() == 4);
    CHECK(std::multiset<std::size_t>(e.verts.begin(), e.verts.end()) == std::multiset<std::size_t>{0, 1, 2, 3});
    CHECK(e.points_after.size() == 5);
    CHECK(e.points_after.back() == cn::vec3{0.5, 0.5, 0});
    for (std::size_t k = 0; k < e.num_new_polys(); ++k) CHECK(std::count(e.new_poly(k).begin(), e.new_poly(k).end(), 4u) == 1);
    return cn::permission{};
  };
  CHECK(cn::can_edge_split(m, diagonal, 0.5, {{look, look}}));
  CHECK(asked == 2);
  const auto no = [](const cn::proposed_edit&) { return cn::permission{cn::refusal::invariant, "not today"}; };
  CHECK(cn::edge_split(m, diagonal, 0.5, {{no, look}}).why == "not today");
  CHECK(asked == 2);
  const auto throws = [](const cn::proposed_edit&) -> cn::permission { throw 7; };
  CHECK_THROWS_AS(cn::edge_split(m, diagonal, 0.5, {{throws}}), int);
  CHECK_THROWS_AS(cn::edge_flip(m, diagonal, {{throws}}), int);
  CHECK_THROWS_AS(cn::poly_split(m, cn::poly_id{0}, {0.6, 0.5, 0}, {{throws}}), int);
  CHECK(whole(m) == before);

  cn::trimesh grid = cn::testing::grid<cn::trimesh>(4);
  const auto moves = [](const cn::proposed_edit& e) {
    CHECK(e.removed_vert != cn::proposed_edit::none);
    CHECK(e.points_after[e.kept_vert] == 0.5 * (e.points_before[e.kept_vert] + e.points_before[e.removed_vert]));
    CHECK(e.num_old_polys() == e.num_new_polys() + 2);
    return cn::permission{};
  };
  for (const auto e : cn::edges(grid)) {
    const auto ends = cn::end_verts(grid, e);
    if (!cn::is_boundary(grid, ends.first) && !cn::is_boundary(grid, ends.second)) CHECK(cn::can_edge_collapse(grid, e, {.keep = {moves}}));
  }
}
