// rewire of the native mesh of general polyhedra: after any replacement of polys the mesh obeys all laws and equals a newly constructed mesh, what is not in the
// cavity keeps its descriptors, and a cavity that is refused changes nothing.
#include <concino/edit/elements.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/mesh.hpp>

#include <support/cavities.hpp>
#include <support/corpus.hpp>
#include <support/polyhedra_cavities.hpp>

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::cycle;
using cn::testing::owned_cavity;
using cn::testing::reversed;
using cn::testing::rotated;

static_assert(cn::EditableVolumeMesh<cn::polyhedralmesh>);

namespace {

/// The faces of every poly, in their order.
std::map<unsigned, std::vector<cycle>> faces_of_polys(const cn::polyhedralmesh& m) {
  std::map<unsigned, std::vector<cycle>> all;
  for (const auto p : cn::polys(m))
    for (const auto f : cn::adj_p2f(m, p)) all[p.raw()].push_back(rotated(cn::testing::outward_face(m, p, f)));
  return all;
}

/// The verts of every face.
std::map<unsigned, cycle> verts_of_faces(const cn::polyhedralmesh& m) {
  std::map<unsigned, cycle> all;
  for (const auto f : cn::faces(m)) all[f.raw()] = cn::testing::raw(cn::adj_f2v(m, f));
  return all;
}

/// Applies c, and checks that it does what the laws ED1, ED2, ED3 and ED5 say.
owned_cavity::made rewires_polyhedra(cn::polyhedralmesh& m, const owned_cavity& c) {
  auto expected = faces_of_polys(m);
  const auto faces_before = verts_of_faces(m);
  const auto edges_before = cn::testing::edge_between(m);
  std::set<unsigned> old_faces;
  for (const auto p : c.polys)
    for (const auto f : cn::adj_p2f(m, p)) old_faces.insert(f.raw());
  const std::size_t verts_before = cn::num_verts(m);
  const auto made = c.apply_to(m);
  for (const auto p : c.polys) expected.erase(p.raw());
  for (std::size_t k = 0, j = 0, i = 0; k < c.num_new(); ++k) {
    if (k < c.kept) CHECK(made.polys[k] == c.polys[k]);
    auto& faces = expected[made.polys[k].raw()];
    for (; j < c.poly_ends[k]; ++j) {
      cycle v;
      for (; i < c.ends[j]; ++i) v.push_back((c.corners[i] < c.verts.size() ? c.verts[c.corners[i]] : made.verts[c.corners[i] - c.verts.size()]).raw());
      faces.push_back(rotated(v));
    }
  }
  CHECK(faces_of_polys(m) == expected);
  cn::testing::common_ones_are_equal(edges_before, cn::testing::edge_between(m));
  const auto faces_after = verts_of_faces(m);
  for (const auto& [f, v] : faces_before)
    if (const auto after = faces_after.find(f); after != faces_after.end()) CHECK((after->second == v || old_faces.count(f) > 0));
    else CHECK(old_faces.count(f) > 0);
  for (const auto f : cn::faces(m))
    if (cn::adj_f2p(m, f).empty()) CHECK(faces_before.count(f.raw()) > 0);
  CHECK(cn::num_verts(m) == verts_before + c.points.size() - c.removed);
  for (std::size_t i = 0; i < c.verts.size(); ++i) CHECK(cn::contains(m, c.verts[i]) == (i + c.removed < c.verts.size()));
  return made;
}

owned_cavity cavity_of_polyhedra(const cn::polyhedralmesh& m, const std::vector<cn::poly_id>& polys) {
  owned_cavity c;
  c.polys = polys;
  for (const auto p : polys)
    for (const auto v : cn::adj_p2v(m, p))
      if (std::find(c.verts.begin(), c.verts.end(), v) == c.verts.end()) c.verts.push_back(v);
  return c;
}

/// The first poly with a neighbour, and that neighbour.
std::vector<cn::poly_id> two_polyhedra(const cn::polyhedralmesh& m) {
  for (const auto p : cn::polys(m))
    for (const auto q : cn::adj_p2p(m, p)) return {p, q};
  return {};
}

}  // namespace

