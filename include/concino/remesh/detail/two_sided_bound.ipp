// Bodies of two_sided_bound.hpp: whether edits keep a surface near the one that it was, and that one near it.
#pragma once

#include <concino/remesh/detail/two_sided_bound.hpp>

#include <algorithm>

namespace concino::detail {

/// A few triangles, which are all looked at.
struct few_triangles {
  const std::vector<triangle_points>& all;

  const triangle_points& triangle(std::size_t i) const { return all[i]; }
  double squared_distance(const vec3& x, std::size_t i) const {
    const vec3 d = x - closest_point(x, all[i][0], all[i][1], all[i][2]);
    return dot(d, d);
  }
  core::triangle_tree::nearest_result nearest(const vec3& x, std::size_t guess) const {
    core::triangle_tree::nearest_result best{guess, squared_distance(x, guess)};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const double d = squared_distance(x, i); d < best.squared) best = {i, d};
    return best;
  }
};

/// Whether all points of t are near triangles. Marks those that this follows from in is_used_. False too if it is not
/// known after max_cuts.
template<class Triangles>
bool two_sided_bound::is_near(const triangle_points& t, const Triangles& to, std::size_t guess, std::size_t max_cuts) {
  for (const vec3& x : t)
    if (to.nearest(x, guess).squared > squared_limit_) return false;
  stack_.clear();
  bool is_far = false;
  const auto look_at = [&](core::polygon_part& p) {
    is_far = is_far || p.bound(to, p.candidate) > squared_limit_;
    if (p.upper > squared_limit_) stack_.push_back(p);
    else if (p.candidate < is_used_.size()) is_used_[p.candidate] = 1;
  };
  core::polygon_part whole;
  for (const vec3& x : t) whole.add(x);
  whole.candidate = guess;
  look_at(whole);
  for (std::size_t cuts = 0; !stack_.empty(); ++cuts) {
    if (is_far || cuts == max_cuts) return false;
    core::polygon_part p = stack_.back();
    stack_.pop_back();
    const std::size_t candidate = p.candidate;
    if (p.split_at(to.triangle(candidate), look_at)) {
      look_at(p);
      continue;
    }
    auto halves = p.halves();
    if (halves[0].n >= 3 && halves[1].n >= 3)
      for (core::polygon_part& half : halves) look_at(half);
    else if (candidate < is_used_.size()) is_used_[candidate] = 1;  // it is a point, up to rounding, and near
  }
  return !is_far;
}

CONCINO_INLINE two_sided_bound::two_sided_bound(std::span<const surface_part> input, double limit)
    : input_([&] {
        std::vector<triangle_points> all;
        for (const surface_part& x : input) all.push_back(x.points);
        return all;
      }()),
      squared_limit_(std::max(limit, core::polygon_part::unit) * std::max(limit, core::polygon_part::unit)) {
  std::uint32_t bound = 0;
  for (const surface_part& x : input) bound = std::max(bound, x.id + 1);
  parts_.resize(bound), first_of_part_.resize(bound, none);
  items_.reserve(input.size()), links_.reserve(input.size());
  first_of_item_.resize(input.size(), none);
  for (const surface_part& x : input) {
    parts_[x.id] = x.points;
    items_.push_back(x.points);
    add_link(static_cast<std::uint32_t>(items_.size() - 1), x.id);
  }
}

CONCINO_INLINE void two_sided_bound::add_link(std::uint32_t item, std::uint32_t part) {
  const link x{item, part, first_of_item_[item], first_of_part_[part]};
  std::uint32_t i = free_;
  if (i == none) i = static_cast<std::uint32_t>(links_.size()), links_.push_back(x);
  else free_ = links_[i].next_of_part, links_[i] = x;
  first_of_item_[item] = first_of_part_[part] = i;
}

CONCINO_INLINE void two_sided_bound::remove_links_of(std::uint32_t part) {
  for (std::uint32_t i = first_of_part_[part]; i != none;) {
    std::uint32_t* at = &first_of_item_[links_[i].item];
    while (*at != i) at = &links_[*at].next_of_item;
    *at = links_[i].next_of_item;
    const std::uint32_t next = links_[i].next_of_part;
    links_[i].next_of_part = free_;
    free_ = i;
    i = next;
  }
  first_of_part_[part] = none;
}

CONCINO_INLINE void two_sided_bound::find_changed_items() {
  changed_items_.clear();
  for (const std::uint32_t part : change_.old)
    for (std::uint32_t i = first_of_part_[part]; i != none; i = links_[i].next_of_part)
      changed_items_.push_back(links_[i].item);
  std::sort(changed_items_.begin(), changed_items_.end());
  changed_items_.erase(std::unique(changed_items_.begin(), changed_items_.end()), changed_items_.end());
}

/// The candidates are the new parts, which come first, and those of the item that stay.
CONCINO_INLINE bool two_sided_bound::item_is_near(std::uint32_t item) {
  const std::size_t num_new = change_.added.size();
  candidates_.resize(num_new);
  for (std::uint32_t i = first_of_item_[item]; i != none; i = links_[i].next_of_item) {
    const std::uint32_t part = links_[i].part;
    if (std::find(change_.old.begin(), change_.old.end(), part) == change_.old.end())
      candidates_.push_back(parts_[part]);
  }
  if (candidates_.empty()) return false;
  is_used_.assign(num_new, 0);
  if (!is_near(items_[item], few_triangles{candidates_}, 0, 64 + 8 * candidates_.size())) return false;
  for (std::size_t k = 0; k < num_new; ++k)
    if (is_used_[k]) new_links_.push_back({item, change_.added[k].id, none, none});
  return true;
}

CONCINO_INLINE bool two_sided_bound::stays_near(const part_change& change) {
  change_ = change;
  new_links_.clear();
  find_changed_items();
  is_used_.clear();
  if (!items_.empty())
    for (const surface_part& x : change_.added)
      if (!is_near(x.points, input_, 0, 64 + 8 * changed_items_.size())) return false;
  candidates_.clear();
  for (const surface_part& x : change_.added) candidates_.push_back(x.points);
  return std::all_of(changed_items_.begin(), changed_items_.end(),
                     [&](std::uint32_t item) { return item_is_near(item); });
}

CONCINO_INLINE void two_sided_bound::accept() {
  for (const std::uint32_t part : change_.old) remove_links_of(part);
  for (const surface_part& x : change_.added) {
    if (x.id >= parts_.size()) parts_.resize(x.id + 1), first_of_part_.resize(x.id + 1, none);
    parts_[x.id] = x.points;
  }
  for (const link& x : new_links_) add_link(x.item, x.part);
}

}  // namespace concino::detail
