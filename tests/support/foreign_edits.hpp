// Edits of surfaces of other libraries, for tests of their adapters: states that can be compared, random cavities, and whether half-edges can represent the
// result by the definition.
#pragma once

#include <concino/edit.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace concino::testing {

/// Descriptors, adjacencies in their order, and points.
template<class M>
std::vector<double> foreign_state(const M& m) {
  std::vector<double> all;
  const auto list = [&](const auto& range) {
    all.push_back(-1);
    for (const auto x : range) all.push_back(static_cast<double>(index_of(m, x)));
  };
  list(verts(m)), list(edges(m)), list(polys(m));
  for (const auto v : verts(m)) {
    list(adj_v2v(m, v)), list(adj_v2e(m, v)), list(adj_v2p(m, v));
    const vec3 x = to_vec3(point(m, v));
    all.insert(all.end(), {x.x, x.y, x.z});
  }
  for (const auto e : edges(m)) list(adj_e2v(m, e)), list(adj_e2p(m, e));
  for (const auto p : polys(m)) list(adj_p2v(m, p)), list(adj_p2e(m, p)), list(adj_p2p(m, p));
  return all;
}

template<class M>
void foreign_laws_hold(const M& m) {
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
}

/// The polys as lists of indices of verts, by their own index.
template<class M>
std::map<std::size_t, std::vector<std::size_t>> foreign_polys(const M& m) {
  std::map<std::size_t, std::vector<std::size_t>> all;
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) all[index_of(m, p)].push_back(index_of(m, v));
  return all;
}
/// The edges by the indices of their ends.
template<class M>
std::map<std::set<std::size_t>, std::size_t> foreign_edges(const M& m) {
  std::map<std::set<std::size_t>, std::size_t> all;
  for (const auto e : edges(m)) {
    std::set<std::size_t> ends;
    for (const auto v : adj_e2v(m, e)) ends.insert(index_of(m, v));
    CHECK(all.emplace(ends, index_of(m, e)).second);
  }
  return all;
}

/// Whether half-edges can represent these polys: no two go from one vert to another, and at each vert their fans are open, or there is one closed fan.
inline bool are_representable(const std::map<std::size_t, std::vector<std::size_t>>& polys) {
  std::set<std::pair<std::size_t, std::size_t>> directed;
  std::map<std::size_t, std::map<std::size_t, std::size_t>> fans;  // at each vert: from the vert after it in a poly to the vert before it
  for (const auto& [p, v] : polys)
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (!directed.emplace(v[i], v[(i + 1) % v.size()]).second) return false;
      fans[v[i]][v[(i + 1) % v.size()]] = v[(i + v.size() - 1) % v.size()];
    }
  for (const auto& [v, next] : fans) {
    std::set<std::size_t> open, images;
    for (const auto& [from, to] : next) images.insert(to);
    for (const auto& [from, to] : next)
      if (!images.count(from))
        for (std::size_t at = from; next.count(at); at = next.at(at)) open.insert(at);
    if (open.size() == next.size()) continue;
    if (!open.empty()) return false;
    std::size_t n = 0, at = next.begin()->first;
    do at = next.at(at), ++n;
    while (at != next.begin()->first);
    if (n != next.size()) return false;
  }
  return true;
}

/// A cavity with its arrays.
template<class M>
struct foreign_cavity {
  std::vector<poly_t<M>> old;
  std::vector<vert_t<M>> verts;
  std::vector<vec3> points;
  std::vector<unsigned> corners, ends;
  std::size_t kept = 0, removed = 0;

  template<class T>
  static id_span<T> span(const std::vector<T>& x) {
    return {x.data(), x.data() + x.size()};
  }
  cavity<M> lists() const { return {span(old), span(verts), span(points), span(corners), span(ends), {}, kept, removed}; }
};

