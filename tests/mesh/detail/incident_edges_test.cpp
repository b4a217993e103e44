// incident_edges: parallel rows of edges and their other ends, compared with vectors of pairs, and their copies, growth and undoing.
#include <concino/mesh/detail/edit_log.hpp>
#include <concino/mesh/detail/incident_edges.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using concino::edge_id;
using concino::vert_id;
using concino::detail::incident_edges;

namespace {

using pairs = std::vector<std::pair<vert_id, edge_id>>;

pairs row(const incident_edges& all, vert_id v) {
  pairs result;
  for (std::size_t k = 0; k < all.num_edges(v); ++k) result.emplace_back(all.verts(v)[k], all.edges(v)[k]);
  return result;
}

/// Verts with 0, 1, 2, ... edges. Edge e leads to vert 100 + e.
std::vector<pairs> oracle_of(std::size_t n) {
  std::vector<pairs> all(n);
  std::size_t e = 0;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t k = 0; k < v; ++k, ++e) all[v].emplace_back(vert_id{100 + e}, edge_id{e});
  return all;
}

incident_edges packed(const std::vector<pairs>& oracle) {
  concino::detail::offsets where{0};
  concino::core::flat_array<vert_id> verts;
  concino::core::flat_array<edge_id> edges;
  for (const pairs& at : oracle) {
    for (const auto& [v, e] : at) verts.push_back(v), edges.push_back(e);
    where.push_back(static_cast<std::uint32_t>(verts.size()));
  }
  return {std::make_shared<const concino::detail::offsets>(std::move(where)), std::move(verts), std::move(edges)};
}

void agrees(const incident_edges& all, const std::vector<pairs>& oracle) {
  REQUIRE(all.size() == oracle.size());
  for (std::size_t v = 0; v < oracle.size(); ++v) {
    CHECK(row(all, vert_id{v}) == oracle[v]);
    for (std::size_t k = 0; k < oracle[v].size(); ++k) {
      CHECK(all.position(vert_id{v}, oracle[v][k].second) == k);
      CHECK(all.edge_between(vert_id{v}, oracle[v][k].first) == oracle[v][k].second);
    }
    CHECK(all.edge_between(vert_id{v}, vert_id{99}).is_none());
  }
}

/// Random edits. Each takes the next number for what is new, which so occurs once.
void edit_at_random(incident_edges& all, std::vector<pairs>& oracle, std::mt19937& random, std::size_t& number, int rounds) {
  for (int step = 0; step < rounds; ++step, ++number) {
    const std::size_t i = random() % oracle.size();
    const vert_id v{i}, other{20000 + number};
    pairs& at = oracle[i];
    const std::size_t k = at.empty() ? 0 : random() % at.size();
    switch (random() % 8) {
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
        if (random() % 8 == 0) all.clear(v), at.clear();
        break;
      default:
        all.reserve_at(v, 1), all.push(v, other, edge_id{1000 + number});
        at.emplace_back(other, edge_id{1000 + number});
    }
  }
}

}  // namespace

TEST_CASE("incident_edges: random edits agree with vectors of pairs") {
  std::mt19937 random(5);
  std::vector<pairs> oracle = oracle_of(12);
  incident_edges all = packed(oracle);
  SUBCASE("spread") {}
  SUBCASE("where the rows were") { all.make_few_growable(); }
  agrees(all, oracle);
  std::size_t number = 0;
  edit_at_random(all, oracle, random, number, 2000);
  agrees(all, oracle);
}

TEST_CASE("incident_edges: most rows have room after the first edit, and copies keep it") {
  std::vector<pairs> oracle = oracle_of(20);
  incident_edges all = packed(oracle);
  all.make_growable();
  agrees(all, oracle);
  incident_edges copy = all;
  const std::size_t values = copy.num_values();
  for (std::size_t v = 0; v < 20; ++v) copy.reserve_at(vert_id{v}, 1), copy.push(vert_id{v}, vert_id{7}, edge_id{900 + v});
  CHECK(copy.num_values() == values);
  agrees(all, oracle);
  for (std::size_t v = 0; v < 20; ++v) oracle[v].emplace_back(vert_id{7}, edge_id{900 + v});
  agrees(copy, oracle);
}

TEST_CASE("incident_edges: saved rows come back, also if they were packed when they were saved") {
  using saved = concino::detail::saved<incident_edges>;
  std::mt19937 random(6);
  std::vector<pairs> oracle = oracle_of(12);
  incident_edges all = packed(oracle);
  std::size_t number = 0;
  for (int round = 0; round < 20; ++round) {
    const std::vector<pairs> before = oracle;
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
