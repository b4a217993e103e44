// Defines planar_segments_of of planar_segments.hpp.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/generate/planar_segments.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Fills a planar_segments, step by step.
class planar_segment_reader {
  static constexpr std::uint32_t none = core::planar_segments::none;

  const planar_graph& g_;
  core::planar_segments result_;
  std::vector<std::uint32_t> repeats_;  // by the number of a point that ends an outline: the first point, which it
                                        // repeats; else none

  void require(bool good, core::message what) const {
    if (!good) core::throw_joined<invalid_argument>({result_.caller, ": ", core::joined(what)});
  }

  void use(std::uint32_t p, core::message where) {
    require(p < g_.points.size(), {core::joined(where), " names point ", p, ", but there are ", g_.points.size()});
    require(is_finite(g_.points[p]), {"point ", p, " is not finite"});
    result_.same_as[p] = p;
  }

 public:
  planar_segment_reader(std::string_view caller, const planar_graph& g) : g_(g) { result_.caller = caller; }

  void check_lines() {
    require(g_.points.size() < (1u << 30) && g_.line_points.size() < (1u << 30), {"there are 2^30 points or more"});
    require(g_.line_closed.size() == g_.num_lines(),
            {"line_closed has ", g_.line_closed.size(), " entries for ", g_.num_lines(), " lines"});
    result_.same_as.assign(g_.points.size(), none);
    repeats_.assign(g_.points.size(), none);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < g_.num_lines(); ++i) {
      const std::size_t end = g_.line_ends[i], needed = g_.line_closed[i] ? 3 : 2;
      require(begin <= end && end <= g_.line_points.size(),
              {"line_ends[", i, "] is ", end, "; it must not be below the one before, and there are ",
               g_.line_points.size(), " line_points"});
      const bool repeats = g_.repeats_first_point(i);
      const std::size_t n = end - begin - repeats;
      require(n >= needed, {"line ", i, ": ", g_.line_closed[i] ? "an outline" : "an open line", " needs ", needed,
                            " points, but has ", n});
      for (std::size_t k = begin; k < end; ++k) use(g_.line_points[k], {"line ", i});
      if (repeats) repeats_[g_.line_points[end - 1]] = g_.line_points[begin];
      begin = end;
    }
    for (std::size_t i = 0; i < g_.isolated.size(); ++i) use(g_.isolated[i], {"isolated[", i, "]"});
  }

  /// Projects along n to axes that are counter-clockwise seen against n; without rounding if n is parallel to an axis.
  void project(std::span<const vec3> holes, const vec3& n) {
    require(is_finite(n) && norm(n) > 0, {"seen_from must be finite and not 0"});
    std::size_t k = 0;
    for (const std::size_t i : {1u, 2u})
      if (std::abs(n[i]) >= std::abs(n[k])) k = i;
    vec3 next;
    next[(k + 1) % 3] = 1;
    const vec3 unit = n / norm(n), up = cross(unit, next);
    result_.axes[1] = up / norm(up);
    result_.axes[0] = cross(result_.axes[1], unit);
    double size = 0;
    const auto put = [&](const vec3& p) {
      const vec3 q{dot(p, result_.axes[0]), dot(p, result_.axes[1]), 0};
      size = std::max({size, std::abs(q.x), std::abs(q.y)});
      return q;
    };
    result_.points.resize(g_.points.size());
    for (std::size_t p = 0; p < g_.points.size(); ++p)
      if (result_.same_as[p] != none) result_.points[p] = put(g_.points[p]);
    for (std::size_t h = 0; h < holes.size(); ++h) {
      require(is_finite(holes[h]), {"hole point ", h, " is not finite"});
      result_.holes.push_back(put(holes[h]));
    }
    require(std::isfinite(size), {"coordinates are too large to be projected"});
    result_.exponent = size > 0 ? -std::ilogb(size) - 1 : 0;
    for (auto* list : {&result_.points, &result_.holes})
      for (vec3& q : *list) q = {std::ldexp(q.x, result_.exponent), std::ldexp(q.y, result_.exponent), 0};
  }

  void merge_points(bool merge) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < g_.points.size(); ++p)
      if (result_.same_as[p] != none) order.push_back(p);
    const auto& x = result_.points;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return result_.is_before(a, b) || (x[a] == x[b] && a < b); });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (!(x[order[i]] == x[order[i - 1]])) continue;
      const std::uint32_t a = order[i - 1], b = order[i];
      require(merge || repeats_[a] == b || repeats_[b] == a,
              {"points ", a, " and ", b, " are at the same place; options.merge_points makes one vert of them"});
      result_.same_as[b] = result_.same_as[a];
    }
    for (std::uint32_t p = 0; p < g_.points.size(); ++p)
      if (result_.same_as[p] == p) result_.used.push_back(p);
  }

  void read_segments() {
    struct entry {
      std::array<std::uint32_t, 2> ends;
      std::uint32_t input;
      std::uint8_t is_outline;
    };
    std::vector<entry> list;
    list.reserve(g_.line_points.size());
    for (std::size_t i = 0; i < g_.num_lines(); ++i) {
      const auto line = g_.line(i);
      const std::size_t num_segments = line.size() - (!g_.line_closed[i] || g_.repeats_first_point(i));
      for (std::size_t from = 0; from < num_segments; ++from) {
        const std::size_t to = (from + 1) % line.size();
        std::uint32_t a = result_.same_as[line[from]], b = result_.same_as[line[to]];
        const auto number = static_cast<std::uint32_t>(list.size());
        require(a != b, {"segment ", number, " (points ", line[from], " and ", line[to], ") has no length"});
        if (result_.is_before(b, a)) std::swap(a, b);
        list.push_back({{a, b}, number, g_.line_closed[i]});
      }
    }
    result_.segment_of.resize(list.size());
    std::sort(list.begin(), list.end(), [](const entry& s, const entry& t) {
      return s.ends < t.ends || (s.ends == t.ends && s.input < t.input);
    });
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i == 0 || list[i].ends != list[i - 1].ends) {
        result_.segments.push_back(list[i].ends);
        result_.is_outline.push_back(0);
        result_.first_input.push_back(list[i].input);
      }
      result_.is_outline.back() ^= list[i].is_outline != 0;
      result_.segment_of[list[i].input] = static_cast<std::uint32_t>(result_.segments.size() - 1);
    }
  }

  core::planar_segments& result() { return result_; }
};

}  // namespace concino::detail