/// A few neighbouring polys and new ones, most of them on verts in the order of the old ones' boundary.
template<class M>
foreign_cavity<M> random_foreign_cavity(const M& m, std::mt19937& random) {
  foreign_cavity<M> c;
  std::vector<poly_t<M>> all;
  for (const auto p : concino::polys(m)) all.push_back(p);
  if (!all.empty() && random() % 8 != 0) c.old.push_back(all[random() % all.size()]);
  for (std::size_t i = 0; i < c.old.size() && c.old.size() < 5; ++i)
    for (const auto q : adj_p2p(m, c.old[i]))
      if (random() % 2 == 0 && std::find(c.old.begin(), c.old.end(), q) == c.old.end()) c.old.push_back(q);
  std::vector<vert_t<M>> used;
  const auto use = [&](const auto& v) {
    if (std::find(used.begin(), used.end(), v) == used.end()) used.push_back(v);
  };
  for (const auto& p : c.old)
    for (const auto v : adj_p2v(m, p)) use(v);
  for (const auto v : concino::verts(m))
    if (random() % 20 == 0) use(v);
  std::vector<vert_t<M>> last;
  for (const auto& v : used) {
    bool is_free = true;
    for (const auto p : adj_v2p(m, v)) is_free = is_free && std::find(c.old.begin(), c.old.end(), p) != c.old.end();
    (is_free && random() % 3 == 0 ? last : c.verts).push_back(v);
  }
  const auto usable = static_cast<unsigned>(c.verts.size());
  c.points.resize(random() % 3, vec3{1, 2, 3});
  for (const auto& v : last) c.verts.push_back(v);
  c.removed = last.size();
  const auto local = [&](unsigned i) { return i < usable ? i : static_cast<unsigned>(c.verts.size()) + i - usable; };
  const unsigned count = usable + static_cast<unsigned>(c.points.size());
  for (unsigned k = static_cast<unsigned>(random() % 5); k > 0; --k) {
    std::vector<unsigned> v;
    const auto& old = c.old.empty() ? std::vector<vert_t<M>>() : [&] {
      std::vector<vert_t<M>> corners;
      for (const auto x : adj_p2v(m, c.old[random() % c.old.size()])) corners.push_back(x);
      return corners;
    }();
    if (random() % 4 != 0)  // an old poly, perhaps with another vert
      for (const auto& x : old) {
        const auto at = static_cast<unsigned>(std::find(c.verts.begin(), c.verts.end(), x) - c.verts.begin());
        if (at < usable) v.push_back(at);
      }
    if (v.empty() && count >= 3) v = some_of(random, count, 3);
    if (!v.empty() && count > 0 && random() % 2 == 0) v[random() % v.size()] = static_cast<unsigned>(random() % count);
    if (v.size() < 3 || (arity_v<M> && v.size() != static_cast<std::size_t>(arity_v<M>)) || std::set<unsigned>(v.begin(), v.end()).size() != v.size()) continue;
    for (const unsigned i : v) c.corners.push_back(local(i));
    c.ends.push_back(static_cast<unsigned>(c.corners.size()));
  }
  c.kept = random() % (1 + std::min(c.old.size(), c.ends.size()));
  return c;
}

/// Applies a cavity and checks the laws ED1 to ED5. Returns whether it was applied, which is so if half-edges can represent the result.
template<class M>
bool rewires_by_the_laws(M& m, const foreign_cavity<M>& c) {
  const auto state = foreign_state(m);
  auto expected = foreign_polys(m);
  const auto edges_before = foreign_edges(m);
  const std::size_t verts_before = num_verts(m);
  for (const auto& p : c.old) expected.erase(index_of(m, p));
  const auto others = expected;
  const auto lists_of = [&](const auto& vert_index, const auto& poly_index) {
    unsigned i = 0;
    for (std::size_t k = 0; k < c.ends.size(); ++k)
      for (; i < c.ends[k]; ++i) expected[poly_index(k)].push_back(c.corners[i] < c.verts.size() ? index_of(m, c.verts[c.corners[i]]) : vert_index(c.corners[i] - c.verts.size()));
  };
  lists_of([](std::size_t i) { return 1000000 + i; }, [](std::size_t k) { return 1000000 + k; });
  const bool representable = are_representable(expected);
  CHECK((traits<M>::why_not_rewire(m, c.lists()) == nullptr) == representable);
  std::vector<vert_t<M>> new_verts(c.points.size());
  std::vector<poly_t<M>> new_polys(c.ends.size());
  try {
    rewire(m, c.lists(), {new_verts.data(), new_polys.data()});
  } catch (const unsupported&) {
    CHECK_FALSE(representable);
    CHECK(foreign_state(m) == state);
    return false;
  }
  CHECK(representable);
  expected = others;
  lists_of([&](std::size_t i) { return index_of(m, new_verts[i]); }, [&](std::size_t k) { return index_of(m, new_polys[k]); });
  CHECK(foreign_polys(m) == expected);
  for (std::size_t k = 0; k < c.kept; ++k) CHECK(new_polys[k] == c.old[k]);
  for (const auto& [ends, e] : foreign_edges(m))
    if (const auto before = edges_before.find(ends); before != edges_before.end()) CHECK(before->second == e);
  CHECK(num_verts(m) == verts_before + c.points.size() - c.removed);
  for (std::size_t i = 0; i < c.verts.size(); ++i) CHECK(contains(m, c.verts[i]) == (i + c.removed < c.verts.size()));
  for (const auto& v : new_verts) CHECK(to_vec3(point(m, v)) == vec3{1, 2, 3});
  return true;
}

}  // namespace concino::testing
