// The six native meshes: construction, errors, and all adjacencies on any soup of polys.
#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/kinds.hpp>
#include <support/soups.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <thread>

namespace cn = concino;

namespace {

template<class M>
void keeps_all_laws(const M& m) {
  for (const auto& b : cn::check_laws(m)) FAIL_CHECK(b.law << ": " << b.what << " [" << b.witness << "]");
}

template<class R>
std::set<unsigned> raw_set(const R& range) {
  std::set<unsigned> all;
  for (const auto x : range) all.insert(x.raw());
  return all;
}

/// The facets of polys as sets of verts, computed without the tested tables.
template<class M>
std::vector<std::set<std::set<unsigned>>> sides_of_polys(const cn::testing::soup<M>& s) {
  std::vector<std::set<std::set<unsigned>>> all;
  if constexpr (cn::SurfaceMesh<M>) {
    for (const auto& verts : s.verts) {
      all.emplace_back();
      for (std::size_t i = 0; i < verts.size(); ++i) all.back().insert({verts[i], verts[(i + 1) % verts.size()]});
    }
  } else if constexpr (cn::TetMesh<M>) {
    for (const auto& v : s.verts) all.push_back({{v[0], v[1], v[2]}, {v[0], v[1], v[3]}, {v[0], v[2], v[3]}, {v[1], v[2], v[3]}});
  } else if constexpr (cn::HexMesh<M>) {
    // Two quads with the same verts are the same face only if their cyclic orders are equal. The diagonals distinguish these.
    const auto quad = [](unsigned a, unsigned b, unsigned c, unsigned d) {
      return std::set<unsigned>{a, b, c, d, 1000 * (1 + std::min(a, c)) + std::max(a, c), 1000 * (1 + std::min(b, d)) + std::max(b, d)};
    };
    for (const auto& v : s.verts)
      all.push_back({quad(v[0], v[1], v[2], v[3]), quad(v[4], v[5], v[6], v[7]), quad(v[0], v[1], v[5], v[4]), quad(v[1], v[2], v[6], v[5]),
                     quad(v[2], v[3], v[7], v[6]), quad(v[3], v[0], v[4], v[7])});
  } else {
    for (const auto& faces : s.poly_faces) {
      all.emplace_back();
      for (const auto& [f, outward] : faces) all.back().insert({1000000 + f});  // polyhedra share faces by id, not by verts
    }
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("native meshes: represent any soup of polys", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(2);
  for (unsigned round = 0; round < 120; ++round) {
    const unsigned vert_count = 8 + static_cast<unsigned>(random() % 12), poly_count = 1 + static_cast<unsigned>(random() % 24);
    const auto soup = cn::testing::random_soup<M>(random, vert_count, poly_count);
    const M m = soup.mesh();
    REQUIRE(cn::num_verts(m) == vert_count);
    REQUIRE(cn::num_polys(m) == poly_count);
    keeps_all_laws(m);
    const auto sides = sides_of_polys(soup);
    for (unsigned p = 0; p < poly_count; ++p) {
      std::set<unsigned> expected;
      for (unsigned q = 0; q < poly_count; ++q)
        for (const auto& side : sides[p])
          if (q != p && sides[q].count(side)) expected.insert(q);
      CHECK(raw_set(cn::adj_p2p(m, cn::poly_id{p})) == expected);
      std::vector<cn::poly_id> by_iterators, by_call;
      for (const auto q : cn::adj_p2p(m, cn::poly_id{p})) by_iterators.push_back(q);
      cn::adj_p2p(m, cn::poly_id{p}).for_each([&](cn::poly_id q) { by_call.push_back(q); });
      CHECK(by_call == by_iterators);
    }
  }
}

TEST_CASE_TEMPLATE("native meshes: keep the order of verts in polys", M, cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(3);
  const auto soup = cn::testing::random_soup<M>(random, 20, 30);
  const M m = soup.mesh();
  for (unsigned p = 0; p < 30; ++p) {
    std::vector<unsigned> found;
    for (const auto v : cn::adj_p2v(m, cn::poly_id{p})) found.push_back(v.raw());
    CHECK(found == soup.verts[p]);
  }
}

TEST_CASE("adj_e2p: closed and open fans of tets are right") {
  // Each entry is a ring (closed) or fan (open) of that many tets around the edge 0-1.
  struct fan { unsigned tets; bool closed; };
  const std::vector<std::vector<fan>> cases = {{{3, true}},           {{5, true}},           {{6, true}},           {{7, true}},
                                               {{3, true}, {3, true}}, {{3, true}, {4, true}}, {{4, true}, {3, true}}, {{5, true}, {9, true}},
                                               {{3, true}, {1, false}}, {{2, false}, {3, true}}, {{6, false}},        {{1, false}, {1, false}},
                                               {{300, true}},         {{150, true}, {151, true}}, {{254, true}},      {{255, true}},
                                               {{254, false}, {3, true}}, {{400, false}},     {{130, false}, {130, false}}};
  for (const auto& fans : cases) {
    std::vector<std::array<unsigned, 4>> tets;
    unsigned next = 2;
    for (const fan& f : fans) {
      const unsigned first = next;
      for (unsigned i = 0; i < f.tets; ++i) tets.push_back({0, 1, next + i, f.closed && i + 1 == f.tets ? first : next + i + 1});
      next += f.tets + (f.closed ? 0 : 1);
    }
    const cn::tetmesh m(std::vector<cn::vec3>(next), tets);
    for (const auto e : cn::edges(m))
      if (raw_set(cn::adj_e2v(m, e)) == std::set<unsigned>{0, 1}) {
        std::size_t met = 0;
        for ([[maybe_unused]] const auto p : cn::adj_e2p(m, e)) ++met;
        CHECK(met == tets.size());
        CHECK(raw_set(cn::adj_e2p(m, e)).size() == tets.size());
      }
    if (next < 20) keeps_all_laws(m);
  }
}

TEST_CASE("adj_e2p: is right for very many polys that share only this edge") {
  constexpr unsigned n = 4000;
  std::vector<std::array<unsigned, 4>> tets;
  for (unsigned i = 0; i < n; ++i) tets.push_back({0, 1, 2 + 2 * i, 3 + 2 * i});
  const cn::tetmesh m(std::vector<cn::vec3>(2 + 2 * n), tets);
  CHECK(raw_set(cn::adj_e2p(m, *cn::adj_v2e(m, cn::vert_id{0}).begin())).size() == n);
}

TEST_CASE("adj_e2p: is right if polys are equal") {
  const cn::tetmesh m(std::vector<cn::vec3>(8), std::vector<std::array<unsigned, 4>>{{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 5, 6}, {0, 1, 6, 7}, {0, 1, 7, 4}});
  for (const auto e : cn::edges(m))
    if (raw_set(cn::adj_e2v(m, e)) == std::set<unsigned>{0, 1}) CHECK(raw_set(cn::adj_e2p(m, e)).size() == 6);
  keeps_all_laws(m);
}

TEST_CASE("native meshes: grids have the known counts and Euler characteristic") {
  const auto chi = [](const auto& m) {
    auto x = static_cast<long>(cn::num_verts(m)) - static_cast<long>(cn::num_edges(m));
    if constexpr (cn::VolumeMesh<decltype(m)>) x += static_cast<long>(cn::num_faces(m)) - static_cast<long>(cn::num_polys(m));
    else x += static_cast<long>(cn::num_polys(m));
    return x;
  };
  CHECK(chi(cn::testing::grid<cn::trimesh>(7)) == 1);
  CHECK(chi(cn::testing::grid<cn::quadmesh>(7)) == 1);
  CHECK(chi(cn::testing::grid<cn::polygonmesh>(7)) == 1);
  CHECK(chi(cn::testing::grid<cn::tetmesh>(5)) == 1);
  CHECK(chi(cn::testing::grid<cn::hexmesh>(5)) == 1);
  CHECK(chi(cn::testing::grid<cn::polyhedralmesh>(5)) == 1);
  const auto hexes = cn::testing::grid<cn::hexmesh>(4);
  std::size_t arcs = 0;
  for (const auto p : cn::polys(hexes))
    for ([[maybe_unused]] const auto q : cn::adj_p2p(hexes, p)) ++arcs;
  CHECK(arcs / 2 == 3 * 4 * 4 * 3);  // 3 n^2 (n-1)
}

TEST_CASE("native meshes: two polygons that share all their edges are neighbours once") {
  for (const unsigned n : {3u, 4u, 23u, 24u, 25u, 26u, 60u})
    for (const bool third : {false, true}) {
      std::vector<std::vector<unsigned>> lists(2);
      for (unsigned i = 0; i < n; ++i) lists[0].push_back(i);
      lists[1].assign(lists[0].rbegin(), lists[0].rend());
      if (third) lists.push_back({1, 2, n});
      const cn::polygonmesh m(std::vector<cn::vec3>(n + 1), lists);
      for (unsigned p = 0; p < 2; ++p) {
        std::vector<unsigned> met;
        for (const auto q : cn::adj_p2p(m, cn::poly_id{p})) met.push_back(q.raw());
        CHECK(met.size() == (third ? 2 : 1));
        CHECK(std::count(met.begin(), met.end(), 1 - p) == 1);
      }
      keeps_all_laws(m);
    }
}

TEST_CASE("native meshes: polygons with many verts may share many edges") {
  const unsigned n = 3000;
  std::vector<cn::vec3> points;
  for (unsigned i = 0; i < n; ++i) points.push_back({i, i % 7, 0});
  points.push_back({0, 0, 5});
  std::vector<std::vector<unsigned>> lists(2);
  for (unsigned i = 0; i < n; ++i) lists[0].push_back(i);
  lists[1].assign(lists[0].rbegin(), lists[0].rend());
  for (unsigned i = 0; i < n; i += 3) lists.push_back({i, i + 1, n});  // every third edge has three polys
  const cn::polygonmesh m(points, lists);
  CHECK(cn::num_edges(m) == n + 2 * (n / 3));
  keeps_all_laws(m);
  CHECK(raw_set(cn::adj_p2p(m, cn::poly_id{0})).size() == 1 + n / 3);
  std::size_t crowded = 0;
  for (const auto e : cn::edges(m)) crowded += cn::adj_e2p(m, e).size() == 3;
  CHECK(crowded == n / 3);

  // The two polygons as the faces of a flat polyhedron; one of them is also in an open polyhedron.
  const cn::polyhedralmesh w(points, std::vector<std::vector<unsigned>>(lists.begin(), lists.begin() + 2),
                             std::vector<std::vector<std::pair<unsigned, bool>>>{{{0, true}, {1, true}}, {{0, false}}});
  CHECK(raw_set(cn::adj_p2p(w, cn::poly_id{0})) == std::set<unsigned>{1});
  keeps_all_laws(w);
}

TEST_CASE("native meshes: can be constructed from braces, containers and arrays") {
  const int i = 0, j = 1;
  const long k = 2;
  CHECK(cn::num_edges(cn::trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}}, {{i, j, k}})) == 3);
  const std::vector<std::array<float, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  CHECK(cn::num_edges(cn::polygonmesh(points, std::vector<std::vector<long>>{{0, 1, 2, 3}})) == 4);
  CHECK(cn::point(cn::quadmesh(points, std::vector<std::array<unsigned char, 4>>{{0, 1, 2, 3}}), cn::vert_id{2}) == cn::vec3{1, 1, 0});
  const cn::polyhedralmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                               {{{0, true}, {1, true}, {2, true}, {3, true}}});
  CHECK(cn::num_edges(tet) == 6);
  CHECK(cn::face_is_outward(tet, cn::poly_id{0}, cn::face_id{3}));
}