namespace concino::core {

CONCINO_INLINE planar_segments planar_segments_of(std::string_view caller, const planar_graph& g,
                                                  std::span<const vec3> holes, const vec3& seen_from, bool merge) {
  detail::planar_segment_reader reader(caller, g);
  reader.check_lines();
  reader.project(holes, seen_from);
  reader.merge_points(merge);
  reader.read_segments();
  return std::move(reader.result());
}

CONCINO_INLINE std::vector<edge_id> edges_between(const trimesh& m, std::span<const std::array<vert_id, 2>> pairs) {
  struct entry {
    std::array<std::uint32_t, 2> verts;
    edge_id edge;
    bool operator<(const entry& o) const { return verts < o.verts; }
  };
  const auto sorted = [](vert_id u, vert_id v) {
    return std::array<std::uint32_t, 2>{std::min(u.raw(), v.raw()), std::max(u.raw(), v.raw())};
  };
  std::vector<entry> entries;
  entries.reserve(num_edges(m));
  for (const edge_id e : edges(m)) {
    const auto [u, v] = end_verts(m, e);
    entries.push_back({sorted(u, v), e});
  }
  std::sort(entries.begin(), entries.end());
  std::vector<edge_id> result;
  result.reserve(pairs.size());
  for (const auto& [u, v] : pairs) {
    const entry wanted{sorted(u, v), {}};
    const auto at = std::lower_bound(entries.begin(), entries.end(), wanted);
    result.push_back(at != entries.end() && at->verts == wanted.verts ? at->edge : edge_id{});
  }
  return result;
}

}  // namespace concino::core
