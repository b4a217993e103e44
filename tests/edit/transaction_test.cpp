// transaction: what is not committed leaves no trace; committed edits can be undone and done again; transactions can be nested.
#include <concino/edit.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <random>
#include <stdexcept>
#include <string>

namespace cn = concino;
using cn::testing::keeps_all_laws;
using cn::testing::raw;
using cn::testing::whole;

namespace {

template<class X>
X some(const std::vector<X>& all, std::mt19937& random) {
  return all[random() % all.size()];
}
template<class M>
auto all_polys(const M& m) {
  std::vector<cn::poly_id> all;
  for (const auto p : cn::polys(m)) all.push_back(p);
  return all;
}
template<class M>
auto all_verts(const M& m) {
  std::vector<cn::vert_id> all;
  for (const auto v : cn::verts(m)) all.push_back(v);
  return all;
}

/// One random edit with the functions that all editable meshes have.
template<class M>
void edit_somewhere(M& m, std::mt19937& random) {
  const auto v = all_verts(m);
  const auto p = all_polys(m);
  const unsigned n = cn::arity_v<M> ? static_cast<unsigned>(cn::arity_v<M>) : 3 + static_cast<unsigned>(random() % 3);
  switch (random() % 6) {
    case 0: cn::add_vert(m, {1, 2, static_cast<double>(random() % 5)}); break;
    case 1:
      if (!p.empty()) cn::remove_poly(m, some(p, random));
      break;
    case 2:
      if (!v.empty()) cn::set_point(m, some(v, random), cn::vec3{9, 8, 7});
      break;
    case 3:
      if (v.size() > 4 && random() % 3 == 0) cn::remove_vert(m, some(v, random));
      break;
    case 4: {
      std::vector<cn::edge_id> e;
      for (const auto x : cn::edges(m)) e.push_back(x);
      if (e.empty()) break;
      if constexpr (cn::requirement::can_split_edges<M>) cn::edge_split(m, some(e, random));
      else cn::edge_collapse(m, some(e, random));  // is refused
      break;
    }
    default:
      if (v.size() >= n) {
        std::vector<cn::vert_id> corners;
        for (const unsigned i : cn::testing::some_of(random, static_cast<unsigned>(v.size()), n)) corners.push_back(v[i]);
        cn::add_poly(m, std::span<const cn::vert_id>(corners));
      }
  }
}

/// Properties whose bytes can be copied, with a different value for each element.
template<class M>
void give_numbers(M& m) {
  const auto a = cn::vert_property<double>(m, "a");
  for (const auto v : cn::verts(m)) a[v] = 0.5 + v.raw();
  const auto d = cn::poly_property<int>(m, "d");
  for (const auto p : cn::polys(m)) d[p] = static_cast<int>(p.raw());
}

template<class M>
M start(std::mt19937& random, unsigned round) {
  M m = round % 2 ? cn::testing::grid<M>(2) : cn::testing::random_soup<M>(random, 12, 12).mesh();
  if (round % 3 == 0) give_numbers(m);
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("transaction: without commit, the mesh is as it was", M, CONCINO_ALL_SURFACE_KINDS, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(5);
  for (unsigned round = 0; round < 20; ++round) {
    M m = start<M>(random, round);
    for (auto i = random() % 20; i > 0; --i) edit_somewhere(m, random);
    const auto before = whole(m);
    {
      cn::transaction t(m);
      for (unsigned i = 0; i < 25; ++i) edit_somewhere(m, random);
    }
    CHECK(whole(m) == before);
    keeps_all_laws(m);
    for (unsigned i = 0; i < 10; ++i) edit_somewhere(m, random);
    keeps_all_laws(m);
  }
}

TEST_CASE_TEMPLATE("transaction: committed edits can be undone and done again", M, CONCINO_ALL_SURFACE_KINDS, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(6);
  for (unsigned round = 0; round < 10; ++round) {
    M m = start<M>(random, round);
    std::vector<std::vector<double>> states{whole(m)};
    std::vector<cn::committed_edits<M>> done;
    for (unsigned k = 0; k < 5; ++k) {
      cn::transaction t(m);
      for (unsigned i = 0; i < 6; ++i) edit_somewhere(m, random);
      done.push_back(t.commit());
      states.push_back(whole(m));
    }
    for (unsigned times = 0; times < 3; ++times) {
      const std::size_t depth = 1 + random() % 5;
      for (std::size_t k = 5; k > 5 - depth; --k) {
        done[k - 1].undo();
        CHECK(whole(m) == states[k - 1]);
      }
      keeps_all_laws(m);
      for (std::size_t k = 5 - depth; k < 5; ++k) {
        done[k].redo();
        CHECK(whole(m) == states[k + 1]);
      }
      keeps_all_laws(m);
    }
  }
}

TEST_CASE("transaction: an exception undoes the edits") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  const auto before = whole(m);
  CHECK_THROWS_AS(
      [&] {
        cn::transaction t(m);
        cn::edge_split(m, cn::edge_id{0});
        throw std::runtime_error("no");
      }(),
      std::runtime_error);
  CHECK(whole(m) == before);
}

TEST_CASE("transaction: an inner one can be undone alone, or with the outer one") {
  std::mt19937 random(7);
  cn::trimesh m = cn::testing::grid<cn::trimesh>(3);
  const auto before = whole(m);
  {
    cn::transaction outer(m);
    cn::edge_split(m, cn::edge_id{0});
    const auto middle = whole(m);
    {
      cn::transaction inner(m);
      for (unsigned i = 0; i < 10; ++i) edit_somewhere(m, random);
    }
    CHECK(whole(m) == middle);
    {
      cn::transaction inner(m);
      cn::edge_split(m, cn::edge_id{3});
      CHECK_FALSE(inner.commit());
    }
    CHECK(whole(m) != middle);
  }
  CHECK(whole(m) == before);
}

TEST_CASE("transaction: mistakes") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  cn::transaction t(m);
  cn::edge_split(m, cn::edge_id{0});
  auto edits = t.commit();
  CHECK_THROWS_WITH_AS(t.commit(), "commit: the transaction has ended already", cn::invalid_argument);
  CHECK_THROWS_WITH_AS(t.roll_back(), "roll_back: the transaction has ended already", cn::invalid_argument);
  CHECK_THROWS_WITH_AS(edits.redo(), "redo: the mesh is not in the state that these edits began with; undo later edits first", cn::invalid_argument);
  cn::add_vert(m, {0, 0, 0});
  const auto now = whole(m);
  CHECK_THROWS_WITH_AS(edits.undo(), "undo: the mesh is not in the state that these edits made; undo later edits first", cn::invalid_argument);
  CHECK(whole(m) == now);
  CHECK_THROWS_AS(cn::committed_edits<cn::trimesh>().undo(), cn::invalid_argument);