TEST_CASE("rewire: random cavities of random polyhedra give the mesh that they describe") {
  std::mt19937 random(41);
  const unsigned rounds = cn::testing::long_run() ? 300 : 12;
  for (unsigned round = 0; round < rounds; ++round) {
    auto m = round % 2 ? cn::testing::grid<cn::polyhedralmesh>(2) : cn::testing::random_soup<cn::polyhedralmesh>(random, 7 + round, 10).mesh();
    for (unsigned step = 0; step < 25; ++step) {
      rewires_polyhedra(m, cn::testing::random_polyhedra(m, random));
      if (step % 5 == 0) keeps_all_laws(m), equals_rebuilt(m);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
}

TEST_CASE("rewire: polyhedra that are listed as they are keep all their descriptors") {
  auto m = cn::testing::grid<cn::polyhedralmesh>(2);
  std::vector<cn::poly_id> all;
  for (const auto p : cn::polys(m)) all.push_back(p);
  owned_cavity c = cavity_of_polyhedra(m, all);
  for (const auto p : all) cn::testing::add_polyhedron(c, cn::testing::local_faces(c, m, p));
  c.kept = all.size();
  const auto faces = verts_of_faces(m);
  const auto edges = cn::testing::edge_between(m);
  rewires_polyhedra(m, c);
  CHECK(verts_of_faces(m) == faces);
  CHECK(cn::testing::edge_between(m) == edges);
  equals_rebuilt(m);
}

TEST_CASE("rewire: two polyhedra are united and divided again, and a large cavity is removed and added") {
  auto m = cn::testing::grid<cn::polyhedralmesh>(2);
  const auto two = two_polyhedra(m);
  owned_cavity unite = cavity_of_polyhedra(m, two);
  std::vector<cycle> outer;
  const auto first = cn::testing::local_faces(unite, m, two[0]), second = cn::testing::local_faces(unite, m, two[1]);
  std::set<cycle> inner;
  for (const cycle& v : first) inner.insert(rotated(v));
  for (const cycle& v : second)
    if (inner.erase(rotated(reversed(v))) == 0) outer.push_back(v);
  outer.insert(outer.end(), inner.begin(), inner.end());
  CHECK(outer.size() + 2 == first.size() + second.size());
  cn::testing::add_polyhedron(unite, outer);
  unite.kept = 1;
  const std::size_t faces_before = cn::num_faces(m), bound = cn::face_index_bound(m);
  rewires_polyhedra(m, unite);
  CHECK(cn::num_faces(m) == faces_before - 1);
  keeps_all_laws(m);
  owned_cavity divide = unite;
  divide.polys = {two[0]};
  divide.corners.clear(), divide.ends.clear(), divide.poly_ends.clear();
  cn::testing::add_polyhedron(divide, first);
  cn::testing::add_polyhedron(divide, second);
  rewires_polyhedra(m, divide);
  CHECK(cn::num_faces(m) == faces_before);
  CHECK(cn::face_index_bound(m) == bound + 1);
  keeps_all_laws(m);
  equals_rebuilt(m);

  std::vector<cn::poly_id> polys;
  for (const auto p : cn::polys(m)) polys.push_back(p);
  owned_cavity all = cavity_of_polyhedra(m, polys);
  owned_cavity again = all;
  for (const auto p : polys) cn::testing::add_polyhedron(again, cn::testing::local_faces(all, m, p));
  const std::size_t num_edges = cn::num_edges(m), num_polys = cn::num_polys(m);
  all.removed = all.verts.size();
  rewires_polyhedra(m, all);
  CHECK(cn::num_verts(m) + cn::num_edges(m) + cn::num_faces(m) + cn::num_polys(m) == 0);
  again.points.resize(again.verts.size());
  again.polys.clear(), again.verts.clear();
  rewires_polyhedra(m, again);
  CHECK(cn::num_edges(m) == num_edges);
  CHECK(cn::num_faces(m) == faces_before);
  CHECK(cn::num_polys(m) == num_polys);
  equals_rebuilt(m);
}

TEST_CASE("rewire: replacements of polyhedra are undone and done again") {
  std::mt19937 random(42);
  for (unsigned round = 0; round < 8; ++round) {
    auto m = round % 2 ? cn::testing::grid<cn::polyhedralmesh>(2) : cn::testing::random_soup<cn::polyhedralmesh>(random, 8 + round, 10).mesh();
    const auto before = cn::testing::whole(m);
    const auto edit = [&] {
      for (unsigned step = 0; step < 12; ++step) cn::testing::random_polyhedra(m, random).apply_to(m);
    };
    {
      cn::transaction t(m);
      edit();
    }
    CHECK(cn::testing::whole(m) == before);
    cn::transaction t(m);
    edit();
    auto edits = t.commit();
    const auto after = cn::testing::whole(m);
    edits.undo();
    CHECK(cn::testing::whole(m) == before);
    keeps_all_laws(m);
    edits.redo();
    CHECK(cn::testing::whole(m) == after);
    keeps_all_laws(m);
  }
}

TEST_CASE("rewire: a new polyhedron takes a face without polys, and a vert with one stays") {
  cn::polyhedralmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {});
  const cn::face_id f = cn::add_face(m, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}});
  owned_cavity c;
  for (unsigned v = 0; v < 4; ++v) c.verts.push_back(cn::vert_id{v});
  owned_cavity bad = c;
  bad.removed = 4;
  cn::testing::refuses_cavity(m, bad, "rewire: vert 0 cannot be removed: it has a face without polys; remove that first");
  cn::testing::add_polyhedron(c, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  const auto made = rewires_polyhedra(m, c);
  CHECK(cn::adj_p2f(m, made.polys[0])[0] == f);
  CHECK(!cn::face_is_outward(m, made.polys[0], f));
  CHECK(cn::num_faces(m) == 4);
  keeps_all_laws(m);
}

