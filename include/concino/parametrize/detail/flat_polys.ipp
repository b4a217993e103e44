// Bodies of flat_polys.hpp: the polys of a surface as flat arrays, and those of a disk with its boundary loop.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/lexicographic.hpp>
#include <concino/parametrize/detail/flat_polys.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace concino::detail {

/// The corners of a surface, joined at its edges.
class disk_topology {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  struct use {
    std::uint32_t low, high, poly, corner;  // the corner where the edge begins
    bool is_forward;                        // from low to high
  };
  flat_disk& f_;
  const char* caller_;
  std::vector<use> uses_;
  std::vector<std::uint32_t> next_, twin_;  // by corner; twin: the use on the other side of the edge

  std::uint32_t vert(std::uint32_t v) const { return f_.vert_index[v]; }
  std::uint32_t poly(std::uint32_t p) const { return f_.poly_index[p]; }

  void list_edges() {
    next_.resize(f_.corners.size());
    uses_.reserve(f_.corners.size());
    for (std::uint32_t p = 0; p < f_.num_polys(); ++p)
      for (std::uint32_t c = f_.first[p]; c < f_.first[p + 1]; ++c) {
        next_[c] = c + 1 < f_.first[p + 1] ? c + 1 : f_.first[p];
        const std::uint32_t a = f_.corners[c], b = f_.corners[next_[c]];
        if (a == b) core::throw_joined<invalid_mesh>({caller_, ": poly ", poly(p), " has vert ", vert(a), " twice"});
        uses_.push_back({std::min(a, b), std::max(a, b), p, c, a < b});
      }
    std::sort(uses_.begin(), uses_.end(), [](const use& x, const use& y) {
      return std::array{x.low, x.high, x.corner} < std::array{y.low, y.high, y.corner};
    });
    twin_.assign(f_.corners.size(), none);
    for (std::size_t i = 0; i < uses_.size();) {
      std::size_t end = i + 1;
      while (end < uses_.size() && uses_[end].low == uses_[i].low && uses_[end].high == uses_[i].high) ++end;
      if (end - i > 2)
        core::throw_joined<invalid_mesh>({caller_, ": the edge of verts ", vert(uses_[i].low), " and ",
                                          vert(uses_[i].high), " has ", end - i,
                                          " polys, a disk has two at most; cut the surface open with cut_along"});
      if (end - i == 2) {
        twin_[uses_[i].corner] = static_cast<std::uint32_t>(i + 1);
        twin_[uses_[i + 1].corner] = static_cast<std::uint32_t>(i);
      }
      f_.edges.push_back({uses_[i].low, uses_[i].high});
      i = end;
    }
  }

  // Walks over all polys, and says which are wound against the first.
  void check_winding() {
    std::vector<signed char> turned(f_.num_polys(), -1);
    std::vector<std::uint32_t> waiting;
    std::size_t components = 0;
    std::uint32_t against = none;
    for (std::uint32_t p = 0; p < f_.num_polys(); ++p) {
      if (turned[p] >= 0) continue;
      ++components;
      turned[p] = 0;
      waiting.push_back(p);
      while (!waiting.empty()) {
        const std::uint32_t x = waiting.back();
        waiting.pop_back();
        for (std::uint32_t c = f_.first[x]; c < f_.first[x + 1]; ++c) {
          if (twin_[c] == none) continue;
          const use& other = uses_[twin_[c]];
          const bool same = other.is_forward == (f_.corners[c] < f_.corners[next_[c]]);
          const auto is_turned = static_cast<signed char>(same ? 1 - turned[x] : turned[x]);
          if (turned[other.poly] < 0) {
            turned[other.poly] = is_turned;
            waiting.push_back(other.poly);
          } else if (turned[other.poly] != is_turned) {
            core::throw_joined<invalid_mesh>({caller_,
                                              ": the surface cannot be oriented, like a Moebius strip: see poly ",
                                              poly(other.poly), "; cut it open with cut_along"});
          }
          if (same && against == none) against = other.poly;
        }
      }
    }
    if (components > 1)
      core::throw_joined<invalid_mesh>({caller_, ": the surface has ", components,
                                        " components of polys that share edges; map each one, see submesh and "
                                        "connected_components(dual(m))"});
    if (against != none)
      core::throw_joined<invalid_mesh>({caller_, ": poly ", poly(against),
                                        " is wound against a neighbour; orient the surface with repair(m, {.orient = "
                                        "true})"});
  }