  cn::vert_property<std::string>(m, "name");
  CHECK_THROWS_WITH_AS(cn::transaction<cn::trimesh>{m}, "transaction: property \"name\" has values that cannot be copied byte by byte, so they could not be restored without memory; remove it first", cn::unsupported);
  CHECK(whole(m) == now);
}

TEST_CASE("transaction: a copy of a mesh is not part of it") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  cn::transaction t(m);
  cn::trimesh copy = m;
  cn::edge_split(copy, cn::edge_id{0});
  const auto changed = whole(copy);
  t.roll_back();
  CHECK(whole(copy) == changed);
}

TEST_CASE("transaction: faces and polys of polyhedra that are added and removed one by one") {
  std::mt19937 random(8);
  const auto listed = [](const auto& range) { return std::vector<std::remove_cvref_t<decltype(*range.begin())>>(range.begin(), range.end()); };
  const auto edit = [&](cn::polyhedralmesh& m) {
    const auto verts = listed(cn::verts(m));
    const auto faces = listed(cn::faces(m));
    const auto polys = listed(cn::polys(m));
    const auto v = verts[random() % verts.size()];
    switch (polys.empty() || faces.size() < 3 ? 0 : random() % 7) {
      case 0: cn::add_face(m, {v, cn::add_vert(m, {1, 2, 3}), cn::add_vert(m, {1, 2, 4})}); break;
      case 1: {
        std::vector<cn::vert_id> corners;
        for (const unsigned i : cn::testing::some_of(random, static_cast<unsigned>(verts.size()), 4)) corners.push_back(verts[i]);
        cn::add_face(m, std::span<const cn::vert_id>(corners));
        break;
      }
      case 2:
      case 3: {
        const auto some = cn::testing::some_of(random, static_cast<unsigned>(faces.size()), 3);
        cn::add_poly(m, {{faces[some[0]], true}, {faces[some[1]], false}, {faces[some[2]], true}});
        break;
      }
      case 4: cn::remove_face(m, faces[random() % faces.size()]); break;
      case 5: cn::remove_vert(m, v); break;
      default: cn::remove_poly(m, polys[random() % polys.size()]);
    }
  };
  for (unsigned round = 0; round < 8; ++round) {
    auto m = round % 2 ? cn::testing::grid<cn::polyhedralmesh>(2) : cn::testing::random_soup<cn::polyhedralmesh>(random, 15, 9).mesh();
    const auto a = cn::vert_property<double>(m, "a");
    for (const auto v : cn::verts(m)) a[v] = v.raw();
    cn::face_property<int>(m, "i");
    const auto before = whole(m);
    {
      cn::transaction t(m);
      for (unsigned i = 0; i < 6; ++i) edit(m);
      if (round % 3 == 0) cn::remove_unreferenced(m);
      keeps_all_laws(m);
      CHECK(whole(m) != before);
    }
    CHECK(whole(m) == before);
    keeps_all_laws(m);
    cn::transaction t(m);
    for (unsigned i = 0; i < 6; ++i) edit(m);
    const auto after = whole(m);
    auto edits = t.commit();
    for (unsigned times = 0; times < 2; ++times) {
      edits.undo();
      CHECK(whole(m) == before);
      keeps_all_laws(m);
      edits.redo();
      CHECK(whole(m) == after);
      keeps_all_laws(m);
    }
    for (unsigned i = 0; i < 6; ++i) edit(m);
    keeps_all_laws(m);
  }
}
