// Tables of tets and hexes: the polys around edges that are not a simple ring or fan, and invalid lists of verts.
#include <concino/mesh/cell_tables.hpp>

#include <support/cell_edges.hpp>
#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<unsigned>;

template<class Tables>
Tables tables_of(unsigned vert_count, const std::vector<list>& polys) {
  std::vector<vert_id> verts;
  for (const list& p : polys)
    for (const unsigned v : p) verts.push_back(vert_id{v});
  return Tables(vert_count, verts);
}

template<class Tables>
constexpr unsigned corners_v = std::same_as<Tables, tet_tables> ? 4 : 8;

}  // namespace

TEST_CASE_TEMPLATE("cell_tables: the polys around edges of any soup are right, built and edited", M, tetmesh, hexmesh) {
  std::mt19937 random(17);
  for (unsigned round = 0; round < 60; ++round) {
    const unsigned vert_count = 8 + static_cast<unsigned>(random() % 5), poly_count = 1 + static_cast<unsigned>(random() % 40);
    const auto soup = random_soup<M>(random, vert_count, poly_count);
    auto t = tables_of<std::remove_cvref_t<decltype(std::declval<M>().tables())>>(vert_count, soup.verts);
    edges_are_right(t);
    for (unsigned p = 0; p < poly_count; p += 2) t.remove_poly(poly_id{p});
    edges_are_right(t);
    for (unsigned p = 0; p < poly_count; p += 4) {
      std::vector<vert_id> corners;
      for (const unsigned v : soup.verts[p]) corners.push_back(vert_id{v});
      t.add_poly(corners);
    }
    edges_are_right(t);
  }
  edges_are_right(grid<M>(3).tables());
}

TEST_CASE("cell_tables: the polys around an edge with several rings and fans are right") {
  // Each entry is a ring (closed) or fan (open) of that many tets around the edge 0-1.
  struct fan { unsigned tets; bool closed; };
  const std::vector<std::vector<fan>> cases = {{{3, true}}, {{6, true}}, {{9, true}}, {{3, true}, {3, true}}, {{3, true}, {4, true}}, {{8, true}, {3, true}},
                                               {{3, true}, {8, true}}, {{5, false}}, {{3, true}, {2, false}}, {{2, false}, {2, false}},
                                               {{254, true}}, {{255, true}}, {{256, true}}, {{300, true}, {3, true}}, {{254, false}}, {{255, false}}, {{300, false}},
                                               {{300, false}, {300, false}}};
  for (const auto& fans : cases)
    for (unsigned variant = 0; variant < 8; ++variant) {
      std::vector<list> tets;
      unsigned next = 2;
      for (const fan& f : fans) {
        const unsigned first = next;
        for (unsigned i = 0; i < f.tets; ++i) tets.push_back({0, 1, next + i, f.closed && i + 1 == f.tets ? first : next + i + 1});
        next += f.tets + (f.closed ? 0 : 1);
      }
      // more tets, so that the edge is not the first one
      tets.insert(tets.begin(), {{next, next + 1, next + 2, next + 3}, {next, next + 1, next + 2, next + 4}});
      next += 5;
      for (list& t : tets) {
        std::rotate(t.begin(), t.begin() + variant / 2, t.end());
        if (variant % 2)
          for (unsigned& v : t) v = next - 1 - v;
      }
      edges_are_right(tables_of<tet_tables>(next, tets));
    }
}

TEST_CASE("cell_tables: the polys around an edge with equal polys or many polys at a face are right") {
  for (const unsigned pairs : {1u, 2u, 3u}) {
    std::vector<list> tets;
    for (unsigned i = 0; i < pairs; ++i) tets.insert(tets.end(), 2, {0, 1, 2 + 2 * i, 3 + 2 * i});
    edges_are_right(tables_of<tet_tables>(2 + 2 * pairs, tets));
  }
  list order = {0, 1, 2, 3, 4, 5, 6};
  do {
    std::vector<list> tets = {{0, 1, 2, 3}, {0, 1, 3, 5}, {0, 1, 5, 2}, {0, 1, 2, 4}, {0, 1, 4, 6}, {0, 1, 6, 2}};
    for (list& t : tets)
      for (unsigned& v : t) v = order[v];
    edges_are_right(tables_of<tet_tables>(7, tets));
  } while (std::next_permutation(order.begin(), order.begin() + 5));
}

TEST_CASE_TEMPLATE("cell_tables: an invalid or repeated vert is found at any position", Tables, tet_tables, hex_tables) {
  constexpr unsigned n = corners_v<Tables>;
  const auto complaint = [](const std::vector<list>& lists) -> std::string {
    try {
      tables_of<Tables>(9, lists);
    } catch (const invalid_mesh& e) {
      return e.what();
    }
    return "nothing was thrown";
  };
  list good, other;
  for (unsigned i = 0; i < n; ++i) good.push_back(8 - i), other.push_back(i);
  CHECK(complaint({good, good, other}) == "nothing was thrown");
  CHECK(complaint({good, list(n, 3), other}).find("poly 1 has vert 3 twice") != std::string::npos);
  for (unsigned i = 0; i < n; ++i) {
    list bad = good;
    bad[i] = 9;
    CHECK(complaint({good, bad, other}).find("poly 1 names vert 9") != std::string::npos);
    for (unsigned j = 0; j < i; ++j) {
      bad[i] = good[j];
      CHECK(complaint({good, bad, other}).find("poly 1 has vert " + std::to_string(good[j]) + " twice") != std::string::npos);
    }
  }
}
