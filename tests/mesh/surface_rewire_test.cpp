// rewire of the native surfaces: after any replacement of polys the mesh obeys all laws and equals a newly constructed mesh, what is not in the cavity keeps
// its descriptors, and a cavity that is refused changes nothing.
#include <concino/concepts/editable.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

namespace {

/// A cavity with its arrays.
struct owned_cavity {
  std::vector<cn::poly_id> polys;
  std::vector<cn::vert_id> verts;
  std::vector<cn::vec3> points;
  std::vector<unsigned> corners, ends;
  std::size_t kept = 0, removed = 0;

  void add_poly(const std::vector<unsigned>& v) {
    corners.insert(corners.end(), v.begin(), v.end());
    ends.push_back(static_cast<unsigned>(corners.size()));
  }

  struct made {
    std::vector<cn::vert_id> verts;
    std::vector<cn::poly_id> polys;
  };
  template<class M>
  made apply_to(M& m) const {
    const auto all = [](const auto& x) { return cn::id_span<typename std::remove_cvref_t<decltype(x)>::value_type>(x.data(), x.data() + x.size()); };
    made names{std::vector<cn::vert_id>(points.size()), std::vector<cn::poly_id>(ends.size())};
    cn::rewire(m, {all(polys), all(verts), all(points), all(corners), all(ends), {}, kept, removed}, {names.verts.data(), names.polys.data()});
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
  std::vector<cn::poly_id> polys;
  for (const auto p : cn::polys(m)) polys.push_back(p);
  for (auto i = random() % 4; i > 0 && !polys.empty(); --i) c.polys.push_back(take(polys, random));
  std::set<unsigned> used;
  for (const auto p : c.polys)
    for (const auto v : cn::adj_p2v(m, p)) used.insert(v.raw());
  for (const auto v : cn::verts(m))
    if (random() % 6 == 0) used.insert(v.raw());
  c.points.resize(random() % 3, cn::vec3{1, 2, 3});

  // Verts without other polys can be removed; they come last.
  std::vector<cn::vert_id> last;
  for (const unsigned i : used) {
    const cn::vert_id v{i};
    bool free = true;
    for (const auto p : cn::adj_v2p(m, v)) free = free && std::find(c.polys.begin(), c.polys.end(), p) != c.polys.end();
    (free && random() % 2 == 0 ? last : c.verts).push_back(v);
  }
  std::shuffle(c.verts.begin(), c.verts.end(), random);
  std::vector<unsigned> usable;
  for (unsigned i = 0; i < c.verts.size(); ++i) usable.push_back(i);
  c.verts.insert(c.verts.end(), last.begin(), last.end());
  c.removed = last.size();
  for (unsigned i = 0; i < c.points.size(); ++i) usable.push_back(static_cast<unsigned>(c.verts.size()) + i);
  for (auto i = random() % 5; i > 0; --i) {
    const unsigned n = cn::arity_v<M> ? cn::arity_v<M> : 3 + static_cast<unsigned>(random() % 5);
    if (n > usable.size()) break;
    std::vector<unsigned> v;
    for (const unsigned k : cn::testing::some_of(random, static_cast<unsigned>(usable.size()), n)) v.push_back(usable[k]);
    c.add_poly(v);
  }
  c.kept = random() % (1 + std::min(c.polys.size(), c.ends.size()));
  return c;
}

/// The verts of every poly, and the ends of every edge.
template<class M>
std::map<unsigned, std::vector<unsigned>> poly_verts(const M& m) {
  std::map<unsigned, std::vector<unsigned>> all;
  for (const auto p : cn::polys(m)) all[p.raw()] = raw(cn::adj_p2v(m, p));
  return all;
}
template<class M>
std::map<std::vector<unsigned>, unsigned> edge_between(const M& m) {
  std::map<std::vector<unsigned>, unsigned> all;
  for (const auto e : cn::edges(m)) all[raw(cn::adj_e2v(m, e))] = e.raw();
  return all;
}

/// Applies c, and checks that it does what the laws ED1, ED2, ED3 and ED5 say.
template<class M>
void rewires_as_told(M& m, const owned_cavity& c) {
  const auto polys_before = poly_verts(m);
  const auto edges_before = edge_between(m);
  const std::size_t verts_before = cn::num_verts(m);
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
  for (const auto& [ends, e] : edge_between(m))
    if (const auto before = edges_before.find(ends); before != edges_before.end()) CHECK(before->second == e);
  CHECK(cn::num_verts(m) == verts_before + c.points.size() - c.removed);
  for (std::size_t i = 0; i < c.verts.size(); ++i) CHECK(cn::contains(m, c.verts[i]) == (i + c.removed < c.verts.size()));
  for (std::size_t i = 0; i < c.points.size(); ++i) CHECK(cn::to_vec3(cn::point(m, made.verts[i])) == c.points[i]);
}

template<class M>
M strip() {  // three polys in a row
  return cn::testing::grid<M>(3);
}

template<class M>
void refuses(const owned_cavity& c, const char* message) {
  M m = strip<M>();
  const auto before = cn::testing::whole(m);
  CHECK_THROWS_WITH_AS(c.apply_to(m), message, cn::invalid_mesh);
  CHECK(cn::testing::whole(m) == before);
}

}  // namespace

TEST_CASE_TEMPLATE("rewire: random cavities of random meshes give the mesh that they describe", M, CONCINO_ALL_SURFACE_KINDS) {
  std::mt19937 random(11);
  const unsigned rounds = cn::testing::long_run() ? 300 : 12;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = round % 2 ? cn::testing::grid<M>(3) : cn::testing::random_soup<M>(random, 12, 14).mesh();
    for (unsigned step = 0; step < 40; ++step) {
      rewires_as_told(m, random_cavity(m, random));
      if (step % 4 == 0) keeps_all_laws(m);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("rewire: long polygons, many of them at one edge") {
  std::mt19937 random(12);
  for (unsigned round = 0; round < 6; ++round) {
    cn::polygonmesh m(std::vector<cn::vec3>(60), std::vector<std::vector<unsigned>>{});
    for (unsigned step = 0; step < 12; ++step) {
      owned_cavity c;
      for (unsigned i = 0; i < 60; ++i) c.verts.push_back(cn::vert_id{i});
      for (const auto p : cn::polys(m))
        if (random() % 3 == 0) c.polys.push_back(p);
      for (auto i = random() % 4; i > 0; --i) {
        std::vector<unsigned> v = cn::testing::some_of(random, 60, 3 + static_cast<unsigned>(random() % 50));
        if (random() % 2 == 0) std::sort(v.begin(), v.end());
        c.add_poly(v);
      }
      c.kept = random() % (1 + std::min(c.polys.size(), c.ends.size()));
      rewires_as_told(m, c);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("rewire: an edge of old polys that no poly has afterwards gives its descriptor to a new edge") {
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  owned_cavity c{{cn::poly_id{0}, cn::poly_id{1}}, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}, cn::vert_id{3}}, {}, {}, {}, 2, 0};
  c.add_poly({0, 1, 3});
  c.add_poly({1, 2, 3});
  for (unsigned round = 0; round < 5; ++round) {
    rewires_as_told(m, c);
    CHECK(cn::edge_index_bound(m) == 5);
    CHECK(cn::poly_index_bound(m) == 2);
    owned_cavity back = c;
    back.corners.clear(), back.ends.clear();
    back.add_poly({0, 1, 2});
    back.add_poly({0, 2, 3});
    rewires_as_told(m, back);
  }
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("rewire: a cavity with a mistake is refused, and nothing changes", M, CONCINO_SURFACE_KINDS) {
  const M m = strip<M>();
  owned_cavity good;
  good.polys = {cn::poly_id{0}};
  for (const auto v : cn::adj_p2v(m, cn::poly_id{0})) good.verts.push_back(v);
  std::vector<unsigned> all;
  for (unsigned i = 0; i < good.verts.size(); ++i) all.push_back(i);
  good.add_poly(all);
  good.kept = 1;
  {
    M same = m;
    good.apply_to(same);
    equals_rebuilt(same);
  }
  const auto with = [&](const auto& change) {
    owned_cavity c = good;
    change(c);
    return c;
  };
  const std::string n = std::to_string(good.verts.size());
  refuses<M>(with([](auto& c) { c.polys = {cn::poly_id{999}}; }), "rewire: old poly 999 is not a poly of the mesh");
  refuses<M>(with([](auto& c) { c.polys.push_back(c.polys[0]); }), "rewire: old poly 0 is listed twice; list it once");
  refuses<M>(with([](auto& c) { c.verts.push_back(cn::vert_id{999}); }), "rewire: vert 999 of the cavity is not a vert of the mesh");
  refuses<M>(with([](auto& c) { c.verts.push_back(cn::vert_id{0}); }), "rewire: vert 0 of the cavity is listed twice; list it once");
  refuses<M>(with([](auto& c) { c.kept = 2; }), "rewire: 2 polys cannot keep their descriptors: there are 1 old and 1 new ones");
  refuses<M>(with([](auto& c) { c.removed = 9; }), ("rewire: 9 verts cannot be removed: the cavity lists " + n).c_str());
  refuses<M>(with([](auto& c) { c.corners[1] = c.corners[0]; }), "rewire: new poly 0 has vert 0 of the cavity twice; its verts must differ");
  refuses<M>(with([](auto& c) { c.corners[1] = 99; }), ("rewire: new poly 0 names vert 99 of the cavity, which has " + n + ", numbered from 0").c_str());
  refuses<M>(with([](auto& c) { c.ends[0] = 99; }), ("rewire: the corners of new poly 0 end at 99, which is not between 0 and " + n).c_str());
  owned_cavity lacking = good;
  const unsigned left_out = lacking.verts.back().raw();
  lacking.verts.pop_back(), lacking.corners.clear(), lacking.ends.clear(), lacking.kept = 0;
  refuses<M>(lacking, ("rewire: vert " + std::to_string(left_out) + " of old poly 0 is not among the verts of the cavity; list all verts of old and new polys").c_str());
  owned_cavity in_use = good;
  in_use.corners.clear(), in_use.ends.clear(), in_use.kept = 0, in_use.removed = in_use.verts.size();
  M copy = m;
  CHECK_THROWS_AS(in_use.apply_to(copy), cn::invalid_mesh);
  CHECK(cn::testing::whole(copy) == cn::testing::whole(m));
  CHECK_THROWS_AS(with([](auto& c) { c.removed = 1; }).apply_to(copy), cn::invalid_mesh);
}