TEST_CASE("native meshes: a face of two cells is outward for one and inward for the other") {
  const cn::tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
  unsigned shared = 0;
  for (const auto f : cn::faces(m)) {
    const auto two = cn::adj_f2p(m, f);
    if (two.size() != 2) continue;
    ++shared;
    CHECK(cn::face_is_outward(m, two[0], f) != cn::face_is_outward(m, two[1], f));
  }
  CHECK(shared == 1);
}

TEST_CASE("native meshes: the error names the reason why arrays are not a mesh") {
  const auto message = [](auto make) -> std::string {
    try {
      make();
    } catch (const cn::invalid_mesh& e) {
      return e.what();
    }
    return "nothing was thrown";
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  const std::vector<cn::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  using lists = std::vector<std::vector<int>>;
  CHECK(has(message([&] { cn::trimesh(p, lists{{0, 1, 2}, {0, 1, 4}}); }), "poly 1 names vert 4"));
  CHECK(has(message([&] { cn::trimesh(p, lists{{0, 1, -1}}); }), "poly 0 names vert -1"));
  CHECK(has(message([&] { cn::trimesh(p, lists{{0, 1, 2, 3}}); }), "trimesh: poly 0 has 4 verts"));
  CHECK(has(message([&] { cn::polygonmesh(p, lists{{0, 1}}); }), "poly 0 has 2 verts"));
  CHECK(has(message([&] { cn::polygonmesh(p, lists{{0, 1, 2, 1}}); }), "poly 0 has vert 1 twice"));
  CHECK(has(message([&] { cn::tetmesh(p, lists{{0, 1, 2, 2}}); }), "poly 0 has vert 2 twice"));
  CHECK(has(message([&] { cn::hexmesh(p, lists{{0, 1, 2, 3}}); }), "hexmesh: poly 0 has 4 verts"));
  using cells = std::vector<std::vector<std::pair<int, bool>>>;
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 2}}, cells{{{1, true}}}); }), "poly 0 names face 1"));
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 2}}, cells{{{0, true}, {0, false}}}); }), "poly 0 has face 0 twice"));
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 2}}, cells{{}}); }), "poly 0 has no faces"));
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 7}}, cells{}); }), "face 0 names vert 7"));
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 2}, {0, 1, 7}}, cells{}); }), "face 1 names vert 7"));
  CHECK(has(message([&] { cn::polyhedralmesh(p, lists{{0, 1, 2}}, cells{{{0, true}}, {{1, true}}}); }), "poly 1 names face 1"));
  CHECK(has(message([&] { cn::polygonmesh(cn::surface_arrays{p, {0, 3}, {cn::vert_id{0}}, 0}); }), "offsets"));
  CHECK(has(message([&] { cn::polygonmesh(cn::surface_arrays{p, {0, 3, 1}, {cn::vert_id{0}}, 0}); }), "must not decrease"));
  CHECK(has(message([&] { cn::trimesh(cn::surface_arrays{p, {}, {cn::vert_id{0}}, 3}); }), "has 1 verts"));
  CHECK(has(message([&] { cn::tetmesh(cn::cell_arrays{p, {}, 8}); }), "polys of 8 verts"));
  CHECK(has(message([&] {
    cn::polyhedralmesh(cn::polyhedra_arrays{p, {0, 3}, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}}, {0, 1}, {cn::face_id{0}}, {}});
  }), "outward flags"));
  CHECK(has(message([&] { cn::trimesh(cn::surface_arrays{p, {}, std::vector<cn::vert_id>(5, cn::vert_id{0}), 3}); }), "poly 1 has 2 verts"));
  CHECK(has(message([&] { cn::polygonmesh(cn::surface_arrays{p, {0, 3, 1}, {cn::vert_id{0}}, 0}); }), "poly 1 ends before it begins"));
  CHECK(has(message([&] { cn::polygonmesh(p, lists{{0, 1, 2}, {1, 1, 2}}); }), "poly 1 has vert 1 twice"));
  std::vector<int> large;
  for (int n = 0; n < 40; ++n) large.push_back(n % 39);
  CHECK(has(message([&] { cn::polygonmesh(std::vector<cn::vec3>(39), lists{large}); }), "vert 0 twice"));
}

