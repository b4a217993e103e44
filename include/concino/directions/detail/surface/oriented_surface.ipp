// Bodies of oriented_surface.hpp: the orientation of polys, fans about verts, and their frames.
#pragma once

#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/geometry/corner_angles.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace concino::detail {

CONCINO_INLINE double oriented_surface::transport(std::uint32_t c) const {
  return back(c) + std::numbers::pi - from[c];
}

CONCINO_INLINE double oriented_surface::holonomy(std::size_t p) const {
  double sum = 0;
  for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) sum += angle[c];
  return sum - (static_cast<double>(first[p + 1] - first[p]) - 2) * std::numbers::pi;
}

CONCINO_INLINE vec3 oriented_surface::vector_area(std::size_t p) const {
  vec3 sum;
  const vec3 o = points[vert[first[p]]];
  for (std::uint32_t c = first[p] + 1; c + 1 < first[p + 1]; ++c)
    sum += cross(points[vert[c]] - o, points[vert[c + 1]] - o) / 2.0;
  return sum;
}

CONCINO_INLINE void oriented_surface::number_corners() {
  poly.resize(vert.size());
  next.resize(vert.size());
  previous.resize(vert.size());
  for (std::uint32_t p = 0; p < num_polys(); ++p)
    for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) {
      poly[c] = p;
      next[c] = c + 1 < first[p + 1] ? c + 1 : first[p];
      previous[next[c]] = c;
    }
}

/// Twins, whatever the orientations are.
CONCINO_INLINE void oriented_surface::pair_edges(const char* caller) {
  twin.assign(vert.size(), none);
  std::vector<std::uint32_t> one(num_edges, none);
  for (std::uint32_t c = 0; c < vert.size(); ++c) {
    std::uint32_t& other = one[edge[c]];
    if (other == none) {
      other = c;
      continue;
    }
    if (twin[other] != none)
      core::throw_joined<unsupported>({caller, ": edge ", edge[c],
                                       " has more than two polys, so that there is no tangent plane; remove polys "
                                       "there"});
    twin[other] = c;
    twin[c] = other;
  }
}

CONCINO_INLINE void oriented_surface::turn_poly(std::size_t p) {
  // corner j becomes corner k - j; its edge leads to the corner that was before
  const auto begin = static_cast<std::ptrdiff_t>(first[p]), end = static_cast<std::ptrdiff_t>(first[p + 1]);
  std::reverse(vert.begin() + begin + 1, vert.begin() + end);
  std::reverse(edge.begin() + begin, edge.begin() + end);
  is_turned[p] = 1;
}

CONCINO_INLINE void oriented_surface::orient(const char* caller) {
  std::vector<unsigned char> side(num_polys(), 2);  // 2: not visited; 1: to be turned
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t root = 0; root < num_polys(); ++root) {
    if (side[root] != 2) continue;
    side[root] = 0;
    waiting.push_back(root);
    while (!waiting.empty()) {
      const std::uint32_t p = waiting.back();
      waiting.pop_back();
      for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) {
        if (twin[c] == none) continue;
        const std::uint32_t q = poly[twin[c]];
        const bool is_along = vert[c] == vert[twin[c]];
        const auto wanted = static_cast<unsigned char>(side[p] ^ (is_along ? 1 : 0));
        if (side[q] == 2) {
          side[q] = wanted;
          waiting.push_back(q);
        } else if (side[q] != wanted) {
          core::throw_joined<unsupported>({caller, ": the surface is not orientable; a closed path through edge ",
                                           edge[c], " returns to its other side"});
        }
      }
    }
  }
  bool any = false;
  for (std::uint32_t p = 0; p < num_polys(); ++p)
    if (side[p] == 1) {
      turn_poly(p);
      any = true;
    }
  if (any) pair_edges(caller);
}

CONCINO_INLINE void oriented_surface::throw_no_area(std::size_t p, const char* caller) const {
  core::throw_joined<invalid_mesh>({caller, ": poly ", poly_index[p],
                                    " has no area, or points that are not finite; remove it or move its verts"});
}

CONCINO_INLINE void oriented_surface::scale(const char* caller) {
  double largest = 0;
  for (std::size_t c = 0; c < vert.size(); ++c) {
    const vec3& x = points[vert[c]];
    if (!is_finite(x)) throw_no_area(poly[c], caller);
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  exponent = largest > 0 ? std::ilogb(largest) : 0;
  const double half = std::ldexp(1.0, -(exponent / 2)), other_half = std::ldexp(1.0, exponent / 2 - exponent);
  for (vec3& x : points) x = other_half * (half * x);
}

CONCINO_INLINE void oriented_surface::label_components() {
  component.assign(num_verts(), none);
  std::vector<unsigned char> is_known(num_polys());
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t root = 0; root < num_polys(); ++root) {
    if (is_known[root]) continue;
    is_known[root] = 1;
    waiting.push_back(root);
    while (!waiting.empty()) {
      const std::uint32_t p = waiting.back();
      waiting.pop_back();
      for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) {
        component[vert[c]] = num_components;
        if (twin[c] == none || is_known[poly[twin[c]]]) continue;
        is_known[poly[twin[c]]] = 1;
        waiting.push_back(poly[twin[c]]);
      }
    }
    ++num_components;
  }
}

