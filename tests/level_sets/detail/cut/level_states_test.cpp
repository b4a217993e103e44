#include <concino/level_sets/detail/cut/level_states.hpp>

#include <concino/concepts/views/forward.hpp>
#include <concino/edit/elements.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cn = concino;

namespace {

/// The same mesh with verts numbered from the last to the first.
struct renumbered : cn::views::view_base<cn::trimesh> {
  using cn::views::view_base<cn::trimesh>::view_base;
};

}  // namespace

template<>
struct concino::mesh_traits<renumbered> : concino::detail::forward_all<renumbered, concino::trimesh> {
  using forwarded = concino::detail::forward_all<renumbered, concino::trimesh>;
  static constexpr bool is_view = true;
  using forwarded::index_of;
  static std::size_t index_of(const renumbered& m, const vert_id& v) { return concino::vert_index_bound(m.base()) - 1 - v.raw(); }
};

namespace {

/// A map whose values are not in an array.
struct computed_values {
  const std::vector<double>& all;
  double operator[](cn::vert_id v) const { return all[v.raw()]; }
};

/// The states of the verts of m, without those of deleted ones.
template<class U>
std::vector<int> states_of(const cn::trimesh& m, const U& u, double level) {
  const auto states = cn::detail::level_states(m, u, level, "test");
  std::vector<int> all;
  for (const auto v : cn::verts(m)) all.push_back(states[v.raw()]);
  return all;
}
template<class U>
std::string error_of(const cn::trimesh& m, const U& u) {
  try {
    (void)cn::detail::level_states(m, u, 0.5, "test");
  } catch (const cn::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("level_states: below, on and above, of maps of all types, with any number of threads") {
  auto m = cn::testing::grid<cn::trimesh>(300);
  const double values[] = {-std::numeric_limits<double>::infinity(), -1, -0.0, 0, 1, std::numeric_limits<double>::infinity(), 0.5};
  std::vector<double> all(cn::vert_index_bound(m));
  auto u = cn::make_vert_map<double>(m);
  auto single = cn::make_vert_map<float>(m);
  auto whole = cn::make_vert_map<int>(m);
  auto flag = cn::make_vert_map<bool>(m);
  const auto named = cn::vert_property<double>(m, "u");
  for (const auto v : cn::verts(m)) {
    const double x = values[v.raw() * 7919 % 7];
    all[v.raw()] = u[v] = named[v] = x;
    single[v] = static_cast<float>(x);
    whole[v] = static_cast<int>(v.raw() % 3) - 1;
    flag[v] = v.raw() % 3 == 1 ? 7 : 0;  // stored as a byte, read as true
  }
  std::vector<int> expected, of_whole, of_flag;
  for (const auto v : cn::verts(m)) {
    expected.push_back(cn::detail::level_state(all[v.raw()], 0));
    of_whole.push_back(cn::detail::level_state(whole[v], 0));
    of_flag.push_back(v.raw() % 3 == 1 ? cn::detail::on_level : cn::detail::below_level);
  }
  for (const int threads : {1, 2, 3}) {
    const cn::testing::with_num_threads fixed(threads);
    CHECK(states_of(m, computed_values{all}, 0) == expected);
    CHECK(states_of(m, u, 0) == expected);
    CHECK(states_of(m, named, 0) == expected);
    CHECK(states_of(m, single, 0) == expected);
    CHECK(states_of(m, whole, 0) == of_whole);
    CHECK(states_of(m, flag, 1) == of_flag);
  }
}

TEST_CASE("level_states: values by vert, not by index, if the map is of a mesh that numbers its verts in another way") {
  const auto m = cn::testing::grid<cn::trimesh>(5);
  const renumbered other(m);
  auto of_m = cn::make_vert_map<double>(m);
  auto own = cn::make_vert_map<double>(other);
  for (const auto v : cn::verts(m)) of_m[v] = own[v] = v.raw() % 3;
  const auto states = cn::detail::level_states(other, of_m, 1, "test"), of_own = cn::detail::level_states(other, own, 1, "test");
  for (const auto v : cn::verts(m)) {
    CHECK(states[cn::index_of(other, v)] == cn::detail::level_state(of_m[v], 1));
    CHECK(of_own[cn::index_of(other, v)] == cn::detail::level_state(of_m[v], 1));
  }
}

TEST_CASE("level_states: NaN is an error that names the first such vert, but not at the index of a deleted one") {
  auto m = cn::testing::grid<cn::trimesh>(200);
  const cn::vert_id gone = cn::add_vert(m, {0, 0, 1});
  cn::add_vert(m, {0, 0, 2});
  cn::remove_vert(m, gone);
  auto u = cn::make_vert_map<double>(m);
  u[gone] = std::nan("");
  CHECK(error_of(m, u) == "none");
  for (const auto v : cn::verts(m)) u[v] = v.raw() % 2;
  const auto states = states_of(m, u, 0.5);
  CHECK(states.size() == cn::num_verts(m));
  CHECK(states.back() == cn::detail::level_state(u[cn::vert_id{gone.raw() + 1}], 0.5));
  u[cn::vert_id{40'000}] = u[cn::vert_id{1234}] = std::nan("");
  CHECK(error_of(m, u) == "test: the value at vert 1234 is not a number (NaN)");
}

TEST_CASE("crossed_polys: those with verts below and others, whether these are on the level set or above") {
  const auto m = cn::testing::grid<cn::trimesh>(20);
  std::vector<unsigned char> states(cn::vert_index_bound(m));
  constexpr unsigned char all[] = {cn::detail::below_level, cn::detail::on_level, cn::detail::above_level};
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = all[i * i % 11 % 3];
  std::vector<cn::poly_id> expected;
  for (const auto p : cn::polys(m)) {
    int below = 0;
    for (const auto v : cn::adj_p2v(m, p)) below += states[v.raw()] == cn::detail::below_level;
    if (below == 1 || below == 2) expected.push_back(p);
  }
  CHECK(expected.size() > 100);
  CHECK(cn::detail::crossed_polys(m, states) == expected);
}