TEST_CASE_TEMPLATE("native meshes: invalid and repeated elements throw, in whichever poly or face", M, CONCINO_ALL_KINDS) {
  const auto arrays = cn::testing::grid_arrays<M>(2);
  const cn::vert_id none{static_cast<unsigned>(arrays.points.size())};
  const auto check_refused = [](const auto& bad, const std::string& what) {
    CHECK_THROWS_WITH_AS(static_cast<void>(M(bad)), doctest::Contains(what.c_str()), cn::invalid_mesh);
  };
  for (const std::size_t i : {0u, 1u, 2u, 3u}) {
    auto bad = arrays;
    if constexpr (std::same_as<M, cn::polyhedralmesh>) {
      bad.face_verts[bad.face_offsets[i + 1] - 1] = none;
      check_refused(bad, "face " + std::to_string(i) + " names vert " + std::to_string(none.raw()));
      bad = arrays;
      bad.poly_faces[bad.poly_offsets[i + 1] - 1] = cn::face_id{static_cast<unsigned>(arrays.num_faces())};
      check_refused(bad, "poly " + std::to_string(i) + " names face " + std::to_string(arrays.num_faces()));
      bad.poly_faces[bad.poly_offsets[i + 1] - 1] = bad.poly_faces[bad.poly_offsets[i]];
      check_refused(bad, "poly " + std::to_string(i) + " has face ");
    } else {
      std::size_t first = i * bad.arity, end = first + bad.arity;
      if constexpr (std::same_as<M, cn::polygonmesh>) first = bad.offsets[i], end = bad.offsets[i + 1];
      for (std::size_t c = first; c < end; ++c) {
        bad.verts[c] = none;
        check_refused(bad, "poly " + std::to_string(i) + " names vert " + std::to_string(none.raw()));
        for (std::size_t d = first; d < c; ++d) {
          bad.verts[c] = bad.verts[d];
          check_refused(bad, "poly " + std::to_string(i) + " has vert " + std::to_string(bad.verts[d].raw()) + " twice");
        }
        bad.verts[c] = arrays.verts[c];
      }
    }
  }
}

