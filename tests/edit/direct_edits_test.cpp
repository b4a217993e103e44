// Edits of triangles that change the tables directly give the same mesh as rewire: the same descriptors, points, and entries of all lists in the same order.
#include <concino/edit.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>
#include <utility>
#include <vector>

namespace cn = concino;
using cn::testing::whole;

namespace {

constexpr auto anything = [](const cn::proposed_edit&) { return cn::permission{}; };

struct direct_counts {
  unsigned done[3] = {};
};

/// Whether the first poly of each edge with two polys is the first after an edit, too, if the edge has it still and has two polys again.
bool first_polys_stay(const cn::trimesh& before, const cn::trimesh& after) {
  const auto polys = [](const cn::trimesh& m, cn::edge_id e) {
    std::vector<cn::poly_id> all;
    for (const cn::poly_id p : cn::adj_e2p(m, e)) all.push_back(p);
    return all;
  };
  for (const cn::edge_id e : cn::edges(before)) {
    if (!cn::contains(after, e) || cn::end_verts(before, e) != cn::end_verts(after, e)) continue;
    const auto old = polys(before, e), now = polys(after, e);
    if (old.size() == 2 && now.size() == 2 && now[1] == old[0]) return false;
  }
  return true;
}

/// Edits a copy of m by rewire, as an invariant or a property asks for it, and m in any way; both must agree. Returns whether m was edited directly.
bool edits_agree(unsigned what, cn::trimesh& m, cn::edge_id e, double t) {
  using traits = concino::mesh_traits<cn::trimesh>;
  const cn::trimesh before = m;
  cn::trimesh by_rewire = m, direct = m;
  const auto ends = cn::end_verts(m, e);
  const cn::vec3 x = concino::detail::point_between(cn::point(m, ends.first), cn::point(m, ends.second), t);
  bool is_direct = false;
  cn::permission asked, done;
  if (what == 0) {
    asked = cn::edge_split(by_rewire, e, t, {.keep = {anything}});
    is_direct = traits::split_edge(direct, e, x).has_value();
    done = cn::edge_split(m, e, t);
  } else if (what == 1) {
    const auto made = cn::edge_flip(by_rewire, e, {.keep = {anything}});
    is_direct = traits::flip_edge(direct, e);
    const auto own = cn::edge_flip(m, e);
    CHECK(own.edge == made.edge);
    asked = made, done = own;
  } else {
    cn::edge_property<int>(by_rewire, "left to rewire");  // an invariant would not be enough
    const auto made = cn::edge_collapse(by_rewire, e, {.at = t});
    cn::remove_property(by_rewire, cn::element_kind::edge, "left to rewire");
    is_direct = traits::collapse_edge(direct, e, x);
    const auto own = cn::edge_collapse(m, e, {.at = t});
    CHECK(own.vert == made.vert);
    asked = made, done = own;
  }
  CHECK(bool(asked) == bool(done));
  CHECK(asked.why == done.why);
  CHECK(whole(m) == whole(by_rewire));
  CHECK(first_polys_stay(before, m));
  if (is_direct) CHECK(whole(direct) == whole(by_rewire));
  return is_direct;
}

direct_counts edit_at_random(cn::trimesh m, std::mt19937& random, unsigned rounds) {
  direct_counts n;
  for (unsigned i = 0; i < rounds && cn::num_polys(m) > 0; ++i) {
    const unsigned what = cn::num_polys(m) > 90 ? 2 : static_cast<unsigned>(random() % 3);
    cn::edge_id e;
    do e = cn::edge_id{random() % cn::edge_index_bound(m)};
    while (!cn::contains(m, e));
    n.done[what] += edits_agree(what, m, e, what == 2 ? 0.5 * double(random() % 3) : 0.3);
    if (i % 64 == 0) cn::testing::keeps_all_laws(m);
  }
  cn::testing::keeps_all_laws(m);
  cn::testing::equals_rebuilt(m);
  return n;
}

/// Starts with gaps among the elements, too.
cn::trimesh with_gaps(cn::trimesh m) {
  for (unsigned p = 0; p < 3; ++p) cn::remove_poly(m, cn::poly_id{5 * p});
  return m;
}

unsigned num_rounds() { return cn::testing::long_run() ? 20000 : 600; }

}  // namespace

TEST_CASE("edits of triangles: directly or by rewire, with and without boundary") {
  std::mt19937 random(21);
  for (const cn::trimesh& m : {cn::icosphere(1), cn::testing::grid<cn::trimesh>(4), with_gaps(cn::icosphere(1))}) {
    const direct_counts n = edit_at_random(m, random, num_rounds());
    for (const unsigned done : n.done) CHECK(done > num_rounds() / 20);
  }
}

TEST_CASE("edits of triangles: directly or by rewire, non-manifold soups and equal triangles") {
  std::mt19937 random(22);
  for (unsigned round = 0; round < 20; ++round) edit_at_random(cn::testing::random_soup<cn::trimesh>(random, 9, 4 + round).mesh(), random, num_rounds() / 12);
}

TEST_CASE("flips of triangles: among edits that are left to rewire, kept or undone") {
  std::mt19937 random(24);
  cn::trimesh m = cn::icosphere(1);
  const auto any_edge = [&] { return cn::edge_id{random() % cn::edge_index_bound(m)}; };  // splits and flips leave no gaps
  unsigned done = 0;
  for (unsigned round = 0; round < 20; ++round) {
    for (unsigned i = 0; i < 10; ++i) done += edits_agree(1, m, any_edge(), 0);
    cn::transaction t(m);
    for (unsigned i = 0; i < 3; ++i) cn::edge_split(m, any_edge()), cn::edge_flip(m, any_edge());
    if (round % 2 == 0) t.commit();
  }
  CHECK(done > 50);
  cn::testing::keeps_all_laws(m);
  cn::testing::equals_rebuilt(m);
}

TEST_CASE("edits of triangles: values of properties and transactions are left to rewire") {
  cn::trimesh m = cn::icosphere(1);
  cn::edge_property<double>(m, "length");
  const cn::edge_id e{3};
  const auto before = whole(m);
  CHECK_FALSE(concino::mesh_traits<cn::trimesh>::split_edge(m, e, {0, 0, 0}));
  CHECK_FALSE(concino::mesh_traits<cn::trimesh>::flip_edge(m, e));
  CHECK_FALSE(concino::mesh_traits<cn::trimesh>::collapse_edge(m, e, {0, 0, 0}));
  cn::trimesh other = cn::icosphere(1);
  const auto other_before = whole(other);
  {
    cn::transaction t(other);
    CHECK_FALSE(concino::mesh_traits<cn::trimesh>::flip_edge(other, e));
    CHECK(cn::edge_flip(other, e));
    CHECK(cn::edge_split(other, e));
  }
  CHECK(whole(m) == before);
  CHECK(whole(other) == other_before);
}
