// rewire of the native meshes of tets and hexes: after any replacement of polys the mesh obeys all laws and equals a newly constructed mesh, what is not in the
// cavity keeps its descriptors, and a cavity that is refused changes nothing.
#include <concino/mesh.hpp>

#include <support/cavities.hpp>
#include <support/cell_edges.hpp>
#include <support/corpus.hpp>
#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>
#include <vector>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::owned_cavity;
using cn::testing::rewires_as_told;

static_assert(cn::EditableVolumeMesh<cn::tetmesh> && cn::EditableVolumeMesh<cn::hexmesh>);

namespace {

template<class M>
void cells_are_right(const M& m) {
  keeps_all_laws(m);
  equals_rebuilt(m);
  cn::testing::edges_are_right(m.tables());
}

/// A cavity of these polys, with all their verts; `last` are listed last.
template<class M, class Polys>
owned_cavity cell_cavity_of(const M& m, const Polys& polys, std::vector<cn::vert_id> last = {}) {
  owned_cavity c;
  for (const auto p : polys) {
    c.polys.push_back(p);
    for (const auto v : cn::adj_p2v(m, p))
      if (std::find(c.verts.begin(), c.verts.end(), v) == c.verts.end() && std::find(last.begin(), last.end(), v) == last.end()) c.verts.push_back(v);
  }
  c.verts.insert(c.verts.end(), last.begin(), last.end());
  return c;
}

/// Adds the tet p with vert `from` replaced by the one with number `to` in the cavity.
void add_tet_with(owned_cavity& c, const cn::tetmesh& m, cn::poly_id p, cn::vert_id from, unsigned to) {
  std::vector<unsigned> v;
  for (const auto x : cn::adj_p2v(m, p)) v.push_back(x == from ? to : static_cast<unsigned>(std::find(c.verts.begin(), c.verts.end(), x) - c.verts.begin()));
  c.add_poly(v);
}

owned_cavity tet_edge_split(const cn::tetmesh& m, cn::edge_id e) {
  owned_cavity c = cell_cavity_of(m, cn::adj_e2p(m, e));
  c.points = {(cn::to_vec3(cn::point(m, cn::adj_e2v(m, e)[0])) + cn::to_vec3(cn::point(m, cn::adj_e2v(m, e)[1]))) / 2};
  for (const unsigned end : {0u, 1u})
    for (const auto p : c.polys) add_tet_with(c, m, p, cn::adj_e2v(m, e)[end], static_cast<unsigned>(c.verts.size()));
  c.kept = c.polys.size();
  return c;
}

/// Replaces the second end of e by the first in all its tets, and removes those with both.
owned_cavity tet_edge_collapse(const cn::tetmesh& m, cn::edge_id e) {
  const cn::vert_id a = cn::adj_e2v(m, e)[0], b = cn::adj_e2v(m, e)[1];
  std::vector<cn::poly_id> polys, both;
  for (const auto p : cn::adj_v2p(m, b)) {
    const auto v = cn::adj_p2v(m, p);
    (std::find(v.begin(), v.end(), a) == v.end() ? polys : both).push_back(p);
  }
  polys.insert(polys.end(), both.begin(), both.end());
  owned_cavity c = cell_cavity_of(m, polys, {b});
  const auto to = static_cast<unsigned>(std::find(c.verts.begin(), c.verts.end(), a) - c.verts.begin());
  for (std::size_t i = 0; i + both.size() < polys.size(); ++i) add_tet_with(c, m, polys[i], b, to);
  c.kept = polys.size() - both.size();
  c.removed = 1;
  return c;
}

}  // namespace

TEST_CASE_TEMPLATE("rewire: random cavities of random cells give the mesh that they describe", M, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(21);
  const unsigned rounds = cn::testing::long_run() ? 300 : 12;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = round % 2 ? cn::testing::grid<M>(2) : cn::testing::random_soup<M>(random, 7 + round + cn::arity_v<M>, 14).mesh();
    for (unsigned step = 0; step < 25; ++step) {
      rewires_as_told(m, cn::testing::random_cavity(m, random));
      cn::testing::edges_are_right(m.tables());
      if (step % 8 == 0) keeps_all_laws(m);
    }
    cells_are_right(m);
  }
}

TEST_CASE("rewire: splits and collapses of edges of tets") {
  std::mt19937 random(22);
  cn::tetmesh m = cn::testing::grid<cn::tetmesh>(2);
  for (unsigned step = 0; step < 150; ++step) {
    std::vector<cn::edge_id> all;
    for (const auto e : cn::edges(m)) all.push_back(e);
    const cn::edge_id e = all[random() % all.size()];
    rewires_as_told(m, step % 3 ? tet_edge_collapse(m, e) : tet_edge_split(m, e));
    if (step % 10 == 0) cells_are_right(m);
    if (cn::num_polys(m) < 10) m = cn::testing::grid<cn::tetmesh>(2);
  }
  cells_are_right(m);
}

