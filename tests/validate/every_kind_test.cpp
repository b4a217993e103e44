// validate on all six kinds: on archetypes, at every scale, on random lists of polys.
#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>
#include <concino/validate/validate.hpp>

#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

/// The same facts and counts, computed by brute force.
struct slow_facts {
  std::size_t bad_edges = 0, bad_verts = 0, isolated = 0, components = 0, loops = 0, duplicates = 0;
  std::ptrdiff_t chi = 0;
  bool closed = true, orientable = false;
};

/// The number of connected components of `all`, in which two numbers are connected if joined(a, b).
template<class Joined>
std::size_t pieces(const std::vector<unsigned>& all, const Joined& joined) {
  std::set<unsigned> left(all.begin(), all.end());
  std::size_t n = 0;
  while (!left.empty()) {
    ++n;
    std::vector<unsigned> queue{*left.begin()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (auto it = left.begin(); it != left.end();)
        if (joined(queue[i], *it)) {
          queue.push_back(*it);
          it = left.erase(it);
        } else ++it;
  }
  return n;
}

slow_facts look_slowly(const std::vector<std::vector<unsigned>>& ring, unsigned vert_count) {
  slow_facts f;
  std::map<std::pair<unsigned, unsigned>, std::vector<std::pair<unsigned, bool>>> at;  // edge -> polys, and whether they have it in ascending direction
  std::map<unsigned, std::vector<unsigned>> polys_at;
  std::set<std::set<unsigned>> sets;
  for (unsigned p = 0; p < ring.size(); ++p) {
    for (std::size_t i = 0; i < ring[p].size(); ++i) {
      const unsigned a = ring[p][i], b = ring[p][(i + 1) % ring[p].size()];
      at[{std::min(a, b), std::max(a, b)}].push_back({p, a < b});
      polys_at[a].push_back(p);
    }
    f.duplicates += !sets.insert({ring[p].begin(), ring[p].end()}).second;
  }
  const auto has = [&](unsigned p, unsigned v) { return std::count(ring[p].begin(), ring[p].end(), v) > 0; };
  std::vector<unsigned> used, border;
  for (const auto& [v, polys_of_v] : polys_at) {
    used.push_back(v);
    f.bad_verts += pieces(polys_of_v, [&, v = v](unsigned p, unsigned q) {
      for (const auto& [e, users] : at)
        if (e.first == v || e.second == v) {
          bool p_there = false, q_there = false;
          for (const auto& u : users) p_there = p_there || u.first == p, q_there = q_there || u.first == q;
          if (p_there && q_there) return true;
        }
      return false;
    }) > 1;
  }
  f.isolated = vert_count - used.size();
  f.components = pieces(used, [&](unsigned v, unsigned w) {
    for (unsigned p = 0; p < ring.size(); ++p)
      if (has(p, v) && has(p, w)) return true;
    return false;
  });
  for (const auto& [e, users] : at) {
    f.bad_edges += users.size() > 2;
    if (users.size() == 1) border.insert(border.end(), {e.first, e.second});
  }
  f.closed = border.empty();
  f.loops = pieces(border, [&](unsigned v, unsigned w) {
    const auto e = at.find({std::min(v, w), std::max(v, w)});
    return e != at.end() && e->second.size() == 1;
  });
  f.chi = static_cast<std::ptrdiff_t>(used.size() + ring.size()) - static_cast<std::ptrdiff_t>(at.size());
  for (unsigned flips = 0; flips < (1u << ring.size()) && !f.orientable; ++flips) {  // every combination of orientations
    f.orientable = true;
    for (const auto& [e, users] : at)
      if (users.size() == 2)
        f.orientable = f.orientable && (users[0].second != ((flips >> users[0].first) & 1)) != (users[1].second != ((flips >> users[1].first) & 1));
  }
  return f;
}

}  // namespace

TEST_CASE_TEMPLATE("validate: archetypes have the same report", M, CONCINO_ALL_KINDS) {
  M m = two_grids<M>(2);
  set_point(m, vert_id{1}, vec3{0, std::nan(""), 0});
  set_point(m, vert_id{num_verts(m) - 2}, point(m, vert_id{num_verts(m) - 3}));
  const auto r = validate(m);
  CHECK(r.count() >= 3);
  const auto weak = only_embedded_mesh(m);
  const auto w = validate(weak);
  const auto bare = validate(only_mesh(m));
  for (std::size_t k = 0; k < num_defect_kinds; ++k) CHECK(r.count(defect_kind(k)) == w.count(defect_kind(k)));
  REQUIRE(w.size() == r.size());
  for (std::size_t i = 0; i < r.size(); ++i) CHECK(r[i].what == w[i].what);
  CHECK(bare.count() == 1);  // without points only the isolated vert is a defect
  CHECK(bare.facts.components == 2);
}

