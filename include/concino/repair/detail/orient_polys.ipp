// Bodies of surface_steps.hpp that orient polys.
#pragma once

#include <concino/geometry/bounding_tree.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/repair/detail/edge_lists.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace concino::detail {

/// Polys connected through edges of exactly two polys.
struct oriented_component {
  std::uint32_t first_poly = 0;
  std::size_t polys = 0, turned = 0;  // turned, for the winding of the first one
  bool is_one_sided = false, is_closed = true, is_turned_outward = false;
  vec3 low, high;
  double volume = 0;  // six times, of closed ones

  void add(const vec3& x) {
    for (const std::size_t k : {0u, 1u, 2u}) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  }
  bool has_box_around(const oriented_component& c) const {
    for (const std::size_t k : {0u, 1u, 2u})
      if (!(low[k] <= c.low[k] && c.high[k] <= high[k])) return false;
    return true;
  }
  /// Whether the volume is negative by more than rounding errors.
  bool is_inward() const {
    const vec3 size = high - low;
    return volume < -1e-15 * static_cast<double>(polys + 4) * size.x * size.y * size.z;
  }
};

class surface_orienter {
  surface_lists& s_;
  const edge_lists edges_;
  std::vector<std::uint32_t> opposite_;      // by corner: the other corner of an edge of exactly two
  std::vector<std::uint8_t> clashes_;        // by corner: whether the opposite one runs in the same direction
  std::vector<std::uint32_t> component_of_;  // by poly
  std::vector<std::uint8_t> turns_;          // by poly
  std::vector<oriented_component> components_;
  double scale_ = 1;

  bool runs_forward(std::uint32_t corner) const {
    const bool is_up = s_.verts[corner] < s_.verts[edges_.next(corner)];
    return is_up != (turns_[edges_.poly_of(corner)] != 0);
  }

  void find_opposites() {
    opposite_.assign(s_.verts.size(), surface_lists::none);
    clashes_.assign(s_.verts.size(), 0);
    for (std::size_t e = 0; e < edges_.num_edges(); ++e) {
      const auto at = edges_.corners(e);
      if (at.size() != 2) continue;
      opposite_[at[0]] = at[1], opposite_[at[1]] = at[0];
      clashes_[at[0]] = clashes_[at[1]] = s_.verts[at[0]] == s_.verts[at[1]];
    }
  }

  void flood(std::uint32_t start, std::vector<std::uint32_t>& stack) {
    const auto number = static_cast<std::uint32_t>(components_.size());
    oriented_component c;
    c.first_poly = start;
    component_of_[start] = number;
    stack.assign(1, start);
    while (!stack.empty()) {
      const std::uint32_t p = stack.back();
      stack.pop_back();
      ++c.polys;
      c.turned += turns_[p];
      for (std::uint32_t corner = s_.offsets[p]; corner < s_.offsets[p + 1]; ++corner) {
        if (opposite_[corner] == surface_lists::none) continue;
        const std::uint32_t q = edges_.poly_of(opposite_[corner]);
        const auto wanted = static_cast<std::uint8_t>(turns_[p] ^ clashes_[corner]);
        if (component_of_[q] == surface_lists::none) {
          component_of_[q] = number;
          turns_[q] = wanted;
          stack.push_back(q);
        } else if (turns_[q] != wanted) {
          c.is_one_sided = true;
        }
      }
    }
    components_.push_back(c);
  }

  /// One that is one-sided stays as it is; the others are wound like most of their polys.
  void choose_windings() {
    for (std::size_t p = 0; p < turns_.size(); ++p) {
      const oriented_component& c = components_[component_of_[p]];
      if (c.is_one_sided) turns_[p] = 0;
      else if (2 * c.turned > c.polys) turns_[p] ^= 1;
    }
  }

  /// A component is closed if it passes each edge as often in one direction as in the other.
  void find_closed() {
    for (oriented_component& c : components_) c.is_closed = !c.is_one_sided;
    for (std::size_t e = 0; e < edges_.num_edges(); ++e) {
      const auto at = edges_.corners(e);
      if (at.size() == 2) continue;  // they run in opposite directions, unless the component is one-sided
      for (const std::uint32_t corner : at) {
        const std::uint32_t number = component_of_[edges_.poly_of(corner)];
        int sum = 0;
        for (const std::uint32_t other : at)
          if (component_of_[edges_.poly_of(other)] == number) sum += runs_forward(other) ? 1 : -1;
        components_[number].is_closed = components_[number].is_closed && sum == 0;
      }
    }
  }

