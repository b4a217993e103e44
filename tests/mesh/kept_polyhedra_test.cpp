// Tables of polyhedra that are made of earlier ones are those that the constructor makes of the same lists.
#include <concino/mesh/kept_polyhedra.hpp>

#include <concino/edit/elements.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <support/polyhedra_cavities.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using lists = soup<polyhedralmesh>;

/// Lists of which some verts, faces and polys are those of `before`, in their order, and what they have in common.
struct changed_lists {
  kept_polyhedra kept;
  lists after;

  changed_lists(std::mt19937& random, const lists& before, unsigned face_size) {
    const auto none = kept_polyhedra::none;
    kept.verts.assign(before.points.size(), none), kept.faces.assign(before.verts.size(), none), kept.polys.assign(before.poly_faces.size(), none);
    for (std::size_t p = 0; p < kept.polys.size(); ++p)
      if (random() % 3 > 0) kept.polys[p] = kept.num_polys++;
    for (std::size_t p = 0; p < kept.polys.size(); ++p)
      if (kept.polys[p] != none)
        for (const auto& [f, outward] : before.poly_faces[p]) kept.faces[f] = 0;
    for (std::size_t f = 0; f < kept.faces.size(); ++f) {
      if (kept.faces[f] == none && random() % 4 > 0) continue;
      kept.faces[f] = kept.num_faces++;
      for (const unsigned v : before.verts[f]) kept.verts[v] = 0;
      after.verts.push_back(before.verts[f]);
    }
    for (std::size_t v = 0; v < kept.verts.size(); ++v)
      if (kept.verts[v] == 0 || random() % 2) kept.verts[v] = kept.num_verts++, after.points.push_back(before.points[v]);
    for (auto& face : after.verts)
      for (unsigned& v : face) v = kept.verts[v];
    for (std::size_t p = 0; p < kept.polys.size(); ++p) {
      if (kept.polys[p] == none) continue;
      after.poly_faces.push_back(before.poly_faces[p]);
      for (auto& [f, outward] : after.poly_faces.back()) f = kept.faces[f];
    }
    add(random, before, face_size);
  }

 private:
  /// Adds new verts, faces, of which some are turned ones of `before`, and polys.
  void add(std::mt19937& random, const lists& before, unsigned face_size) {
    for (unsigned i = 2 + static_cast<unsigned>(random() % 3); i > 0; --i) after.points.push_back({1, 2, 3});
    const auto vert_count = static_cast<unsigned>(after.points.size());
    for (const auto& face : before.verts) {
      if (random() % 3 > 0 || std::any_of(face.begin(), face.end(), [&](unsigned v) { return kept.verts[v] == kept_polyhedra::none; })) continue;
      auto& copy = after.verts.emplace_back(face.rbegin(), face.rend());
      for (unsigned& v : copy) v = kept.verts[v];
    }
    for (unsigned i = static_cast<unsigned>(random() % 4); i > 0; --i) after.verts.push_back(some_of(random, vert_count, std::min(vert_count, face_size + static_cast<unsigned>(random() % 2))));
    const auto face_count = static_cast<unsigned>(after.verts.size());
    for (unsigned i = static_cast<unsigned>(random() % 3); i > 0 && face_count > 0; --i) {
      auto& faces = after.poly_faces.emplace_back();
      for (const unsigned f : some_of(random, face_count, 1 + static_cast<unsigned>(random() % std::min(face_count, 30u)))) faces.emplace_back(f, random() % 2 == 0);
    }
  }
};

polyhedralmesh extended(const polyhedralmesh& before, kept_polyhedra& kept, const lists& l) {
  std::vector<std::uint32_t> face_offsets{0}, poly_offsets{0};
  std::vector<vert_id> face_verts;
  std::vector<face_id> poly_faces;
  std::vector<std::uint8_t> outward;
  for (const auto& face : l.verts) {
    for (const unsigned v : face) face_verts.push_back(vert_id{v});
    face_offsets.push_back(static_cast<std::uint32_t>(face_verts.size()));
  }
  for (const auto& poly : l.poly_faces) {
    for (const auto& [f, is_outward] : poly) poly_faces.push_back(face_id{f}), outward.push_back(is_outward);
    poly_offsets.push_back(static_cast<std::uint32_t>(poly_faces.size()));
  }
  polyhedralmesh m;
  m.points() = l.points;
  m.tables() = polyhedra_tables(before.tables(), kept, l.points.size(), face_offsets, face_verts, poly_offsets, poly_faces, outward);
  return m;
}

/// The edges of m with the same verts as those of `before`.
std::vector<std::uint32_t> equal_edges(const polyhedralmesh& before, const kept_polyhedra& kept, const polyhedralmesh& m) {
  std::vector<std::uint32_t> all;
  for (const auto e : edges(before)) {
    const auto ends = adj_e2v(before, e);
    const std::uint32_t a = kept.verts[ends[0].raw()], b = kept.verts[ends[1].raw()];
    const edge_id now = a == kept_polyhedra::none || b == kept_polyhedra::none ? edge_id{} : m.tables().edge_between(vert_id{a}, vert_id{b});
    all.push_back(now.is_none() ? kept_polyhedra::none : now.raw());
  }
  return all;
}

