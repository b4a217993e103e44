// Random cavities for `rewire`, and checks that a mesh is as the laws of `rewire` say afterwards.
#pragma once

#include <concino/core/error.hpp>
#include <concino/mesh.hpp>

#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace concino::testing {

/// A cavity with its arrays.
struct owned_cavity {
  std::vector<poly_id> polys;
  std::vector<vert_id> verts;
  std::vector<vec3> points;
  std::vector<unsigned> corners, ends;
  std::size_t kept = 0, removed = 0;
  std::vector<unsigned> poly_ends = {};

  std::size_t num_new() const { return poly_ends.empty() ? ends.size() : poly_ends.size(); }
  void add_poly(const std::vector<unsigned>& v) {
    corners.insert(corners.end(), v.begin(), v.end());
    ends.push_back(static_cast<unsigned>(corners.size()));
  }

  struct made {
    std::vector<vert_id> verts;
    std::vector<poly_id> polys;
  };
  template<class M>
  made apply_to(M& m) const {
    const auto all = [](const auto& x) { return id_span<typename std::remove_cvref_t<decltype(x)>::value_type>(x.data(), x.data() + x.size()); };
    made names{std::vector<vert_id>(points.size()), std::vector<poly_id>(num_new())};
    rewire(m, {all(polys), all(verts), all(points), all(corners), all(ends), all(poly_ends), kept, removed}, {names.verts.data(), names.polys.data()});
    return names;
  }
};

template<class T>
T take(std::vector<T>& all, std::mt19937& random) {
  const std::size_t i = random() % all.size();
  const T x = all[i];
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
  return x;
}

/// Some polys, all their verts and a few others, new points, and new polys on random ones of these verts.
template<class M>
owned_cavity random_cavity(const M& m, std::mt19937& random) {
  owned_cavity c;
  std::vector<poly_id> polys;
  for (const auto p : concino::polys(m)) polys.push_back(p);
  for (auto i = random() % 4; i > 0 && !polys.empty(); --i) c.polys.push_back(take(polys, random));
  const bool connected = random() % 2 == 0;
  for (std::size_t i = 0; connected && i < c.polys.size() && c.polys.size() < 6; ++i)
    for (const auto q : adj_p2p(m, c.polys[i]))
      if (std::find(c.polys.begin(), c.polys.end(), q) == c.polys.end() && random() % 2 == 0) c.polys.push_back(q);
  std::set<unsigned> used;
  for (const auto p : c.polys)
    for (const auto v : adj_p2v(m, p)) used.insert(v.raw());
  for (const auto v : verts(m))
    if (random() % 6 == 0) used.insert(v.raw());
  c.points.resize(random() % 3, vec3{1, 2, 3});

  // Verts without other polys can be removed; they come last.
  std::vector<vert_id> last;
  for (const unsigned i : used) {
    const vert_id v{i};
    bool free = true;
    for (const auto p : adj_v2p(m, v)) free = free && std::find(c.polys.begin(), c.polys.end(), p) != c.polys.end();
    (free && random() % 2 == 0 ? last : c.verts).push_back(v);
  }
  std::shuffle(c.verts.begin(), c.verts.end(), random);
  std::vector<unsigned> usable;
  for (unsigned i = 0; i < c.verts.size(); ++i) usable.push_back(i);
  c.verts.insert(c.verts.end(), last.begin(), last.end());
  c.removed = last.size();
  for (unsigned i = 0; i < c.points.size(); ++i) usable.push_back(static_cast<unsigned>(c.verts.size()) + i);
  for (auto i = random() % 5; i > 0; --i) {
    const unsigned n = arity_v<M> ? arity_v<M> : 3 + static_cast<unsigned>(random() % 5);
    if (n > usable.size()) break;
    std::vector<unsigned> v;
    for (const unsigned k : some_of(random, static_cast<unsigned>(usable.size()), n)) v.push_back(usable[k]);
    c.add_poly(v);
  }
  c.kept = random() % (1 + std::min(c.polys.size(), c.ends.size()));
  return c;
}

/// The verts of every poly, and the ends of every edge.
template<class M>
std::map<unsigned, std::vector<unsigned>> poly_verts(const M& m) {
  std::map<unsigned, std::vector<unsigned>> all;
  for (const auto p : concino::polys(m)) all[p.raw()] = raw(adj_p2v(m, p));
  return all;
}
template<class M>
std::map<std::vector<unsigned>, unsigned> edge_between(const M& m) {
  std::map<std::vector<unsigned>, unsigned> all;
  for (const auto e : edges(m)) all[raw(adj_e2v(m, e))] = e.raw();
  return all;
}
/// The cyclic order of the verts of every face, from the smallest to the smaller of its neighbours.
template<class M>
std::map<std::vector<unsigned>, unsigned> face_between(const M& m) {
  std::map<std::vector<unsigned>, unsigned> all;
  for (const auto f : faces(m)) {
    std::vector<unsigned> v = raw(adj_f2v(m, f));
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    if (v.back() < v[1]) std::reverse(v.begin() + 1, v.end());
    CHECK(all.emplace(v, f.raw()).second);
  }
  return all;
}

template<class Elements>
void common_ones_are_equal(const Elements& before, const Elements& after) {
  for (const auto& [verts, x] : after)
    if (const auto old = before.find(verts); old != before.end()) CHECK(old->second == x);
}

