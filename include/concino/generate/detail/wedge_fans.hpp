// The polys around verts of a surface or around edges of a volume, in cyclic order.
#pragma once

#include <concino/core/flat_array.hpp>

#include <cassert>
#include <span>

namespace concino::detail {

/// A poly as seen from its hub, a vert of a surface or an edge of a volume. Turning counter-clockwise one enters it through facet `in` and
/// leaves it through `out`: edges of a surface, faces of a volume. Around an edge one turns as seen from its second end, looking at the first.
struct wedge {
  static constexpr std::uint32_t none = ~0u;
  std::uint32_t poly, in, out;
};

enum class fan_kind { closed, open, broken };

/// The wedges of all hubs, in two steps: count them, then add them poly after poly.
class wedge_fans {
  std::vector<std::uint32_t> first_, end_;  // by hub
  core::flat_array<wedge> wedges_;

 public:
  explicit wedge_fans(std::size_t hubs) : first_(hubs + 1) {}

  void count(std::size_t hub) { ++first_[hub + 1]; }
  void end_counting() {
    for (std::size_t h = 1; h < first_.size(); ++h) first_[h] += first_[h - 1];
    end_.assign(first_.begin(), first_.end() - 1);
    wedges_.resize(first_.back());
  }
  /// The wedge of a poly, made at the first call; between the calls for one hub and poly there is none for another poly.
  wedge& at(std::size_t hub, std::uint32_t poly) {
    std::uint32_t& end = end_[hub];
    if (end > first_[hub] && wedges_[end - 1].poly == poly) return wedges_[end - 1];
    assert(end < first_[hub + 1]);
    return wedges_[end++] = {poly, wedge::none, wedge::none};
  }

  std::size_t size() const { return wedges_.size(); }
  std::span<wedge> operator[](std::size_t hub) { return {wedges_.data() + first_[hub], wedges_.data() + end_[hub]}; }

  /// Brings the wedges of a hub into their order, from border to border where the fan is open. A poly that is wound against the one before
  /// it is turned. Quadratic in the number of wedges.
  template<class IsBorder>
  fan_kind arrange(std::size_t hub, const IsBorder& is_border) {
    const std::span<wedge> fan = (*this)[hub];
    if (fan.empty()) return fan_kind::broken;
    auto start = std::find_if(fan.begin(), fan.end(), [&](const wedge& w) { return is_border(w.in); });
    if (start == fan.end()) {
      start = std::find_if(fan.begin(), fan.end(), [&](const wedge& w) { return is_border(w.out); });
      if (start != fan.end()) std::swap(start->in, start->out);
    }
    const bool open = start != fan.end();
    if (open) std::swap(*start, fan[0]);
    for (std::size_t k = 0; k + 1 < fan.size(); ++k) {
      const std::uint32_t through = fan[k].out;
      std::size_t next = k + 1;
      while (next < fan.size() && fan[next].in != through && fan[next].out != through) ++next;
      if (next == fan.size()) return fan_kind::broken;
      std::swap(fan[k + 1], fan[next]);
      if (fan[k + 1].in != through) std::swap(fan[k + 1].in, fan[k + 1].out);
    }
    if (open) return is_border(fan.back().out) ? fan_kind::open : fan_kind::broken;
    return fan.back().out == fan[0].in ? fan_kind::closed : fan_kind::broken;
  }
};

}  // namespace concino::detail