TEST_CASE("rewire: repeated flips of tets take the descriptors that they give up") {
  // Three tets around the edge 3-4, and two that share the triangle 0, 1, 2, between others.
  const std::vector<std::vector<unsigned>> around = {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}}, between = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  std::vector<std::vector<unsigned>> tets = around;
  tets.insert(tets.end(), {{0, 1, 3, 5}, {1, 2, 3, 5}, {2, 0, 3, 5}, {0, 1, 4, 6}});
  cn::tetmesh m(std::vector<cn::vec3>(7), tets);
  owned_cavity c = cell_cavity_of(m, std::vector{cn::poly_id{0}, cn::poly_id{1}, cn::poly_id{2}});
  c.verts.clear();
  for (unsigned v = 0; v < 5; ++v) c.verts.push_back(cn::vert_id{v});
  const std::size_t edges = cn::edge_index_bound(m), faces = cn::face_index_bound(m);
  for (unsigned round = 0; round < 6; ++round) {
    c.corners.clear(), c.ends.clear();
    for (const auto& v : round % 2 ? around : between) c.add_poly(v);
    c.kept = 2;
    c.polys = rewires_as_told(m, c).polys;
    cells_are_right(m);
    // Two tets have an edge and two faces less than three.
    CHECK(cn::edge_index_bound(m) == edges + (round + 1) / 2);
    CHECK(cn::face_index_bound(m) == faces + (round + 1) / 2 * 2);
    CHECK(cn::poly_index_bound(m) == 7 + (round + 1) / 2);
  }
}

TEST_CASE("rewire: flips of four tets around an edge to four around another let no index bound grow") {
  const std::vector<std::vector<unsigned>> one = {{4, 5, 0, 1}, {4, 5, 1, 2}, {4, 5, 2, 3}, {4, 5, 3, 0}}, other = {{0, 2, 1, 4}, {0, 2, 4, 3}, {0, 2, 3, 5}, {0, 2, 5, 1}};
  cn::tetmesh m(std::vector<cn::vec3>(6), one);
  owned_cavity c = cell_cavity_of(m, cn::polys(m));
  c.verts.clear();
  for (unsigned v = 0; v < 6; ++v) c.verts.push_back(cn::vert_id{v});
  c.kept = 4;
  for (unsigned round = 0; round < 6; ++round) {
    c.corners.clear(), c.ends.clear();
    for (const auto& v : round % 2 ? one : other) c.add_poly(v);
    c.polys = rewires_as_told(m, c).polys;
    cells_are_right(m);
    CHECK(cn::edge_index_bound(m) == 13);
    CHECK(cn::face_index_bound(m) == 12);
    CHECK(cn::poly_index_bound(m) == 4);
  }
}

TEST_CASE_TEMPLATE("rewire: a large cavity of cells, kept, removed and added again", M, cn::tetmesh, cn::hexmesh) {
  M m = cn::testing::grid<M>(cn::arity_v<M> == 4 ? 3 : 5);
  const M grid = m;
  owned_cavity all = cell_cavity_of(m, cn::polys(m));
  for (const auto p : grid.tables().polys().all()) {
    std::vector<unsigned> v;
    for (const auto x : cn::adj_p2v(grid, p)) v.push_back(static_cast<unsigned>(std::find(all.verts.begin(), all.verts.end(), x) - all.verts.begin()));
    all.add_poly(v);
  }
  all.kept = all.polys.size();
  const auto faces = cn::testing::face_between(m);
  rewires_as_told(m, all);
  cells_are_right(m);
  CHECK(cn::testing::face_between(m) == faces);

  owned_cavity none = all;
  none.corners.clear(), none.ends.clear(), none.kept = 0;
  none.removed = none.verts.size();
  rewires_as_told(m, none);
  CHECK(cn::num_verts(m) + cn::num_edges(m) + cn::num_faces(m) + cn::num_polys(m) == 0);

  owned_cavity again = all;
  again.polys.clear(), again.verts.clear(), again.kept = 0;
  again.points.assign(all.verts.size(), {});
  rewires_as_told(m, again);
  cells_are_right(m);
  CHECK(cn::num_edges(m) == cn::num_edges(grid));
  CHECK(cn::num_faces(m) == cn::num_faces(grid));
}