void equals_constructed(std::mt19937& random, const lists& before, unsigned face_size) {
  const polyhedralmesh m = before.mesh();
  if (!m.tables().can_be_extended()) return;
  changed_lists x(random, before, face_size);
  const polyhedralmesh expected = x.after.mesh(), made = extended(m, x.kept, x.after);
  CHECK(whole(made) == whole(expected));
  CHECK(x.kept.edges == equal_edges(m, x.kept, expected));
  for (const auto p : polys(made)) CHECK(made.tables().first_corner(p) == expected.tables().first_corner(p));
  for (const auto p : polys(made)) {
    std::size_t k = 0;
    for (const auto f : adj_p2f(made, p)) CHECK((made.tables().outward_flags(p)[k++] != 0) == face_is_outward(expected, p, f));
  }
  CHECK(made.tables().can_be_extended() == expected.tables().can_be_extended());
}

bool can_be_extended(const polyhedralmesh& m) { return m.tables().can_be_extended(); }

}  // namespace

TEST_CASE("kept_polyhedra: tables of a part and additions are as constructed") {
  std::mt19937 random(5);
  std::size_t num_extended = 0;
  for (int i = 0; i < 1500; ++i) {
    CAPTURE(i);
    const unsigned vert_count = 5 + static_cast<unsigned>(random() % 20), poly_count = 1 + static_cast<unsigned>(random() % 8);
    lists before = random_soup<polyhedralmesh>(random, vert_count, poly_count);
    if (i % 4 == 0) before.verts.push_back(some_of(random, vert_count, 5));  // a face without polys
    equals_constructed(random, before, 4);
    num_extended += can_be_extended(before.mesh());
  }
  CHECK(num_extended > 500);
}

TEST_CASE("kept_polyhedra: faces with many verts, and polys with many faces") {
  std::mt19937 random(6);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    lists before = random_soup<polyhedralmesh>(random, 90, 3);
    for (auto& face : before.verts)
      if (random() % 2) face = some_of(random, 90, 70 + static_cast<unsigned>(random() % 10));
    const auto first = static_cast<unsigned>(before.verts.size());
    auto& poly = before.poly_faces.emplace_back();
    for (unsigned f = 0; f < 80; ++f) before.verts.push_back(some_of(random, 90, 3)), poly.emplace_back(first + f, true);
    before.poly_faces.push_back({poly.begin(), poly.begin() + 30});
    equals_constructed(random, before, 75);
  }
}

TEST_CASE("kept_polyhedra: a vert with many edges") {
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    lists before;
    before.points = random_points(random, 100);
    const unsigned centre = i % 2 ? 99 : 0;
    for (unsigned f = 0; f < 96; ++f) before.verts.push_back({centre, f + 1, f + 2});
    for (unsigned f = 0; f < 96; f += 4) before.poly_faces.push_back({{f, true}, {f + 1, false}, {f + 2, true}, {f + 3, false}});
    equals_constructed(random, before, 4);
  }
}

TEST_CASE("kept_polyhedra: all or nothing of a mesh can be kept") {
  std::mt19937 random(7);
  const lists all = random_soup<polyhedralmesh>(random, 9, 2);
  const polyhedralmesh m = all.mesh(), none;
  REQUIRE(can_be_extended(m));
  kept_polyhedra kept;
  CHECK(whole(extended(none, kept, all)) == whole(m));
  kept.verts = {0, 1, 2, 3, 4, 5, 6, 7, 8}, kept.faces = {0, 1, 2, 3, 4}, kept.polys = {0, 1};
  kept.num_verts = 9, kept.num_faces = 5, kept.num_polys = 2;
  CHECK(whole(extended(m, kept, all)) == whole(m));
  kept = {};
  kept.verts.assign(9, kept.none), kept.faces.assign(5, kept.none), kept.polys.assign(2, kept.none);
  CHECK(whole(extended(m, kept, {})) == whole(none));
}

TEST_CASE("can_be_extended: not after an edit, a compaction or a move, nor with facets of three polys") {
  const polyhedralmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}, {1, 2, 4}, {1, 3, 4}, {2, 3, 4}},
                         {{{0, false}, {1, true}, {2, true}, {3, false}}, {{2, false}, {4, true}, {5, false}, {6, true}}});
  CHECK(can_be_extended(m));
  polyhedralmesh copy = m;
  CHECK(can_be_extended(copy));
  set_point(copy, vert_id(0u), vec3{0, 0, -1});
  CHECK(can_be_extended(copy));
  const polyhedralmesh other = std::move(copy);
  CHECK(can_be_extended(other));
  CHECK(!can_be_extended(copy));  // NOLINT: what a moved mesh is
  const auto after = [&](auto edit) {
    polyhedralmesh x = m;
    edit(x);
    const bool can = can_be_extended(x);
    x.garbage_collect();
    CHECK(!can_be_extended(x));
    return can;
  };
  const std::vector<vert_id> corners{vert_id(0u), vert_id(1u), vert_id(4u)};
  const std::vector<face_id> two{face_id(0u), face_id(4u)};
  const std::vector<std::uint8_t> outward{1, 1};
  CHECK(after([](polyhedralmesh&) {}));
  CHECK(!after([](polyhedralmesh& x) { add_vert(x, vec3{}); }));
  CHECK(!after([&](polyhedralmesh& x) { mesh_traits<polyhedralmesh>::add_face(x, corners); }));
  CHECK(!after([&](polyhedralmesh& x) { mesh_traits<polyhedralmesh>::add_poly(x, two, outward); }));
  CHECK(!after([](polyhedralmesh& x) { remove_poly(x, poly_id(1u)); }));
  std::mt19937 random(8);
  CHECK(!after([&](polyhedralmesh& x) { random_polyhedra(x, random).apply_to(x); }));
  CHECK(!after([](polyhedralmesh& x) {
    const transaction undone(x);
    remove_poly(x, poly_id(1u));
  }));
  const polyhedralmesh three({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}}, {{{0, true}}, {{0, true}, {1, true}}, {{0, false}}});
  CHECK(!can_be_extended(three));
}
