// incident_lists: parallel rows of edges, their other ends and polys, compared with vectors, and their copies, growth and undoing.
#include <concino/mesh/detail/edits/edit_log.hpp>
#include <concino/mesh/detail/rows/incident_lists.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

using concino::edge_id;
using concino::poly_id;
using concino::vert_id;
using concino::detail::incident_edges;
using concino::detail::incident_edges_and_polys;

namespace {

template<class T>
constexpr bool has_polys = std::is_same_v<T, incident_edges_and_polys>;

struct at_vert {
  std::vector<std::pair<vert_id, edge_id>> edges;
  std::vector<poly_id> polys;

  bool operator==(const at_vert&) const = default;
};

template<class T>
at_vert row(const T& all, vert_id v) {
  at_vert result;
  for (std::size_t k = 0; k < all.num_edges(v); ++k) result.edges.emplace_back(all.verts(v)[k], all.edges(v)[k]);
  if constexpr (has_polys<T>) {
    result.polys.assign(all.polys(v).begin(), all.polys(v).end());
    CHECK(result.polys.size() == all.num_polys(v));
  }
  return result;
}

/// Verts with 0, 1, 2, ... edges. Edge e leads to vert 100 + e. The numbers of their polys are the same, or others.
template<class T>
std::vector<at_vert> oracle_of(std::size_t n, bool same_numbers) {
  std::vector<at_vert> all(n);
  std::size_t e = 0, p = 0;
  for (std::size_t v = 0; v < n; ++v) {
    for (std::size_t k = 0; k < v; ++k, ++e) all[v].edges.emplace_back(vert_id{100 + e}, edge_id{e});
    if constexpr (has_polys<T>)
      for (std::size_t k = 0; k < (same_numbers ? v : (5 * v + 3) % n); ++k, ++p) all[v].polys.push_back(poly_id{p});
  }
  return all;
}

template<class T>
T packed(const std::vector<at_vert>& oracle) {
  concino::detail::offsets where{0}, of_polys{0};
  concino::core::flat_array<vert_id> verts;
  concino::core::flat_array<edge_id> edges;
  concino::core::flat_array<poly_id> polys;
  for (const at_vert& at : oracle) {
    for (const auto& [v, e] : at.edges) verts.push_back(v), edges.push_back(e);
    for (const poly_id p : at.polys) polys.push_back(p);
    where.push_back(static_cast<std::uint32_t>(verts.size())), of_polys.push_back(static_cast<std::uint32_t>(polys.size()));
  }
  const auto shared = [](concino::detail::offsets&& o) { return std::make_shared<const concino::detail::offsets>(std::move(o)); };
  if constexpr (has_polys<T>) return {shared(std::move(where)), std::move(verts), std::move(edges), shared(std::move(of_polys)), std::move(polys)};
  else return {shared(std::move(where)), std::move(verts), std::move(edges)};
}

template<class T>
void agrees(const T& all, const std::vector<at_vert>& oracle) {
  REQUIRE(all.size() == oracle.size());
  for (std::size_t i = 0; i < oracle.size(); ++i) {
    const vert_id v{i};
    CHECK(row(all, v) == oracle[i]);
    for (std::size_t k = 0; k < oracle[i].edges.size(); ++k) {
      CHECK(all.position(v, oracle[i].edges[k].second) == k);
      CHECK(all.edge_between(v, oracle[i].edges[k].first) == oracle[i].edges[k].second);
    }
    CHECK(all.edge_between(v, vert_id{99}).is_none());
    if constexpr (has_polys<T>)
      for (std::size_t k = 0; k < oracle[i].polys.size(); ++k) CHECK(all.position(v, oracle[i].polys[k]) == k);
  }
}

/// Random edits. Each takes the next number for what is new, which so occurs once.
template<class T>
void edit_at_random(T& all, std::vector<at_vert>& oracle, std::mt19937& random, std::size_t& number, int rounds) {
  for (int step = 0; step < rounds; ++step, ++number) {
    const std::size_t i = random() % oracle.size();
    const vert_id v{i}, other{20000 + number};
    auto& at = oracle[i].edges;
    const std::size_t k = at.empty() ? 0 : random() % at.size();
    const unsigned long what = random() % (has_polys<T> ? 12 : 8);
    switch (what) {
      case 0:
        all.reserve_verts(1, 3), all.add_vert(3);
        oracle.emplace_back();
        break;
      case 1:
        if (!at.empty()) all.make_growable(), all.remove(v, at[k].second), at.erase(at.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      case 2:
        if (!at.empty()) all.make_growable(), all.replace_by_last(v, at[k].second), at[k] = at.back(), at.pop_back();
        break;
      case 3:
        if (!at.empty()) all.make_growable(), all.set_other_end(v, at[k].second, other), at[k].first = other;
        break;
      case 4:
        if (random() % 8 == 0) all.clear(v), oracle[i] = {};
        break;
      default:
        if (what < 8) {
          all.reserve_at(v, 1), all.push(v, other, edge_id{1000 + number});
          at.emplace_back(other, edge_id{1000 + number});
        } else if constexpr (has_polys<T>) {
          auto& polys = oracle[i].polys;
          if (what == 8 && !polys.empty()) {
            const auto p = polys.begin() + static_cast<std::ptrdiff_t>(random() % polys.size());
            all.make_growable(), all.remove(v, *p), polys.erase(p);
          } else if (what == 9) {  // both at once
            all.reserve_at(v, 1, 2), all.push(v, other, edge_id{1000 + number}), all.push(v, poly_id{2000 + 2 * number}), all.push(v, poly_id{2001 + 2 * number});
            at.emplace_back(other, edge_id{1000 + number}), polys.push_back(poly_id{2000 + 2 * number}), polys.push_back(poly_id{2001 + 2 * number});
          } else {
            all.reserve_at(v, 0, 1), all.push(v, poly_id{2000 + 2 * number});
            polys.push_back(poly_id{2000 + 2 * number});
          }
        }
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("incident_lists: random edits agree with vectors", T, incident_edges, incident_edges_and_polys) {
  for (const bool same_numbers : {true, false}) {
    std::mt19937 random(5);
    std::vector<at_vert> oracle = oracle_of<T>(12, same_numbers);
    T all = packed<T>(oracle);
    agrees(all, oracle);
    std::size_t number = 0;
    edit_at_random(all, oracle, random, number, 2000);
    agrees(all, oracle);
  }
}

TEST_CASE_TEMPLATE("incident_lists: most rows have room after the first edit, and copies keep it", T, incident_edges, incident_edges_and_polys) {
  std::vector<at_vert> oracle = oracle_of<T>(20, false);
  T all = packed<T>(oracle);
  all.make_growable();
  agrees(all, oracle);
  T copy = all;
  const std::size_t values = copy.num_values();
  for (std::size_t v = 0; v < 20; ++v) copy.reserve_at(vert_id{v}, 1), copy.push(vert_id{v}, vert_id{7}, edge_id{900 + v});
  CHECK(copy.num_values() == values);
  agrees(all, oracle);
  for (std::size_t v = 0; v < 20; ++v) oracle[v].edges.emplace_back(vert_id{7}, edge_id{900 + v});
  agrees(copy, oracle);
}

TEST_CASE_TEMPLATE("incident_lists: saved rows come back, also if they were packed when they were saved", T, incident_edges, incident_edges_and_polys) {
  using saved = concino::detail::saved<T>;
  std::mt19937 random(6);
  for (const bool same_numbers : {true, false}) {
    std::vector<at_vert> oracle = oracle_of<T>(12, same_numbers);
    T all = packed<T>(oracle);
    std::size_t number = 0;
    for (int round = 0; round < 20; ++round) {
      const std::vector<at_vert> before = oracle;
      std::uint64_t sizes[2];
      saved::sizes(all, sizes);
      std::vector<std::vector<unsigned char>> rows(oracle.size());
      for (std::size_t v = 0; v < oracle.size(); ++v) saved::put(all, v, rows[v]);
      edit_at_random(all, oracle, random, number, 60);
      for (std::size_t v = before.size(); v-- > 0;) saved::restore(all, v, rows[v].data(), rows[v].size());
      saved::resize(all, sizes);
      oracle = before;
      agrees(all, oracle);
      if (round % 3 == 0) edit_at_random(all, oracle, random, number, 60);
    }
  }
}

TEST_CASE("incident_lists: places of edges and polys agree with vectors") {
  std::mt19937 random(9);
  std::vector<at_vert> oracle = oracle_of<incident_edges_and_polys>(12, false);
  auto all = packed<incident_edges_and_polys>(oracle);
  all.make_growable();
  std::size_t number = 0;
  for (int round = 0; round < 20; ++round) {
    edit_at_random(all, oracle, random, number, 60);
    for (std::size_t i = 0; i < oracle.size(); ++i) {
      const vert_id v{i};
      const auto& [edges, polys] = oracle[i];
      REQUIRE(all.num_edges(v) == edges.size());
      for (std::size_t k = 0; k < edges.size(); ++k) {
        CHECK(all.position(v, edges[k].second) == k);
        CHECK(all.find(v, edges[k].first) == k);
      }
      for (std::size_t k = 0; k < polys.size(); ++k) CHECK(all.position(v, polys[k]) == k);
      CHECK(all.find(v, vert_id{99}) == edges.size());
    }
  }
}
