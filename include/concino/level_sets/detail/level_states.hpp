// The verts below, on and above a level set, checks of the values at verts, and the polys that a level set crosses.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/collect.hpp>
#include <concino/core/error.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/temporary_array.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Where the value of a vert lies, as bits, so that those of several verts can be joined. Verts on the level set count as above.
inline constexpr unsigned char below_level = 1, on_level = 2, above_level = 4;

/// States by index. In new memory, large pages save most of the time in which this many bytes are written once.
using state_array = core::temporary_array<unsigned char>;

inline unsigned char level_state(double x, double level) {
  return x < level ? below_level : x == level ? on_level : above_level;
}
inline bool is_crossed(unsigned char joint_states) { return (joint_states & below_level) && joint_states != below_level; }

/// Whether a call that finds a level set takes so long, about half a millisecond, that it makes a core::thread_team.
template<class M>
bool has_many_polys(const M& m) { return poly_index_bound(m) >= 100'000; }

/// Errors: invalid_argument if u is a map of another mesh, or was made before verts were added.
template<class M, class U>
void check_vert_values(const M& m, const U& u, const char* caller) {
  if constexpr (!is_view_v<M> && requires { { u.mesh() } -> std::same_as<const M&>; })
    if (&u.mesh() != &m) core::throw_joined<invalid_argument>({caller, ": the values belong to another mesh; make the map with make_vert_map<double>(m)"});
  if constexpr (requires { u.values().size(); })
    if (const std::size_t size = u.values().size(), bound = vert_index_bound(m); size < bound)
      core::throw_joined<invalid_argument>({caller, ": there are values for the verts below index ", size, ", but the mesh has verts up to index ", bound - 1,
                                            "; the map was made for another mesh, or before verts were added"});
}

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_value_is_nan(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": the value at vert ", vert, " is not a number (NaN)"});
}

/// Values that an array holds as they are: vert_map<bool> stores bytes.
template<class T> concept is_stored_number = std::is_arithmetic_v<T> && !std::is_same_v<std::remove_cv_t<T>, bool>;

/// The values of a map by index_of(m, v), if they are in an array: of a map of m, not of a mesh that may number its verts in another way, or of a property of m.
/// Those at the indices of deleted verts are meaningless.
template<class M, is_stored_number T>
const T* array_of_values(const M&, const element_map<M, vert_t<M>, T>& u) { return u.data(); }
template<ShowsProperties M, class Id, is_stored_number T>
const T* array_of_values(const M&, const property_map<Id, T>& u) { return &u[Id{0}]; }

/// Writes the states of n values. Returns whether one is NaN. Compilers make vector instructions of this loop.
template<class T>
bool write_level_states(const T* values, std::size_t n, double level, unsigned char* states) {
  bool has_nan = false;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(values[i]);
    states[i] = level_state(x, level);
    has_nan |= std::isnan(x);
  }
  return has_nan;
}

/// Writes the states of all verts, by index. Those of deleted verts are meaningless.
/// Errors: invalid_argument that names a vert whose value is NaN.
template<class M, class U>
void find_level_states(const M& m, const U& u, double level, const char* caller, unsigned char* all) {
  if constexpr (requires { array_of_values(m, u); }) {
    std::atomic<bool> may_have_nan = false;  // at a vert, or at the index of a deleted one
    core::run_chunks(
        vert_index_bound(m), 32768,
        [&](std::size_t first, std::size_t last) {
          if (write_level_states(array_of_values(m, u) + first, last - first, level, all + first)) may_have_nan.store(true, std::memory_order_relaxed);
        },
        {});
    if (!may_have_nan) return;
  }
  parallel_for_each(
      verts(m),
      [&m, &u, all, level, caller](const vert_t<M>& v) {
        const double x = static_cast<double>(u[v]);
        if (std::isnan(x)) [[unlikely]] throw_value_is_nan(caller, index_of(m, v));
        all[index_of(m, v)] = level_state(x, level);
      },
      8192);
}
template<class M, class U>
state_array level_states(const M& m, const U& u, double level, const char* caller) {
  state_array states(vert_index_bound(m));
  find_level_states(m, u, level, caller, states.data());
  return states;
}

/// The states of all verts of a list in memory, in fours: compilers make worse loops for the short lists of most polys.
template<class M>
[[gnu::noinline, gnu::pure]] unsigned char joint_states_of_list(const M& m, const unsigned char* states, const vert_t<M>* v, const vert_t<M>* end) {
  int joint = 0;
  const auto state = [&](std::ptrdiff_t k) { return states[index_of(m, v[k])]; };
  for (; end - v >= 4; v += 4) joint |= state(0) | state(1) | state(2) | state(3);
  for (; v != end; ++v) joint |= state(0);
  return static_cast<unsigned char>(joint);
}

/// The states of all verts of p. `states`: by index.
template<class M>
[[gnu::always_inline]] inline unsigned char joint_states(const M& m, const unsigned char* states, const poly_t<M>& p) {
  const auto all = adj_p2v(m, p);
  if constexpr (arity_v<M> == 0 && std::is_pointer_v<decltype(all.begin())>) {  // compilers unroll lists of fixed length
    const auto v = all.begin();
    const auto state = [&](std::ptrdiff_t k) { return states[index_of(m, v[k])]; };
    if (all.end() - v == 8) [[likely]]  // as of hexes: a loop takes longer
      return static_cast<unsigned char>(state(0) | state(1) | state(2) | state(3) | state(4) | state(5) | state(6) | state(7));
    return joint_states_of_list(m, states, v, all.end());
  } else {
    unsigned char joint = 0;
    for (const vert_t<M> v : all) joint |= states[index_of(m, v)];
    return joint;
  }
}

/// The states of all verts of each poly, by index of the poly.
template<class M>
state_array poly_states(const M& m, const state_array& states) {
  state_array of_polys(poly_index_bound(m));
  const unsigned char* const of_verts = states.data();
  unsigned char* const all = of_polys.data();
  parallel_for_each(
      polys(m),
      [&m, of_verts, all](const poly_t<M>& p) {
        all[index_of(m, p)] = joint_states(m, of_verts, p);
      },
      8192);
  return of_polys;
}

/// The polys that a level set crosses, by their states from poly_states, in the order of polys(m).
template<class M>
std::vector<poly_t<M>> crossed_by_state(const M& m, const state_array& states) {
  std::vector<poly_t<M>> crossed;
  for (const poly_t<M> p : polys(m))
    if (is_crossed(states[index_of(m, p)])) crossed.push_back(p);
  return crossed;
}

/// The polys with verts below the level set and others, in the order of polys(m).
template<class M>
std::vector<poly_t<M>> crossed_polys(const M& m, const unsigned char* states) {
  return core::collect_if<arity_v<M> == 0>(polys(m), [&m, states](const poly_t<M>& p) { return is_crossed(joint_states(m, states, p)); });
}
template<class M>
std::vector<poly_t<M>> crossed_polys(const M& m, const state_array& states) { return crossed_polys(m, states.data()); }

}  // namespace concino::detail