/// Applies c, and checks that it does what the laws ED1, ED2, ED3 and ED5 say.
template<class M>
auto rewires_as_told(M& m, const owned_cavity& c) {
  const auto polys_before = poly_verts(m);
  const auto edges_before = edge_between(m);
  std::map<std::vector<unsigned>, unsigned> faces_before;
  if constexpr (VolumeMesh<M>) faces_before = face_between(m);
  const std::size_t verts_before = num_verts(m);
  const auto made = c.apply_to(m);
  auto expected = polys_before;
  for (const auto p : c.polys) expected.erase(p.raw());
  unsigned first = 0;
  for (std::size_t k = 0; k < c.ends.size(); ++k) {
    if (k < c.kept) CHECK(made.polys[k] == c.polys[k]);
    else CHECK(polys_before.count(made.polys[k].raw()) == 0);
    std::vector<unsigned>& v = expected[made.polys[k].raw()];
    for (; first < c.ends[k]; ++first) v.push_back((c.corners[first] < c.verts.size() ? c.verts[c.corners[first]] : made.verts[c.corners[first] - c.verts.size()]).raw());
  }
  CHECK(poly_verts(m) == expected);
  common_ones_are_equal(edges_before, edge_between(m));
  if constexpr (VolumeMesh<M>) common_ones_are_equal(faces_before, face_between(m));
  CHECK(num_verts(m) == verts_before + c.points.size() - c.removed);
  for (std::size_t i = 0; i < c.verts.size(); ++i) CHECK(contains(m, c.verts[i]) == (i + c.removed < c.verts.size()));
  for (std::size_t i = 0; i < c.points.size(); ++i) CHECK(to_vec3(point(m, made.verts[i])) == c.points[i]);
  return made;
}

/// Checks that c is refused, and that m is unchanged.
template<class M>
void refuses_cavity(const M& m, const owned_cavity& c, const std::string& message) {
  M copy = m;
  CHECK_THROWS_WITH_AS(c.apply_to(copy), message.c_str(), invalid_mesh);
  CHECK(whole(copy) == whole(m));
}

/// Checks all messages about mistakes in a cavity. m: at least two polys, the first of which shares verts with others.
template<class M>
void refuses_mistakes(const M& m) {
  owned_cavity good;
  good.polys = {poly_id{0}};
  for (const auto v : adj_p2v(m, poly_id{0})) good.verts.push_back(v);
  std::vector<unsigned> all;
  for (unsigned i = 0; i < good.verts.size(); ++i) all.push_back(i);
  good.add_poly(all);
  good.kept = 1;
  M same = m;
  good.apply_to(same);
  equals_rebuilt(same);
  const auto refuses = [&](const auto& change, const std::string& message) {
    owned_cavity c = good;
    change(c);
    refuses_cavity(m, c, message);
  };
  const std::string n = std::to_string(good.verts.size()), first = std::to_string(good.verts[0].raw()), last = std::to_string(good.verts.back().raw());
  refuses([](auto& c) { c.polys = {poly_id{999}}; }, "rewire: old poly 999 is not a poly of the mesh");
  refuses([](auto& c) { c.polys.push_back(c.polys[0]); }, "rewire: old poly 0 is listed twice; list it once");
  refuses([](auto& c) { c.verts.push_back(vert_id{999}); }, "rewire: vert 999 of the cavity is not a vert of the mesh");
  refuses([](auto& c) { c.verts.push_back(c.verts[0]); }, "rewire: vert " + first + " of the cavity is listed twice; list it once");
  refuses([](auto& c) { c.kept = 2; }, "rewire: 2 polys cannot keep their descriptors: there are 1 old and 1 new ones");
  refuses([](auto& c) { c.removed = 9; }, "rewire: 9 verts cannot be removed: the cavity lists " + n);
  refuses([](auto& c) { c.corners[1] = c.corners[0]; }, "rewire: new poly 0 has vert 0 of the cavity twice; its verts must differ");
  refuses([](auto& c) { c.corners[1] = 99; }, "rewire: new poly 0 names vert 99 of the cavity, which has " + n + ", numbered from 0");
  refuses([](auto& c) { c.ends[0] = 99; }, "rewire: the corners of new poly 0 end at 99, which is not between 0 and " + n);
  refuses([](auto& c) { c.ends[0] = 2; },
          arity_v<M> ? "rewire: new poly 0 has 2 verts; every poly of this mesh has " + std::to_string(arity_v<M>) : "rewire: new poly 0 has 2 verts; it needs at least 3");
  refuses([](auto& c) { c.verts.pop_back(), c.corners.clear(), c.ends.clear(), c.kept = 0; },
          "rewire: vert " + last + " of old poly 0 is not among the verts of the cavity; list all verts of old and new polys");
  const std::string in_use = " cannot be removed: it would still have a poly; list all its polys as old polys, and use it in no new one";
  refuses([](auto& c) { c.removed = 1; }, "rewire: vert " + last + in_use);
  unsigned shared = 0;  // the first vert of the poly that has others
  while (num_elements(adj_v2p(m, good.verts[shared])) == 1) ++shared;
  refuses([](auto& c) { c.corners.clear(), c.ends.clear(), c.kept = 0, c.removed = c.verts.size(); }, "rewire: vert " + std::to_string(good.verts[shared].raw()) + in_use);
}

}  // namespace concino::testing
