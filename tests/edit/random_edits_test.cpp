// Random edits by every operator on triangles and tets, with and without boundary, manifold or not: laws, topology and defects as before, and refused edits
// change nothing.
#include <concino/edit.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using cn::testing::topology;
using cn::testing::whole;

namespace {

enum operators { split_edge, collapse_edge, flip_edge, split_poly, split_vert, flip_face, split_face, num_operators };

/// An existing element of the kind of Id, by its index bound.
template<class Id, class M>
Id some_element(const M& m, std::mt19937& random, std::size_t bound) {
  for (;;)
    if (const Id x{random() % bound}; cn::contains(m, x)) return x;
}

template<class M>
cn::permission edit_by(unsigned what, M& m, std::mt19937& random) {
  const auto edge = [&] { return some_element<cn::edge_id>(m, random, cn::edge_index_bound(m)); };
  const auto poly = [&] { return some_element<cn::poly_id>(m, random, cn::poly_index_bound(m)); };
  switch (what) {
    case split_edge: return cn::edge_split(m, edge(), 0.3);
    case collapse_edge: return cn::edge_collapse(m, edge(), {.at = 0.5 * double(random() % 3)});
    case flip_edge:
      if constexpr (cn::VolumeMesh<M>) return cn::edge_flip(m, edge(), {.diagonal = random() % 2 ? 1u : 0u});
      else return cn::edge_flip(m, edge());
    case split_poly: return cn::poly_split(m, poly());
    case split_vert: {
      const cn::vert_id v = *cn::adj_p2v(m, poly()).begin();
      std::vector<cn::poly_id> moved;
      if constexpr (cn::VolumeMesh<M>) {  // the polys at one of its edges: a ball
        for (const auto e : cn::adj_v2e(m, v))
          if (random() % 4 == 0) {
            for (const auto p : cn::adj_e2p(m, e)) moved.push_back(p);
            break;
          }
      } else {
        for (const auto p : cn::adj_v2p(m, v))
          if (random() % 3 == 0) moved.push_back(p);
      }
      return cn::vert_split(m, v, moved, {0.1, 0.2, 0.3});
    }
    default:
      if constexpr (cn::VolumeMesh<M>) {
        const cn::face_id f = some_element<cn::face_id>(m, random, cn::face_index_bound(m));
        return what == flip_face ? cn::permission(cn::face_flip(m, f)) : cn::permission(cn::face_split(m, f, {0.3, 0.3, 0.3}));
      } else {
        return {};
      }
  }
}

/// The Euler characteristic in constant time, if edits leave no vert without polys and add none.
template<class M>
std::ptrdiff_t quick_euler_characteristic(const M& m) {
  const auto n = [](std::size_t x) { return static_cast<std::ptrdiff_t>(x); };
  const std::ptrdiff_t chi = n(cn::num_verts(m)) - n(cn::num_edges(m));
  if constexpr (cn::VolumeMesh<M>) return chi + n(cn::num_faces(m)) - n(cn::num_polys(m));
  else return chi + n(cn::num_polys(m));
}

/// Edits copies of `start` until each operator was asked `tries` times. Growing meshes are collapsed, and replaced by `start` if that is not enough.
template<class M>
void edit_at_random(const M& start, std::mt19937& random, unsigned tries, bool may_flip_tets) {
  M m = start;
  const std::size_t most = 2 * cn::num_polys(start) + 40;
  const auto facts = topology(start);
  const std::ptrdiff_t chi = quick_euler_characteristic(start);
  unsigned done[num_operators] = {};
  for (unsigned i = 0; i < tries; ++i) {
    for (unsigned what = 0; what < (cn::VolumeMesh<M> ? num_operators : flip_face); ++what) {
      const bool is_sample = random() % 256 == 0;
      const auto before = is_sample ? whole(m) : std::vector<double>();
      const cn::permission p = edit_by(what, m, random);
      done[what] += bool(p);
      if (is_sample && !p) CHECK(whole(m) == before);
      if (quick_euler_characteristic(m) != chi) FAIL("the Euler characteristic changed by operator " << what);
    }
    for (unsigned k = 0; k < 20 && cn::num_polys(m) > most; ++k) edit_by(collapse_edge, m, random);
    if (cn::num_polys(m) > 2 * most) m = start;
    if (i % 512 == 0 || i + 1 == tries) {
      cn::testing::keeps_all_laws(m);
      CHECK(topology(m) == facts);
    }
  }
  cn::testing::equals_rebuilt(m);
  for (unsigned what = 0; what < (cn::VolumeMesh<M> ? num_operators : flip_face); ++what)
    if (may_flip_tets || (what != flip_face && what != flip_edge)) CHECK_MESSAGE(done[what] > 0, "operator " << what);
}

/// Different polys on few verts.
template<class M>
M soup_of_different_polys(std::mt19937& random, unsigned verts, unsigned polys) {
  std::set<std::set<unsigned>> different;
  while (different.size() < polys) {
    const auto corners = cn::testing::some_of(random, verts, cn::dimension_v<M> + 1);
    different.insert({corners.begin(), corners.end()});
  }
  std::vector<std::vector<unsigned>> lists;
  for (const auto& p : different) lists.emplace_back(p.begin(), p.end());
  return M(cn::testing::random_points(random, verts), lists);
}

/// For each operator, in all test cases together.
unsigned num_tries() { return cn::testing::long_run() ? 1000000 : 10000; }

}  // namespace

TEST_CASE("random edits: a closed surface") {
  std::mt19937 random(1);
  edit_at_random(cn::icosphere(0), random, num_tries() / 4, true);
}

TEST_CASE("random edits: a surface with boundary") {
  std::mt19937 random(2);
  edit_at_random(cn::testing::grid<cn::trimesh>(3), random, num_tries() / 8, true);
}

TEST_CASE("random edits: non-manifold triangles") {
  std::mt19937 random(3);
  for (unsigned round = 0; round < 5; ++round) edit_at_random(soup_of_different_polys<cn::trimesh>(random, 10, 14), random, num_tries() / 40, true);
}

TEST_CASE("random edits: tets") {
  std::mt19937 random(4);
  edit_at_random(cn::testing::grid<cn::tetmesh>(2), random, num_tries() * 3 / 8, true);
}

TEST_CASE("random edits: non-manifold tets") {
  std::mt19937 random(5);
  for (unsigned round = 0; round < 5; ++round) edit_at_random(soup_of_different_polys<cn::tetmesh>(random, 9, 10), random, num_tries() / 40, false);
}