TEST_CASE("rewire: a cavity of polyhedra with a mistake is refused, and nothing changes") {
  const auto m = cn::testing::grid<cn::polyhedralmesh>(2);
  owned_cavity good = cavity_of_polyhedra(m, {cn::poly_id{0}});
  cn::testing::add_polyhedron(good, cn::testing::local_faces(good, m, cn::poly_id{0}));
  good.kept = 1;
  const auto refuses = [&](const auto& change, const std::string& message) {
    owned_cavity c = good;
    change(c);
    cn::testing::refuses_cavity(m, c, message);
  };
  const std::string n = std::to_string(good.ends.size()), corners = std::to_string(good.corners.size());
  refuses([](auto& c) { c.polys = {cn::poly_id{999}}; }, "rewire: old poly 999 is not a poly of the mesh");
  refuses([](auto& c) { c.kept = 2; }, "rewire: 2 polys cannot keep their descriptors: there are 1 old and 1 new ones");
  refuses([](auto& c) { c.poly_ends = {99}; }, "rewire: the faces of new poly 0 end at 99, which is not between 1 and " + n + "; it needs at least 1");
  refuses([](auto& c) { c.poly_ends = {0}; }, "rewire: the faces of new poly 0 end at 0, which is not between 1 and " + n + "; it needs at least 1");
  refuses([](auto& c) { c.ends[0] = 99; }, "rewire: the corners of new face 0 end at 99, which is not between 0 and " + corners);
  refuses([](auto& c) { c.ends[0] = 2; }, "rewire: new face 0 has 2 verts; it needs at least 3");
  refuses([](auto& c) { c.corners[1] = c.corners[0]; }, "rewire: new face 0 has vert " + std::to_string(good.corners[0]) + " of the cavity twice; its verts must differ");
  refuses([](auto& c) { c.corners[1] = 99; }, "rewire: new face 0 names vert 99 of the cavity, which has " + std::to_string(good.verts.size()) + ", numbered from 0");
  refuses([](auto& c) { c.removed = 1; },
          "rewire: vert " + std::to_string(good.verts.back().raw()) + " cannot be removed: it would still have a poly; list all its polys as old polys, and use it in no new one");
  refuses([](auto& c) { c.verts.pop_back(), c.corners.clear(), c.ends.clear(), c.poly_ends.clear(), c.kept = 0; },
          "rewire: vert " + std::to_string(good.verts.back().raw()) + " of old poly 0 is not among the verts of the cavity; list all verts of old and new polys");
  refuses(
      [](auto& c) {
        const cycle v(c.corners.begin(), c.corners.begin() + c.ends[0]);
        c.add_poly(reversed(v));
        c.poly_ends = {static_cast<unsigned>(c.ends.size())};
      },
      "rewire: new poly 0 has face " + n + " of the cavity twice, in the same or the reversed order of its verts; its faces must differ");
}
