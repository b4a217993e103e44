// After any sequence of adding and removing, the mesh obeys all laws and equals a newly constructed mesh, and other descriptors are unchanged.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <set>

namespace cn = concino;

namespace {

using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;
using list = std::vector<unsigned>;

template<class M>
void add_random_poly(M& m, std::mt19937& random) {
  const list verts = raw(cn::verts(m));
  if (verts.size() < 8) return;
  const auto pick = [&](unsigned n) {
    std::vector<cn::vert_id> corners;
    for (const unsigned i : cn::testing::some_of(random, static_cast<unsigned>(verts.size()), n)) corners.push_back(cn::vert_id{verts[i]});
    return corners;
  };
  if constexpr (std::same_as<M, cn::polyhedralmesh>) {
    const auto corners = pick(4);
    using span = std::span<const cn::vert_id>;
    cn::face_id f[4];
    for (unsigned k = 0; k < 4; ++k) {
      std::vector<cn::vert_id> three;
      for (unsigned i = 0; i < 4; ++i)
        if (i != k) three.push_back(corners[i]);
      f[k] = cn::add_face(m, span(three));
    }
    const list all = raw(cn::faces(m));
    const cn::face_id shared{all[random() % (all.size() - 4)]};  // a face that exists already
    cn::add_poly(m, {{f[0], true}, {f[1], false}, {f[2], true}, {f[3], false}, {shared, true}});
  } else {
    const unsigned n = cn::arity_v<M> ? cn::arity_v<M> : 3 + random() % 4;
    cn::add_poly(m, std::span<const cn::vert_id>(pick(n)));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("editing: laws hold after random adding and removing", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(4);
  const unsigned rounds = concino::testing::long_run() ? 200 : 8;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = round % 2 ? cn::testing::grid<M>(2) : cn::testing::random_soup<M>(random, 14, 12).mesh();
    for (unsigned step = 0; step < 40; ++step) {
      const list polys = raw(cn::polys(m)), verts = raw(cn::verts(m));
      switch (random() % 5) {
        case 0: {
          const cn::vert_id added = cn::add_vert(m, {1, 2, 3});
          CHECK(added.raw() == cn::vert_index_bound(m) - 1);
          break;
        }
        case 1:
        case 2:
          if (!polys.empty()) {
            const cn::poly_id p{polys[random() % polys.size()]};
            cn::remove_poly(m, p);
            CHECK_FALSE(cn::contains(m, p));
            CHECK(cn::num_polys(m) == polys.size() - 1);
          }
          break;
        case 3:
          if (!verts.empty() && random() % 4 == 0) cn::remove_vert(m, cn::vert_id{verts[random() % verts.size()]});
          break;
        default:
          if constexpr (std::same_as<M, cn::polyhedralmesh>) {
            if (cn::num_faces(m) == 0) break;
          }
          add_random_poly(m, random);
      }
      keeps_all_laws(m);
    }
    equals_rebuilt(m);
  }
}

TEST_CASE("editing: laws hold after random edits of long polygons that share several edges") {
  std::mt19937 random(6);
  const unsigned rounds = concino::testing::long_run() ? 100 : 4;
  for (unsigned round = 0; round < rounds; ++round) {
    cn::polygonmesh m(std::vector<cn::vec3>(44), std::vector<list>{});
    for (unsigned step = 0; step < 30; ++step) {
      const list polys = raw(cn::polys(m));
      if (polys.size() > 6 || (!polys.empty() && random() % 3 == 0)) {
        cn::remove_poly(m, cn::poly_id{polys[random() % polys.size()]});
      } else {
        // arcs of one common cycle, and random verts between them
        const auto n = 20 + static_cast<unsigned>(random() % 20), keep = 2 + static_cast<unsigned>(random() % 8);
        std::vector<cn::vert_id> corners;
        for (unsigned i = 0; i < n; ++i) corners.push_back(cn::vert_id{i});
        for (unsigned i = 0; i < n; ++i)
          if (i % keep == keep - 1) std::swap(corners[i], corners[random() % n]);
        if (random() % 2) std::reverse(corners.begin(), corners.end());
        cn::add_poly(m, std::span<const cn::vert_id>(corners));
      }
      keeps_all_laws(m);
    }
    equals_rebuilt(m);
  }
}

TEST_CASE_TEMPLATE("editing: removing and adding all polys gives the same mesh", M, cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh) {
  const M whole = cn::testing::grid<M>(3);
  M m = whole;
  for (const auto p : cn::polys(whole)) cn::remove_poly(m, p);
  CHECK(cn::num_polys(m) + cn::num_edges(m) == 0);
  CHECK(cn::num_verts(m) == cn::num_verts(whole));
  keeps_all_laws(m);
  for (const auto p : cn::polys(whole)) {
    const auto corners = cn::adj_p2v(whole, p);
    cn::add_poly(m, std::span<const cn::vert_id>(corners.begin(), corners.size()));
  }
  CHECK(cn::num_edges(m) == cn::num_edges(whole));
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE_TEMPLATE("add_poly accepts a range of verts that belongs to the mesh", M, cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh) {
  M m = cn::testing::grid<M>(2);
  for (int twice = 0; twice < 2; ++twice) {
    const cn::poly_id p = *cn::polys(m).begin();
    const auto corners = cn::adj_p2v(m, p);
    const list before = raw(corners);
    const cn::poly_id q = cn::add_poly(m, std::span<const cn::vert_id>(corners.begin(), corners.size()));
    CHECK(raw(cn::adj_p2v(m, q)) == before);
    CHECK(raw(cn::adj_p2v(m, p)) == before);
  }
  keeps_all_laws(m);
}

TEST_CASE("add_face and add_poly accept ranges that belong to the mesh") {
  auto m = cn::testing::grid<cn::polyhedralmesh>(2);
  const cn::poly_id p = *cn::polys(m).begin();
  const cn::face_id f = *cn::adj_p2f(m, p).begin();
  const auto corners = cn::adj_f2v(m, f);
  const list before = raw(corners);
  const cn::face_id g = cn::add_face(m, std::span<const cn::vert_id>(corners.begin(), corners.size()));
  CHECK(raw(cn::adj_f2v(m, g)) == before);
  const auto in_mesh = cn::adj_p2f(m, p);
  const std::vector<cn::face_id> faces(in_mesh.begin(), in_mesh.end());  // the range in_mesh is invalid after the first edit
  const list those = raw(faces);
  const std::vector<std::uint8_t> outward(faces.size(), 1);
  const cn::poly_id q = cn::mesh_traits<cn::polyhedralmesh>::add_poly(m, std::span<const cn::face_id>(in_mesh.begin(), in_mesh.size()), outward);
  CHECK(raw(cn::adj_p2f(m, q)) == those);

  const list polys_before = raw(cn::polys(m));
  const std::span<const cn::face_id> none, two(faces.data(), 2);
  const std::span<const std::uint8_t> no_flags, one_flag(outward.data(), 1);
  const auto add = [&](auto list_of_faces, auto flags) { cn::mesh_traits<cn::polyhedralmesh>::add_poly(m, list_of_faces, flags); };
  CHECK_THROWS_WITH_AS(add(none, no_flags), doctest::Contains("needs at least one face and an outward flag for each"), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(add(two, one_flag), doctest::Contains("needs at least one face and an outward flag for each"), cn::invalid_mesh);
  CHECK(raw(cn::polys(m)) == polys_before);
}

TEST_CASE("editing: a mesh can be built by add_vert and add_poly alone") {
  cn::polygonmesh m;
  std::vector<cn::vert_id> v;
  for (int i = 0; i < 4; ++i) v.push_back(cn::add_vert(m, {i % 2, i / 2, 0}));
  CHECK(cn::add_poly(m, {v[0], v[1], v[3], v[2]}) == cn::poly_id{0});
  CHECK(cn::num_edges(m) == 4);
  keeps_all_laws(m);
}

TEST_CASE("editing: an added face without polys has as many edges as verts") {
  cn::polyhedralmesh m;
  std::size_t edges = 0;
  for (unsigned n = 3; n < 12; ++n) {
    std::vector<cn::vert_id> corners;
    for (unsigned i = 0; i < n; ++i) corners.push_back(cn::add_vert(m, {i, n, 0}));
    const cn::face_id f = cn::add_face(m, std::span<const cn::vert_id>(corners));
    CHECK(cn::num_edges(m) == (edges += n));
    for (const cn::vert_id v : corners) CHECK(raw(cn::adj_v2f(m, v)) == list{f.raw()});
  }
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("editing: an edit that throws changes nothing", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::grid<M>(2);
  const std::size_t edges = cn::num_edges(m), polys = cn::num_polys(m);
  if constexpr (std::same_as<M, cn::polyhedralmesh>) {
    CHECK_THROWS_AS(cn::add_poly(m, {{cn::face_id{0}, true}, {cn::face_id{0}, false}}), cn::invalid_mesh);
    CHECK_THROWS_AS(cn::add_poly(m, {{cn::face_id{100000}, true}}), cn::invalid_mesh);
    CHECK_THROWS_AS(cn::add_face(m, {cn::vert_id{0}, cn::vert_id{1}}), cn::invalid_mesh);
  } else {
    CHECK_THROWS_AS(cn::add_poly(m, {cn::vert_id{0}, cn::vert_id{1}}), cn::invalid_mesh);
    std::vector<cn::vert_id> corners;
    for (const auto v : cn::adj_p2v(m, cn::poly_id{0})) corners.push_back(v);
    corners.back() = cn::vert_id{100000};
    CHECK_THROWS_AS(cn::add_poly(m, std::span<const cn::vert_id>(corners)), cn::invalid_mesh);
    corners.back() = corners.front();
    CHECK_THROWS_AS(cn::add_poly(m, std::span<const cn::vert_id>(corners)), cn::invalid_mesh);
    corners.clear();
    for (unsigned i = 0; i < cn::arity_v<M> + 1; ++i) corners.push_back(cn::vert_id{i});
    if (cn::arity_v<M> > 0) CHECK_THROWS_AS(cn::add_poly(m, std::span<const cn::vert_id>(corners)), cn::invalid_mesh);
  }
  CHECK(cn::num_edges(m) == edges);
  CHECK(cn::num_polys(m) == polys);
  keeps_all_laws(m);
  cn::remove_poly(m, cn::poly_id{0});
  CHECK_THROWS_AS(cn::remove_poly(m, cn::poly_id{0}), cn::invalid_mesh);
  CHECK_THROWS_AS(cn::remove_vert(m, cn::vert_id{}), cn::invalid_mesh);
}

TEST_CASE("editing: an added cell shares an existing face, whatever its orientation and first vert") {
  const std::vector<cn::vec3> points(12);
  const auto add = [](auto& m, const list& raw_corners) {
    std::vector<cn::vert_id> corners;
    for (const unsigned v : raw_corners) corners.push_back(cn::vert_id{v});
    cn::add_poly(m, std::span<const cn::vert_id>(corners));
  };
  for (const list& added : {list{0, 1, 2, 4}, {1, 2, 0, 4}, {2, 0, 1, 4}, {0, 2, 1, 4}, {2, 1, 0, 4}, {4, 0, 1, 2}}) {
    cn::tetmesh m(points, std::vector<list>{{0, 1, 2, 3}});
    add(m, added);
    CHECK(cn::num_faces(m) == 7);
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
  for (const list& added : {list{0, 1, 2, 3, 8, 9, 10, 11}, {1, 2, 3, 0, 8, 9, 10, 11}, {3, 0, 1, 2, 8, 9, 10, 11}, {3, 2, 1, 0, 8, 9, 10, 11}, {0, 3, 2, 1, 8, 9, 10, 11},
                            {8, 9, 10, 11, 2, 3, 0, 1}}) {
    cn::hexmesh m(points, std::vector<list>{{0, 1, 2, 3, 4, 5, 6, 7}});
    add(m, added);
    CHECK(cn::num_faces(m) == 11);
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("editing: polys that are added after others were replaced") {
  // a replaced poly is attached to its edges and faces after its neighbours, whatever its number
  cn::trimesh s(std::vector<cn::vec3>(6), std::vector<list>{{0, 1, 2}, {1, 0, 3}});
  cn::flip_winding(s, cn::poly_id{0});
  cn::add_poly(s, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{4}});
  CHECK(raw(cn::adj_p2p(s, cn::poly_id{2})) == list{0, 1});
  keeps_all_laws(s);
  equals_rebuilt(s);
  cn::tetmesh v(std::vector<cn::vec3>(6), std::vector<list>{{0, 1, 2, 3}, {1, 0, 2, 4}});
  cn::flip_winding(v, cn::poly_id{0});
  cn::add_poly(v, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}, cn::vert_id{5}});
  CHECK(raw(cn::adj_p2p(v, cn::poly_id{2})) == list{0, 1});
  keeps_all_laws(v);
  equals_rebuilt(v);
}
