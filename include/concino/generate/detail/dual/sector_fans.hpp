// The polys around verts of a surface or around edges of a volume, in cyclic order.
#pragma once

#include <concino/core/flat_array.hpp>

#include <cassert>
#include <span>

namespace concino::detail {

/// The part of a poly at a centre: a vert of a surface or an edge of a volume. Counter-clockwise around the centre, the
/// sector begins at facet `in` and ends at facet `out`. Around an edge, counter-clockwise is as seen from its second
/// end, looking at the first.
struct sector {
  static constexpr std::uint32_t none = ~0u;
  std::uint32_t poly, in, out;
};

enum class fan_kind { closed, open, broken };

/// The sectors of all centres. They are stored in two passes: first count them, then add them poly by poly.
class sector_fans {
  std::vector<std::uint32_t> first_, end_;  // by centre
  core::flat_array<sector> sectors_;

 public:
  explicit sector_fans(std::size_t centres) : first_(centres + 1) {}

  void count(std::size_t centre) { ++first_[centre + 1]; }
  void end_counting() {
    for (std::size_t h = 1; h < first_.size(); ++h) first_[h] += first_[h - 1];
    end_.assign(first_.begin(), first_.end() - 1);
    sectors_.resize(first_.back());
  }
  /// The sector of a poly, added by the first call. All calls for one centre and one poly must precede those for
  /// another poly.
  sector& at(std::size_t centre, std::uint32_t poly) {
    std::uint32_t& end = end_[centre];
    if (end > first_[centre] && sectors_[end - 1].poly == poly) return sectors_[end - 1];
    assert(end < first_[centre + 1]);
    return sectors_[end++] = {poly, sector::none, sector::none};
  }

  std::size_t size() const { return sectors_.size(); }
  std::span<sector> operator[](std::size_t centre) {
    return {sectors_.data() + first_[centre], sectors_.data() + end_[centre]};
  }

  /// Sorts the sectors of a centre in cyclic order, from boundary to boundary if the fan is open. If a poly is oriented
  /// against the previous one, its sector is reversed. Quadratic in the number of sectors.
  template<class IsBorder>
  fan_kind arrange(std::size_t centre, const IsBorder& is_border) {
    const std::span<sector> fan = (*this)[centre];
    if (fan.empty()) return fan_kind::broken;
    auto start = std::find_if(fan.begin(), fan.end(), [&](const sector& w) { return is_border(w.in); });
    if (start == fan.end()) {
      start = std::find_if(fan.begin(), fan.end(), [&](const sector& w) { return is_border(w.out); });
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