TEST_CASE("native meshes: more polys, verts or corners than ids throw") {
  using cn::detail::check_counts;
  CHECK_NOTHROW(check_counts("surface_tables", 0xFFFFFFFEu, cn::detail::encoded_neighbour::mask - 1, 0xFFFFFFFEu));
  CHECK_THROWS_WITH_AS(check_counts("surface_tables", 0, cn::detail::encoded_neighbour::mask, 0), "surface_tables: the mesh has 1073741823 polys; at most 2^30 - 2 fit", cn::unsupported);
  CHECK_THROWS_WITH_AS(check_counts("surface_tables", 0xFFFFFFFFu, 0, 0), "surface_tables: the mesh has 4294967295 verts; at most 2^32 - 2 fit", cn::unsupported);
  CHECK_THROWS_WITH_AS(check_counts("surface_tables", 0, 0, 0xFFFFFFFFu), "surface_tables: the mesh has 4294967295 corners; at most 2^32 - 2 fit", cn::unsupported);
}

TEST_CASE("native meshes: only large faces with very many polyhedra throw") {
  // A face of `verts` verts that is the only face of each of `polys` polys.
  const auto crowded = [](std::size_t verts, std::size_t polys) {
    cn::polyhedra_arrays a{std::vector<cn::vec3>(verts), {0, static_cast<std::uint32_t>(verts)}, {}, {0}, {}, {}};
    for (std::size_t v = 0; v < verts; ++v) a.face_verts.push_back(cn::vert_id{v});
    for (std::size_t p = 0; p < polys; ++p) a.poly_offsets.push_back(static_cast<std::uint32_t>(p + 1));
    a.poly_faces.assign(polys, cn::face_id{0});
    a.outward.assign(polys, 1);
    return cn::polyhedralmesh(std::move(a));
  };
  CHECK(cn::adj_p2v(crowded(16, 80000), cn::poly_id{79999}).size() == 16);
  CHECK(cn::adj_v2p(crowded(80000, 16), cn::vert_id{79999}).size() == 16);
  CHECK(cn::adj_v2p(crowded(1104, 980), cn::vert_id{0}).size() == 980);  // 2^20 + 16 (1104 + 980) entries of adj_p2v: the limit
  CHECK_THROWS_AS(crowded(1104, 981), cn::unsupported);
  CHECK_THROWS_WITH_AS(crowded(2000, 2000), doctest::Contains("4000000 entries for input lists of 4000; a face of more than 16 verts should belong to at most 16 polys"),
                       cn::unsupported);
}