TEST_CASE_TEMPLATE("rewire: large cavities whose new cells are those of a grid, some of them twice, and random ones", M, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(24);
  const unsigned rounds = cn::testing::long_run() ? 40 : 4;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = cn::testing::grid<M>(cn::arity_v<M> == 4 ? 3 : 5);
    owned_cavity c = cell_cavity_of(m, cn::polys(m));
    std::vector<std::vector<unsigned>> cells;
    for (const auto p : c.polys) {
      std::vector<unsigned>& v = cells.emplace_back();
      for (const auto x : cn::adj_p2v(m, p)) v.push_back(static_cast<unsigned>(std::find(c.verts.begin(), c.verts.end(), x) - c.verts.begin()));
    }
    std::shuffle(c.polys.begin(), c.polys.end(), random);
    c.polys.resize(c.polys.size() / 2);
    c.points.resize(2);
    for (unsigned k = 0; k < 90; ++k) {
      const auto num_verts = static_cast<unsigned>(c.verts.size() + c.points.size());
      c.add_poly(k % 9 ? cells[random() % cells.size()] : cn::testing::some_of(random, num_verts, static_cast<unsigned>(cn::arity_v<M>)));
    }
    c.kept = random() % c.polys.size();
    rewires_as_told(m, c);
    cells_are_right(m);
  }
}

TEST_CASE("rewire: tets by one at an edge, and away again, in any order") {
  std::mt19937 random(23);
  cn::tetmesh m(std::vector<cn::vec3>(9), std::vector<std::vector<unsigned>>{});
  std::vector<cn::poly_id> here;
  for (unsigned step = 0; step < 120; ++step) {
    owned_cavity c;
    if (here.size() > 2 + random() % 8) c.polys = {cn::testing::take(here, random)};
    for (unsigned v = 0; v < 9; ++v) c.verts.push_back(cn::vert_id{v});
    if (random() % 4) {
      const auto other = cn::testing::some_of(random, 7, 2);
      c.add_poly({0, 1, 2 + other[0], 2 + other[1]});
      c.kept = c.polys.empty() ? 0 : random() % 2;
    }
    for (const auto p : rewires_as_told(m, c).polys) here.push_back(p);
    cn::testing::edges_are_right(m.tables());
    if (step % 10 == 0) cells_are_right(m);
  }
}

TEST_CASE("rewire: new tets in rings, and in a row that is open, around one edge") {
  // Lengths of the rings; the last tet of a row is left out.
  const std::vector<std::vector<unsigned>> cases = {{6}, {7}, {9}, {3, 3}, {3, 4}, {4, 3}, {3, 3, 3}, {5, 4}};
  for (const auto& rings : cases)
    for (const bool is_open : {false, true})
      for (const bool is_reversed : {false, true}) {
        cn::tetmesh m(std::vector<cn::vec3>(14), std::vector<std::vector<unsigned>>{});
        owned_cavity c;
        for (unsigned v = 0; v < 14; ++v) c.verts.push_back(cn::vert_id{v});
        std::vector<std::vector<unsigned>> tets;
        unsigned first = 2;
        for (const unsigned n : rings) {
          for (unsigned i = 0; i < n; ++i) tets.push_back({0, 1, first + i, first + (i + 1) % n});
          first += n;
        }
        if (is_open) tets.pop_back();
        if (is_reversed) std::reverse(tets.begin(), tets.end());
        for (const auto& v : tets) c.add_poly(v);
        rewires_as_told(m, c);
        cells_are_right(m);
      }
}

TEST_CASE("rewire: many faces at an edge that comes after their other edges") {
  constexpr unsigned n = 40;  // more than are searched one by one
  cn::tetmesh m(std::vector<cn::vec3>(n + 4), std::vector<std::vector<unsigned>>{});
  owned_cavity c;
  for (unsigned v = 0; v < n + 4; ++v) c.verts.push_back(cn::vert_id{v});
  for (const unsigned end : {0u, 1u})
    for (unsigned i = 4; i < n + 4; ++i) c.add_poly({end, i, 2, 3});
  for (const unsigned last : {2u, 3u})  // each tet has a face with the edge 0-1 that another one has too
    for (unsigned i = 4; i < n + 4; ++i) c.add_poly({0, 1, i, last});
  rewires_as_told(m, c);
  cells_are_right(m);
  CHECK(cn::num_elements(cn::adj_e2f(m, cn::testing::edge_between_verts(m, 0, 1))) == n + 2);
}

TEST_CASE("rewire: quadrilaterals with the same verts in another order are other faces") {
  cn::hexmesh m(std::vector<cn::vec3>(20), std::vector<std::vector<unsigned>>{});
  owned_cavity c;
  for (unsigned v = 0; v < 20; ++v) c.verts.push_back(cn::vert_id{v});
  const std::vector<std::vector<unsigned>> quads = {{2, 0, 3, 1}, {2, 0, 1, 3}, {1, 3, 0, 2}, {0, 2, 3, 1}};  // the third is the first one, the fourth the second one
  unsigned next = 4;
  for (auto v : quads) {
    for (unsigned i = 0; i < 4; ++i) v.push_back(next++);
    c.add_poly(v);
  }
  rewires_as_told(m, c);
  cells_are_right(m);
  CHECK(cn::num_faces(m) == 4 * 6 - 2);
}

TEST_CASE_TEMPLATE("rewire: a cavity of cells with a mistake is refused, and nothing changes", M, cn::tetmesh, cn::hexmesh) {
  cn::testing::refuses_mistakes(cn::testing::grid<M>(2));
}
