// Removes parts of cells that have no inside; see remove_flat_parts.hpp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/remove_flat_parts.hpp>

#include <algorithm>

namespace concino::detail {

class flat_part_finder {
  cell_cuts& cuts_;
  place_numbers numbers_;
  std::vector<std::uint32_t> loops_, places_, ends_;  // loops that cut, and their places, one after another
  std::vector<std::uint32_t> loops_at_region_;        // by region: how many of its loops cut
  std::vector<std::uint32_t> verts_;                  // of the regions that were changed

  std::uint32_t begin(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1]; }
  /// The corner on one side of the first chord of a loop.
  std::uint32_t corner(std::uint32_t loop, bool above) const {
    const cell_cuts::chord& c = cuts_.chords()[cuts_.loop_chords()[cuts_.loops()[loop].first]];
    return above ? c.from : c.to;
  }

  void list_loops() {
    loops_at_region_.assign(cuts_.num_cell_verts(), 0);
    for (std::uint32_t i = 0; i < cuts_.loops().size(); ++i) {
      const cell_cuts::loop& l = cuts_.loops()[i];
      if (!l.cuts) continue;
      const std::size_t first = places_.size();
      const auto add = [&](const level_place& x) {
        const std::uint32_t number = numbers_.add(x);
        if (places_.size() == first || places_.back() != number) places_.push_back(number);
      };
      for (std::uint32_t k = l.first; k < l.last; ++k) {
        const cell_cuts::chord& c = cuts_.chords()[cuts_.loop_chords()[k]];
        const bool forward = cuts_.start(c) == c.from;
        add(cuts_.crossing(cuts_.start(c)));
        for (std::uint32_t j = 0; j < c.inner_end - c.inner_begin; ++j)
          add(cuts_.crossing(c.facet, cuts_.inner()[forward ? c.inner_begin + j : c.inner_end - 1 - j]));
      }
      while (places_.size() - first > 1 && places_.back() == places_[first]) places_.pop_back();
      loops_.push_back(i);
      ends_.push_back(static_cast<std::uint32_t>(places_.size()));
      for (const bool above : {false, true}) ++loops_at_region_[cuts_.region(corner(i, above))];
    }
  }
  bool are_opposite(std::size_t a, std::size_t b) const {
    const std::uint32_t n = ends_[a] - begin(a);
    if (ends_[b] - begin(b) != n || n == 0) return false;
    const std::uint32_t* const x = places_.data() + begin(a);
    const std::uint32_t* const y = places_.data() + begin(b);
    const auto start = static_cast<std::uint32_t>(std::find(y, y + n, x[0]) - y);
    if (start == n) return false;
    for (std::uint32_t k = 1; k < n; ++k)
      if (x[k] != y[(start + n - k) % n]) return false;
    return true;
  }
  std::vector<std::uint32_t> verts_of_region(std::uint32_t loop, bool above) {
    const std::uint32_t wanted = cuts_.region(corner(loop, above)), cell = cuts_.loops()[loop].cell;
    const crossed_volume& v = cuts_.volume();
    std::vector<std::uint32_t> verts;
    for (std::uint32_t k = v.first_corner[v.first_facet[cell]]; k < v.first_corner[v.first_facet[cell + 1]]; ++k)
      if (cuts_.region(k) == wanted) verts.push_back(v.verts[k]);
    std::sort(verts.begin(), verts.end());
    verts.erase(std::unique(verts.begin(), verts.end()), verts.end());
    return verts;
  }
  /// Whether the regions on one side of two loops are the same, and touch no other loops; or one region between the
  /// two.
  bool change(std::uint32_t a, std::uint32_t b, bool above) {
    const std::uint32_t at_a = corner(a, above), at_b = corner(b, above), ra = cuts_.region(at_a),
                        rb = cuts_.region(at_b);
    if (ra == rb ? loops_at_region_[ra] != 2 : loops_at_region_[ra] != 1 || loops_at_region_[rb] != 1) return false;
    const std::vector<std::uint32_t> verts = verts_of_region(a, above);
    if (ra != rb && verts != verts_of_region(b, above)) return false;
    cuts_.stop_cutting(a), cuts_.stop_cutting(b);
    cuts_.change_region(at_a);
    if (ra != rb) cuts_.change_region(at_b);
    verts_.insert(verts_.end(), verts.begin(), verts.end());
    return true;
  }

 public:
  explicit flat_part_finder(cell_cuts& cuts) : cuts_(cuts) { list_loops(); }

  std::vector<std::uint32_t> remove() {
    std::vector<std::uint64_t> order;
    order.reserve(loops_.size());
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      std::uint64_t sum = 0;  // of a hash of the places: it does not depend on the direction
      for (std::uint32_t k = begin(i); k < ends_[i]; ++k) sum += core::scrambled(places_[k]);
      order.push_back(sum >> 32 << 32 | i);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && order[j] >> 32 == order[i] >> 32; ++j) {
        const auto x = static_cast<std::uint32_t>(order[i]), y = static_cast<std::uint32_t>(order[j]);
        const std::uint32_t a = loops_[x], b = loops_[y];
        if (!cuts_.loops()[a].cuts || !cuts_.loops()[b].cuts || !are_opposite(x, y)) continue;
        if (!change(a, b, true)) change(a, b, false);
      }
    std::sort(verts_.begin(), verts_.end());
    verts_.erase(std::unique(verts_.begin(), verts_.end()), verts_.end());
    return std::move(verts_);
  }
};

CONCINO_INLINE std::vector<std::uint32_t> remove_flat_parts(cell_cuts& cuts) { return flat_part_finder(cuts).remove(); }

}  // namespace concino::detail