TEST_CASE_TEMPLATE("validate: agrees with a brute-force check on random surfaces", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(7);
  std::size_t one_sided = 0;
  for (int round = 0; round < 150; ++round) {
    const unsigned vert_count = 5 + (round % 2 ? static_cast<unsigned>(random() % 5) : 0), poly_count = 1 + static_cast<unsigned>(random() % 8);
    auto s = random_soup<M>(random, vert_count, poly_count);
    if (round % 10 == 0) s.verts.push_back(s.verts.front());
    if (round == 4 && arity_v<M> == 3) s.verts = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};  // a Moebius strip
    const slow_facts f = look_slowly(s.verts, vert_count);
    const auto r = validate(s.mesh());
    CHECK(r.count(defect_kind::non_manifold_edge) == f.bad_edges);
    CHECK(r.count(defect_kind::non_manifold_vert) == f.bad_verts);
    CHECK(r.count(defect_kind::isolated_vert) == f.isolated);
    CHECK(r.count(defect_kind::duplicated_element) == f.duplicates);
    CHECK(r.facts.components == f.components);
    CHECK(r.facts.boundary_loops == f.loops);
    CHECK(r.facts.euler_characteristic == f.chi);
    CHECK(r.facts.closed == f.closed);
    CHECK(r.facts.orientable == f.orientable);
    CHECK((r.count(defect_kind::not_orientable) == 0) == f.orientable);
    CHECK(r.facts.manifold == (f.bad_edges + f.bad_verts == 0));
    one_sided += !f.orientable;
  }
  CHECK(one_sided > 0);
}

TEST_CASE_TEMPLATE("validate: random lists of polys are reported and never throw", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    const unsigned vert_count = 9 + static_cast<unsigned>(random() % 6), poly_count = 1 + static_cast<unsigned>(random() % 12);
    const auto s = random_soup<M>(random, vert_count, poly_count);
    M m = s.mesh();
    for (const vert_id v : verts(m)) {
      if (random() % 7 == 0) set_point(m, v, vec3{1e300, -1e300, 1e-300});
      if (random() % 7 == 0) set_point(m, v, vec3{std::numeric_limits<double>::infinity(), 0, std::nan("")});
      if (random() % 7 == 0) set_point(m, v, point(m, vert_id{0}));
    }
    const auto r = validate(m);
    for (std::size_t i = 0; i < r.size(); ++i) {
      CHECK(r[i].what.size() > 15);
      if (i > 0) CHECK(r[i - 1].kind <= r[i].kind);
    }
    if (r.facts.genus) CHECK(r.facts.manifold);
  }
}

TEST_CASE_TEMPLATE("validate: works on meshes with removed elements", M, CONCINO_ALL_KINDS) {
  M m = grid<M>(3);
  remove_poly(m, poly_id{1});
  for (const auto& d : validate(m)) CHECK((d.kind == defect_kind::isolated_vert || d.kind == defect_kind::unreferenced_face));
  CHECK(validate(m).facts.manifold);
}

TEST_CASE_TEMPLATE("validate: does not depend on the scale", M, CONCINO_ALL_KINDS) {
  auto arrays = jittered(grid_arrays<M>(3), 0.02);
  arrays.points[1] = arrays.points[0];
  arrays.points[5] = arrays.points[5] + vec3{0.9, 0.4, -0.2};
  const auto r = validate(M(arrays));
  CHECK(r.count() > 0);
  for (const int exponent : {-1000, -500, -100, 100, 500, 1020}) {
    auto scaled = arrays;
    for (vec3& p : scaled.points) p *= std::ldexp(1.0, exponent);
    const auto s = validate(M(scaled));
    CHECK(s.count() == r.count());
    REQUIRE(s.size() == r.size());
    for (std::size_t i = 0; i < r.size(); ++i) CHECK(s[i].what == r[i].what);
    const auto tolerant = validate(M(scaled), {.length_tolerance = 0.1, .size_tolerance = 1e-3});
    const auto same = validate(M(arrays), {.length_tolerance = 0.1, .size_tolerance = 1e-3});
    CHECK(tolerant.count(defect_kind::zero_size) == same.count(defect_kind::zero_size));
    CHECK(same.count(defect_kind::zero_size) >= r.count(defect_kind::zero_size));
  }
  auto extreme = arrays;
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  for (std::size_t i = 0; i < extreme.points.size(); ++i) extreme.points[i] = {i % 3 == 0 ? most : -most, i % 2 == 0 ? least : most, i % 5 == 0 ? 0 : -least};
  CHECK(validate(M(extreme)).count(defect_kind::non_finite_point) == 0);
}