CONCINO_INLINE void oriented_surface::measure_angles(const char* caller) {
  angle.resize(vert.size());
  mass.assign(num_verts(), 0.0);
  for (std::size_t p = 0; p < num_polys(); ++p) {
    const vec3 area = vector_area(p);
    if (!(norm(area) > 0)) throw_no_area(p, caller);
    const std::uint32_t n = first[p + 1] - first[p];
    for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) {
      angle[c] = angle_at_corner(points[vert[previous[c]]], points[vert[c]], points[vert[next[c]]],
                                 n == 3 ? vec3{} : area);
      mass[vert[c]] += norm(area) / n;
    }
  }
}

CONCINO_INLINE void oriented_surface::walk_fans(const char* caller) {
  around.assign(num_verts(), none);
  on_boundary.assign(num_verts(), 0);
  from.assign(vert.size(), 0);
  std::vector<std::uint32_t> count(num_verts());
  for (std::uint32_t c = 0; c < vert.size(); ++c) {
    ++count[vert[c]];
    if (around[vert[c]] == none || twin[c] == none) around[vert[c]] = c;
    if (twin[c] == none) on_boundary[vert[c]] = 1;
  }
  for (std::uint32_t v = 0; v < num_verts(); ++v) {
    if (count[v] == 0) continue;
    double sum = 0, zero = 0;
    std::uint32_t c = around[v], visited = 0;
    do {
      from[c] = sum;
      if (edge[c] == first_edge[v]) zero = sum;
      sum += angle[c];
      if (edge[previous[c]] == first_edge[v] && twin[previous[c]] == none) zero = sum;
      ++visited;
      c = counter_clockwise(c);
    } while (c != none && c != around[v] && visited < count[v]);
    if (visited < count[v] || (c == none) != (on_boundary[v] != 0))
      core::throw_joined<unsupported>({caller, ": the polys at vert ", v,
                                       " are not one fan, so that it has no tangent plane; give each fan a vert of its "
                                       "own by split_vert_fans(m)"});
    if (!(sum > 0)) core::throw_joined<invalid_mesh>({caller, ": the polys at vert ", v, " have no angles there"});
    const double scale = on_boundary[v] ? 1 : 2 * std::numbers::pi / sum;
    c = around[v];
    for (std::uint32_t k = 0; k < visited; ++k, c = counter_clockwise(c)) {
      from[c] = scale * (from[c] - zero);
      angle[c] *= scale;
    }
  }
}

/// The normal is that of the areas around a vert. The axes are turned about it so that edges differ least from the
/// directions of their angles.
CONCINO_INLINE void oriented_surface::place_axes() {
  std::vector<vec3> normal(num_verts()), x(num_verts());
  for (std::size_t p = 0; p < num_polys(); ++p) {
    const vec3 area = vector_area(p);
    for (std::uint32_t c = first[p]; c < first[p + 1]; ++c) normal[vert[c]] += area;
  }
  const auto unit = [](const vec3& a) { return norm(a) > 0 ? a / norm(a) : vec3{}; };
  for (std::uint32_t c = 0; c < vert.size(); ++c)
    if (!(norm(normal[vert[c]]) > 0)) normal[vert[c]] = vector_area(poly[c]);
  for (vec3& n : normal) n = unit(n);
  const auto add = [&](std::uint32_t v, std::uint32_t to, double at) {
    const vec3 d = points[to] - points[v], n = normal[v], flat = unit(d - dot(d, n) * n);
    x[v] += std::cos(at) * flat - std::sin(at) * cross(n, flat);
  };
  for (std::uint32_t c = 0; c < vert.size(); ++c) {
    add(vert[c], vert[next[c]], from[c]);
    if (twin[previous[c]] == none) add(vert[c], vert[previous[c]], from[c] + angle[c]);
  }
  axes.assign(num_verts(), {});
  for (std::size_t v = 0; v < num_verts(); ++v) {
    if (component[v] == none) continue;
    if (!(norm(x[v]) > 1e-9)) {  // edges cancel; any direction in the plane
      const vec3 n = normal[v];
      x[v] = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    }
    x[v] = unit(x[v] - dot(x[v], normal[v]) * normal[v]);
    axes[v] = {x[v], cross(normal[v], x[v])};
  }
}

CONCINO_INLINE void oriented_surface::complete(const char* caller) {
  if (num_polys() == 0) core::throw_joined<invalid_mesh>({caller, ": the mesh has no polys"});
  if (edge.size() != vert.size())
    core::throw_joined<invalid_mesh>({caller, ": a poly has another number of edges than of verts"});
  is_turned.assign(num_polys(), 0);
  number_corners();
  scale(caller);
  pair_edges(caller);
  orient(caller);
  label_components();
  measure_angles(caller);
  walk_fans(caller);
  place_axes();
}

}  // namespace concino::detail