TEST_CASE_TEMPLATE("native meshes: can be empty, copied and moved", M, CONCINO_ALL_KINDS) {
  const M empty;
  CHECK(cn::num_verts(empty) + cn::num_edges(empty) + cn::num_polys(empty) == 0);
  keeps_all_laws(empty);
  M m = cn::testing::grid<M>(2);
  cn::vert_property<int>(m, "n")[cn::vert_id{1}] = 7;
  M copy = m;
  cn::set_point(copy, cn::vert_id{0}, cn::vec3{9, 9, 9});
  cn::vert_property<int>(copy, "n")[cn::vert_id{1}] = 8;
  CHECK(cn::point(m, cn::vert_id{0}) != cn::vec3{9, 9, 9});
  CHECK(cn::vert_property<int>(m, "n")[cn::vert_id{1}] == 7);
  const std::size_t edges = cn::num_edges(m);
  const M moved = std::move(m);
  CHECK(cn::num_edges(moved) == edges);
  keeps_all_laws(moved);
  m = copy;
  keeps_all_laws(m);
  CHECK(cn::num_edges(m) == edges);
}

TEST_CASE_TEMPLATE("native meshes: several threads can read a const mesh", M, CONCINO_ALL_KINDS) {
  const M m = cn::testing::grid<M>(4);
  std::array<std::size_t, 4> sums{};
  std::vector<std::thread> threads;
  for (std::size_t& sum : sums)
    threads.emplace_back([&m, &sum] {
      for (const auto e : cn::edges(m))
        for (const auto p : cn::adj_e2p(m, e)) sum += p.raw();
      for (const auto p : cn::polys(m))
        for (const auto q : cn::adj_p2p(m, p)) sum += q.raw();
    });
  for (auto& t : threads) t.join();
  for (const std::size_t sum : sums) CHECK(sum == sums[0]);
}