  /// Scaled by a power of two, so that volumes neither overflow nor underflow.
  vec3 scaled(std::uint32_t v) const { return scale_ * s_.points[v]; }
  void find_scale() {
    double largest = 0;
    for (const vec3& x : s_.points)
      if (is_finite(x)) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    if (largest > 0) scale_ = std::ldexp(1, -std::clamp(std::ilogb(largest), -1000, 1000));
  }

  void measure() {
    find_scale();
    for (oriented_component& c : components_) c.low = c.high = scaled(s_.poly(c.first_poly)[0]);
    for (std::size_t p = 0; p < s_.num_polys(); ++p) {
      oriented_component& c = components_[component_of_[p]];
      if (!c.is_closed) continue;
      const auto list = s_.poly(p);
      for (const std::uint32_t v : list) {
        c.add(scaled(v));
        c.is_closed = c.is_closed && is_finite(s_.points[v]);
      }
      const double part = six_times_volume_under(
          list.size(), [&](std::size_t i) { return scaled(list[i]); }, scaled(s_.poly(c.first_poly)[0]));
      c.volume += turns_[p] ? -part : part;
    }
  }

  polygonmesh mesh_of(std::uint32_t component) const {
    surface_arrays a;
    a.points = s_.points;
    a.offsets.push_back(0);
    for (std::size_t p = 0; p < s_.num_polys(); ++p) {
      if (component_of_[p] != component) continue;
      for (const std::uint32_t v : s_.poly(p)) a.verts.push_back(vert_id{v});
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
    }
    return polygonmesh(std::move(a));
  }

  /// Closed components of negative volume become outward, unless they bound cavities: those inside an odd number of
  /// others.
  void turn_outward() {
    struct solid {
      polygonmesh mesh;
      poly_tree<polygonmesh> tree;
      explicit solid(polygonmesh m) : mesh(std::move(m)), tree(mesh) {}
    };
    std::vector<std::unique_ptr<solid>> solids(components_.size());
    std::vector<std::uint32_t> by_size;  // closed components, those with the largest boxes first
    for (std::uint32_t i = 0; i < components_.size(); ++i)
      if (components_[i].is_closed) by_size.push_back(i);
    const auto width = [&](std::uint32_t i) { return norm(components_[i].high - components_[i].low); };
    std::stable_sort(by_size.begin(), by_size.end(), [&](auto a, auto b) { return width(a) > width(b); });
    for (std::size_t k = 0; k < by_size.size(); ++k) {
      oriented_component& c = components_[by_size[k]];
      if (!c.is_inward()) continue;
      const vec3 x = s_.points[s_.poly(c.first_poly)[0]];
      bool is_cavity = false;
      for (std::size_t j = 0; j < k; ++j) {
        if (!components_[by_size[j]].has_box_around(c)) continue;
        std::unique_ptr<solid>& around = solids[by_size[j]];
        if (!around) around = std::make_unique<solid>(mesh_of(by_size[j]));
        is_cavity = is_cavity != around->tree.is_inside(x);
      }
      c.is_turned_outward = !is_cavity;
    }
  }

 public:
  explicit surface_orienter(surface_lists& s)
      : s_(s), edges_(s.offsets, s.verts, s.points.size()), component_of_(s.num_polys(), surface_lists::none),
        turns_(s.num_polys()) {}

  void orient(repair_log& log) {
    find_opposites();
    std::vector<std::uint32_t> stack;
    for (std::uint32_t p = 0; p < s_.num_polys(); ++p)
      if (component_of_[p] == surface_lists::none) flood(p, stack);
    choose_windings();
    find_closed();
    measure();
    turn_outward();
    for (std::size_t p = 0; p < turns_.size(); ++p) {
      turns_[p] ^= components_[component_of_[p]].is_turned_outward;
      if (!turns_[p]) continue;
      const auto list = s_.poly(p);
      std::reverse(list.begin() + 1, list.end());  // the first corner stays the first
      s_.is_turned[p] ^= 1;
    }
    log.of(repair_kind::one_sided).clear();
    for (const oriented_component& c : components_)
      if (c.is_one_sided) log.add(repair_kind::one_sided, s_.poly_origin[c.first_poly]);
  }
};

CONCINO_INLINE void orient_polys(surface_lists& s, repair_log& log) { surface_orienter(s).orient(log); }

}  // namespace concino::detail
