// clip and split of native polyhedra: the same for any number of threads, and whatever was done to the mesh before.
#include <concino/level_sets/clip.hpp>

#include <concino/core/error.hpp>
#include <concino/edit/elements.hpp>
#include <concino/generate/grid.hpp>

#include <support/level_sets.hpp>
#include <support/random_meshes.hpp>
#include <support/threads.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <random>
#include <span>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// All that a clipped volume consists of, as numbers.
std::vector<double> all_of(const clipped_volume<polyhedralmesh>& c) {
  std::vector<double> all = whole(c.mesh);
  for (const element_origins* const x : {&c.from.verts, &c.from.edges, &c.from.faces, &c.from.polys})
    for (std::size_t i = 0; i < x->size(); ++i) {
      all.push_back(-2);
      for (const origin o : (*x)[i]) all.push_back(o.index), all.push_back(o.weight);
    }
  for (const face_id f : c.cut_faces) all.push_back(f.raw());
  all.insert(all.end(), c.above.begin(), c.above.end());
  return all;
}

/// The same mesh after its elements were numbered anew.
polyhedralmesh compacted(polyhedralmesh m) {
  m.garbage_collect();
  return m;
}

face_id common_face(const polyhedralmesh& m, poly_id p, poly_id q) {
  for (const face_id f : adj_p2f(m, p))
    for (const poly_id x : adj_f2p(m, f))
      if (x == q) return f;
  return {};
}

/// Adds a poly at a face, also if it has two polys already.
void add_pyramid(polyhedralmesh& m, face_id base) {
  std::vector<vert_id> corners;
  for (const vert_id v : adj_f2v(m, base)) corners.push_back(v);
  const vert_id apex = add_vert(m, point(m, corners[0]) + vec3{0.01, 0.02, 0.03});
  std::vector<face_id> faces{base};
  for (std::size_t k = 0; k < corners.size(); ++k) faces.push_back(add_face(m, {corners[(k + 1) % corners.size()], corners[k], apex}));
  const std::vector<unsigned char> outward(faces.size(), 1);
  mesh_traits<polyhedralmesh>::add_poly(m, std::span<const face_id>(faces), std::span<const unsigned char>(outward));
}

}  // namespace

TEST_CASE("clip: the mesh is the same if elements were numbered anew before") {
  std::mt19937 random(12);
  int num_cut = 0;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const auto m = i % 3 ? mesh_to_cut<polyhedralmesh>(random) : random_mesh<polyhedralmesh>(random);
    const auto other = compacted(m);
    const auto u = random_values(m, random, i % 2 == 0);
    auto same = make_vert_map<double>(other);
    for (const auto v : verts(other)) same[v] = u[v];
    try {
      const auto s = split(m, u, 1.0), c = clip(m, u, 1.0);
      CHECK(whole(s.mesh) == whole(split(other, same, 1.0).mesh));
      CHECK(whole(c.mesh) == whole(clip(other, same, 1.0).mesh));
      num_cut += s.report.cut_polys > 0;
    } catch (const unsupported&) {
      CHECK_THROWS_AS((void)split(other, same, 1.0), unsupported);  // a cell whose surface is not a sphere
    }
  }
  CHECK(num_cut > 40);
}

TEST_CASE("clip: what is clipped can be clipped again in the same way") {
  const auto m = make_grid<polyhedralmesh>({.cells = {4, 3, 3}});
  const auto first = clip(m, plane{{1, 2, 3}, 2.1});
  REQUIRE(first.report.cut_polys > 0);
  CHECK(all_of(clip(first.mesh, plane{{3, 1, -2}, 0.3})) == all_of(clip(compacted(first.mesh), plane{{3, 1, -2}, 0.3})));
}

TEST_CASE("clip: the parts of many crossed polys are the same for any number of threads") {
  constexpr std::size_t n = 20, in_layer = n * n;
  auto m = make_grid<polyhedralmesh>({.cells = {n, n, 12}});
  std::mt19937 random(5);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    if (i == 3) add_pyramid(m, common_face(m, poly_id{2350}, poly_id{2350 + in_layer}));  // one thread reads the first poly, another one the second
    auto u = make_vert_map<double>(m);
    std::uniform_real_distribution<double> size(0.5, 1);
    for (const auto v : verts(m)) u[v] = size(random) * (index_of(m, v) / ((n + 1) * (n + 1)) % 2 ? 1 : -1);  // each layer of verts has the other sign
    for (int k = 0; k < 12 && i > 0; ++k) u[vert_id{random() % num_verts(m)}] *= i == 1 ? 0 : -1;                    // polys that are not simple
    if (i > 0) u[adj_p2v(m, poly_id{2710 + n})[0]] *= -1;  // beside simple polys that the other thread reads
    const auto all_with = [&](int threads) {
      const with_num_threads fixed(threads);
      auto all = all_of(split(m, u, 0.0));
      const auto above = all_of(clip(m, u, 0.0));
      all.insert(all.end(), above.begin(), above.end());
      return all;
    };
    const auto one = all_with(1);
    CHECK((one == all_with(2)));
    CHECK((one == all_with(3)));
  }
}

TEST_CASE("clip: the result is the same for any number of threads") {
  const auto m = make_grid<polyhedralmesh>({.cells = {50, 50, 40}});
  const plane p{{1, 2, 3}, 2.1};
  const auto all_with = [&](int threads) {
    const with_num_threads fixed(threads);
    const auto c = clip(m, p);
    CHECK(c.report.cut_polys > 0);
    return all_of(c);
  };
  const auto one = all_with(1);
  CHECK((one == all_with(2)));
  CHECK((one == all_with(3)));
}

namespace {
/// The mirror image of a mesh of this library: it replaces two verbs.
struct mirror_image : concino::polyhedralmesh {};
}  // namespace
template<>
struct concino::mesh_traits<mirror_image> : concino::mesh_traits<polyhedralmesh> {
  static vec3 point(const polyhedralmesh& m, vert_id v) { return {m.points()[v.raw()].x, m.points()[v.raw()].y, -m.points()[v.raw()].z}; }
  static bool face_is_outward(const polyhedralmesh& m, poly_id p, face_id f) { return !m.tables().face_is_outward(p, f); }
};

TEST_CASE("clip: reads verbs that were replaced, not the tables of the mesh") {
  const mirror_image m{concino::testing::grid<concino::polyhedralmesh>(3)};
  auto x = concino::make_vert_map<double>(m);
  for (const auto v : concino::verts(m)) x[v] = concino::point(m, v).x;
  const double whole = concino::total_measure(m);
  REQUIRE(whole > 0);
  const auto part = concino::clip(m, x, concino::point(m, concino::vert_id{0}).x + 0.4).mesh;
  double sum = 0;
  for (const auto p : concino::polys(part)) {
    CHECK(concino::measure(part, p) > 0);
    sum += concino::measure(part, p);
  }
  CHECK(sum < whole);
}