TEST_CASE("native meshes: large polyhedral meshes are the same for any number of threads, and so are errors") {
  const auto arrays = cn::testing::grid_arrays<cn::polyhedralmesh>(24);
  REQUIRE(arrays.face_verts.size() > 300'000);  // smaller ones are built in one thread
  const auto lists = [&](int threads) {
    const cn::testing::with_num_threads fixed(threads);
    const cn::polyhedralmesh m(arrays);
    std::vector<unsigned> all;
    const auto add = [&](const auto& list) {
      for (const auto x : list) all.push_back(x.raw());
      all.push_back(~0u);
    };
    for (const auto v : cn::verts(m)) add(cn::adj_v2v(m, v)), add(cn::adj_v2e(m, v)), add(cn::adj_v2p(m, v));
    for (const auto e : cn::edges(m)) add(cn::adj_e2v(m, e)), add(cn::adj_e2f(m, e));
    for (const auto f : cn::faces(m)) add(cn::adj_f2v(m, f)), add(cn::adj_f2p(m, f));
    for (const auto p : cn::polys(m)) add(cn::adj_p2v(m, p)), add(cn::adj_p2e(m, p)), add(cn::adj_p2f(m, p)), add(cn::adj_p2p(m, p));
    return all;
  };
  CHECK(lists(1) == lists(2));

  auto bad = arrays;
  bad.face_verts[100'000] = cn::vert_id{1'000'000};
  bad.poly_faces[10] = cn::face_id{2'000'000};
  for (const int threads : {1, 2}) {
    const cn::testing::with_num_threads fixed(threads);
    CHECK_THROWS_WITH_AS(cn::polyhedralmesh{bad}, doctest::Contains("face 16666 names vert 1000000"), cn::invalid_mesh);
  }
}