  // The polys at each vert are one fan, so that boundary edges form loops.
  void check_fans() const {
    std::vector<std::uint32_t> root(f_.corners.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto root_of = [&](std::uint32_t c) {
      while (root[c] != c) c = root[c] = root[root[c]];
      return c;
    };
    for (std::uint32_t c = 0; c < f_.corners.size(); ++c)
      if (twin_[c] != none) root[root_of(c)] = root_of(next_[uses_[twin_[c]].corner]);
    std::vector<std::uint32_t> fan(f_.points.size(), none);
    for (std::uint32_t c = 0; c < f_.corners.size(); ++c) {
      std::uint32_t& known = fan[f_.corners[c]];
      if (known == none) known = root_of(c);
      if (known != root_of(c))
        core::throw_joined<invalid_mesh>({caller_, ": the polys at vert ", vert(f_.corners[c]),
                                          " form several fans; split them with repair(m, {.split_non_manifold = "
                                          "true})"});
    }
  }

  void find_loop() {
    std::vector<std::uint32_t> after(f_.points.size(), none);
    std::size_t count = 0;
    std::uint32_t start = none;
    for (std::uint32_t c = 0; c < f_.corners.size(); ++c) {
      if (twin_[c] != none) continue;
      after[f_.corners[c]] = f_.corners[next_[c]];
      start = std::min(start, f_.corners[c]);
      ++count;
    }
    if (count == 0)
      core::throw_joined<invalid_mesh>({caller_, ": the surface is closed, and has no boundary; cut it open along "
                                                 "edges with cut_along"});
    std::size_t loops = 1;
    for (std::uint32_t v = start; f_.loop.empty() || v != start; v = after[v]) f_.loop.push_back(v);
    std::vector<std::uint32_t> of_first = f_.loop;
    for (const std::uint32_t v : f_.loop) after[v] = none;
    std::uint32_t in_second = none;
    for (std::uint32_t v = 0; v < after.size(); ++v) {
      if (after[v] == none) continue;
      if (in_second == none) in_second = v;
      ++loops;
      for (std::uint32_t w = v; after[w] != none;) w = std::exchange(after[w], none);
    }
    if (loops > 1)
      core::throw_joined<invalid_mesh>({caller_, ": the surface has ", loops, " boundary loops, at verts ", vert(start),
                                        " and ", vert(in_second),
                                        " among others; join them with cut_along and a shortest_path between them"});
    const auto chi = static_cast<long long>(f_.points.size() + f_.num_polys()) -
                     static_cast<long long>(f_.edges.size());
    if (chi != 1)
      core::throw_joined<invalid_mesh>({caller_, ": the surface has ", (1 - chi) / 2,
                                        " handles; cut it open with cut_along(m, homology_generators(m))"});
  }

 public:
  disk_topology(flat_disk& f, const char* caller) : f_(f), caller_(caller) {
    list_edges();
    check_winding();
    check_fans();
    find_loop();
    for (const std::uint32_t t : twin_) f_.other_poly.push_back(t == none ? flat_disk::no_poly : uses_[t].poly);
  }
};

CONCINO_INLINE void scale_polys(flat_polys& f, const char* caller) {
  if (f.num_polys() == 0) core::throw_joined<invalid_mesh>({caller, ": the surface has no polys"});
  double largest = 0;
  for (std::size_t v = 0; v < f.points.size(); ++v) {
    const vec3& x = f.points[v];
    if (!is_finite(x))
      core::throw_joined<invalid_mesh>({caller, ": vert ", f.vert_index[v], " has a coordinate that is not finite"});
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  // Twice, because the size of a surface may be infinite, or much smaller than its distance from the origin.
  for (int round = 0; round < 2; ++round) {
    if (round == 1) {
      vec3 low = f.points[0], high = low;
      for (const vec3& x : f.points)
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], x[k]);
          high[k] = std::max(high[k], x[k]);
        }
      largest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    }
    if (!(largest > 0)) return;
    const int e = std::ilogb(largest);
    for (vec3& x : f.points) x = {std::ldexp(x.x, -e), std::ldexp(x.y, -e), std::ldexp(x.z, -e)};
    f.exponent += e;
  }
}

CONCINO_INLINE void make_disk(flat_disk& f, const char* caller) {
  scale_polys(f, caller);
  disk_topology(f, caller);
}

CONCINO_INLINE std::size_t farthest_in_loop(const flat_disk& f) {
  vec3 sum;
  double length = 0;
  for (std::size_t i = 0; i < f.loop.size(); ++i) {
    const vec3 &a = f.points[f.loop[i]], &b = f.points[f.loop[(i + 1) % f.loop.size()]];
    sum += distance(a, b) * (a + b) / 2;
    length += distance(a, b);
  }
  if (!(length > 0)) return 0;
  const vec3 centre = sum / length;
  std::size_t best = 0;
  for (std::size_t i = 1; i < f.loop.size(); ++i) {
    const vec3 &a = f.points[f.loop[best]], &b = f.points[f.loop[i]];
    const double x = distance(a, centre), y = distance(b, centre);
    constexpr double rounding = 1e-12;  // of equal distances the first point decides, whatever the numbers of verts
    if (y > x * (1 + rounding) || (y >= x * (1 - rounding) && core::is_lexicographically_less(b, a))) best = i;
  }
  return best;
}

}  // namespace concino::detail
