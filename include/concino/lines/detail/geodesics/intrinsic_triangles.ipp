// Bodies of intrinsic_triangles.hpp: triangles that are known by the lengths of their edges, so that edges can be
// flipped without changing the surface.
#pragma once

#include <concino/core/error.hpp>
#include <concino/lines/detail/geodesics/intrinsic_triangles.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// For each triangle whether it is reversed, so that all have the same orientation.
inline std::vector<signed char> consistent_reversals(const core::unfolded_triangles& t, const char* caller) {
  std::vector<signed char> reversed(t.vert.size() / 3, -1);
  std::vector<int> waiting;
  for (std::size_t first = 0; first < reversed.size(); ++first) {
    if (reversed[first] >= 0) continue;
    reversed[first] = 0;
    waiting.assign(1, static_cast<int>(first));
    while (!waiting.empty()) {
      const int triangle = waiting.back();
      waiting.pop_back();
      for (int s = 3 * triangle; s < 3 * triangle + 3; ++s) {
        const int other = t.twin[static_cast<std::size_t>(s)];
        if (other == s) continue;
        signed char& known = reversed[static_cast<std::size_t>(other / 3)];
        const bool same = t.start(other) == t.end(s);
        const auto wanted = static_cast<signed char>(same ? reversed[static_cast<std::size_t>(triangle)]
                                                          : !reversed[static_cast<std::size_t>(triangle)]);
        if (known >= 0 && known != wanted)
          core::throw_joined<unsupported>({caller, ": the surface is not orientable at vert ",
                                           static_cast<std::size_t>(t.start(s)), "; cut it open first"});
        if (known >= 0) continue;
        known = wanted;
        waiting.push_back(other / 3);
      }
    }
  }
  return reversed;
}

CONCINO_INLINE intrinsic_triangles::intrinsic_triangles(const core::unfolded_triangles& t, const char* caller)
    : length(t.length), sense(t.around.size(), 1), first_at(t.around.size(), -1) {
  for (std::size_t v = 0; v < t.around.size(); ++v)
    if (t.first_corner[v] < t.first_corner[v + 1] && t.around[v] == core::unfolded_triangles::vert_fan::other)
      core::throw_joined<unsupported>(
          {caller, ": the polys at vert ", v,
           " are not one fan; give each fan a vert of its own by split_vert_fans(m), and remove "
           "polys at edges with more than two"});
  const std::vector<signed char> reversed = consistent_reversals(t, caller);
  const int n = static_cast<int>(t.vert.size());
  for (auto* list : {&start, &next, &twin}) list->reserve(t.vert.size());
  fan_angle.reserve(t.vert.size());
  // Half-edge s is side s of the triangles, from its end if the triangle is reversed.
  for (int s = 0; s < n; ++s) {
    const bool back = reversed[at(s / 3)] != 0;
    const int far = core::unfolded_triangles::next(s);
    start.push_back(back ? t.end(s) : t.start(s));
    next.push_back(back ? core::unfolded_triangles::previous(s) : far);
    twin.push_back(t.twin[at(s)]);
    fan_angle.push_back(back ? t.fan_angle(far, t.angle[at(far)]) : t.fan_angle(s, 0));
    const int corner = back ? far : s;
    sense[at(start.back())] = (t.is_backward[at(corner)] != 0) == back ? 1 : -1;
    first_at[at(start.back())] = s;
  }
  for (int s = 0; s < n; ++s) {
    if (twin[at(s)] != s) continue;
    const int ghost = static_cast<int>(start.size()), after = next[at(s)];
    start.push_back(start[at(after)]);
    next.push_back(-1);
    twin.push_back(s);
    twin[at(s)] = ghost;
    length.push_back(length[at(s)]);
    fan_angle.push_back(fan_angle[at(after)] + sense[at(start[at(after)])] * corner_angle(after));
  }
}

CONCINO_INLINE double intrinsic_triangles::corner_angle(int h) const {
  const double a = length[at(h)], b = length[at(previous(h))], c = length[at(next[at(h)])], s = (a + b + c) / 2;
  return 2 * std::atan2(std::sqrt(std::max((s - a) * (s - b), 0.0)), std::sqrt(std::max(s * (s - c), 0.0)));
}

CONCINO_INLINE void intrinsic_triangles::flip(int h) {
  const int g = twin[at(h)], h_next = next[at(h)], h_previous = previous(h), g_next = next[at(g)],
            g_previous = previous(g);
  const int a = start[at(h)], b = start[at(g)], c = start[at(h_previous)], d = start[at(g_previous)];
  const double to_c = length[at(h_previous)], to_d = length[at(g_next)],
               sine = std::sin((corner_angle(h) + corner_angle(g_next)) / 2);
  const double flipped = std::sqrt((to_c - to_d) * (to_c - to_d) + 4 * to_c * to_d * sine * sine);
  if (first_at[at(a)] == h) first_at[at(a)] = g_next;
  if (first_at[at(b)] == g) first_at[at(b)] = h_next;
  start[at(h)] = d;
  start[at(g)] = c;
  length[at(h)] = length[at(g)] = flipped;
  next[at(h)] = h_previous;
  next[at(h_previous)] = g_next;
  next[at(g_next)] = h;
  next[at(g)] = g_previous;
  next[at(g_previous)] = h_next;
  next[at(h_next)] = g;
  fan_angle[at(h)] = fan_angle[at(g_previous)] + sense[at(d)] * corner_angle(g_previous);
  fan_angle[at(g)] = fan_angle[at(h_previous)] + sense[at(c)] * corner_angle(h_previous);
}

}  // namespace concino::detail
