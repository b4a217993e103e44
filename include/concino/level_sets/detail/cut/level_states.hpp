// The values of level sets, the verts below, on and above one, and the polys that it crosses.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/number_in_messages.hpp>
#include <concino/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

/// One value or several.
template<class V>
concept is_value_list = std::is_arithmetic_v<V> || requires(const V& values) {
  { *values.begin() } -> std::convertible_to<double>;
  values.end();
};

}  // namespace requirement

namespace detail {

/// The values of level sets that a caller gives, in ascending order, each once.
/// Errors: invalid_argument if one is NaN.
inline std::vector<double> sort_levels(std::vector<double> levels, const char* caller) {
  for (const double x : levels)
    if (std::isnan(x))
      core::throw_joined<invalid_argument>({caller, ": the value of a level set is not a number (NaN)"});
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}
template<class V>
std::vector<double> sorted_levels(const V& values, const char* caller) {
  std::vector<double> all;
  if constexpr (std::is_arithmetic_v<V>) {
    all.push_back(static_cast<double>(values));
  } else {
    for (const auto& x : values) all.push_back(static_cast<double>(x));
  }
  return sort_levels(std::move(all), caller);
}

/// Where the value of a vert lies, as bits, so that those of several verts can be joined. Verts on the level set count
/// as above.
inline constexpr unsigned char below_level = 1, on_level = 2, above_level = 4;

inline unsigned char level_state(double x, double level) {
  return x < level ? below_level : x == level ? on_level : above_level;
}
inline bool is_crossed(unsigned char joint_states) {
  return (joint_states & below_level) && joint_states != below_level;
}

/// Errors: invalid_argument if u is a map of another mesh, or was made before verts were added.
template<class M, class U>
void check_vert_values(const M& m, const U& u, const char* caller) {
  if constexpr (!is_view_v<M> && requires { { u.mesh() } -> std::same_as<const M&>; })
    if (&u.mesh() != &m)
      core::throw_joined<invalid_argument>(
          {caller, ": the values belong to another mesh; make the map with make_vert_map<double>(m)"});
  if constexpr (requires { u.values().size(); })
    if (const std::size_t size = u.values().size(), bound = vert_index_bound(m); size < bound)
      core::throw_joined<invalid_argument>({caller, ": there are values for the verts below index ", size,
                                            ", but the mesh has verts up to index ", bound - 1,
                                            "; the map was made for another mesh, or before verts were added"});
}

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_value_is_nan(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": the value at vert ", vert, " is not a number (NaN)"});
}

/// The states of all verts, by index.
/// Errors: invalid_argument that names a vert whose value is NaN.
template<class M, class U>
std::vector<unsigned char> level_states(const M& m, const U& u, double level, const char* caller) {
  std::vector<unsigned char> states(vert_index_bound(m));
  parallel_for_each(
      verts(m),
      [&](const vert_t<M>& v) {
        const double x = static_cast<double>(u[v]);
        if (std::isnan(x)) throw_value_is_nan(caller, core::number_in_messages(m, v));
        states[index_of(m, v)] = level_state(x, level);
      },
      8192);
  return states;
}

/// The polys with verts below the level set and others, in the order of polys(m). states: of all verts, by index.
template<class M>
std::vector<poly_t<M>> crossed_polys(const M& m, const std::vector<unsigned char>& states) {
  std::vector<unsigned char> crossed(poly_index_bound(m));
  parallel_for_each(
      polys(m),
      [&](const poly_t<M>& p) {
        unsigned char joint = 0;
        for (const vert_t<M> v : adj_p2v(m, p)) joint |= states[index_of(m, v)];
        crossed[index_of(m, p)] = is_crossed(joint);
      },
      8192);
  std::vector<poly_t<M>> all;
  for (const poly_t<M> p : polys(m))
    if (crossed[index_of(m, p)]) all.push_back(p);
  return all;
}

}  // namespace detail

}  // namespace concino
