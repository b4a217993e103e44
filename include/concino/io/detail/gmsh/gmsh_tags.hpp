// The numbers that Gmsh files call tags: those of nodes and elements, which may be any, and those of entities.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace concino::detail {

/// The indices of nodes or elements by their tags, in any order.
class gmsh_tags {
  std::uint64_t first_ = 0;
  std::uint32_t num_consecutive_ = 0;  // as long as each tag is one more than that before, only their number is stored
  std::vector<std::pair<std::uint64_t, std::uint32_t>> listed_;  // then all, with their indices
  std::vector<std::uint32_t> table_;                             // of indices, if the tags lie near to each other

 public:
  static constexpr std::uint32_t none = ~0u;

  /// Adds the tag of an element. Consecutive ones begin with index 0.
  void add(std::uint64_t tag, std::uint32_t index) {
    if (listed_.empty()) {
      if (num_consecutive_ == 0) first_ = tag;
      if (index == num_consecutive_ && tag - first_ == index) {
        ++num_consecutive_;
        return;
      }
      listed_.reserve(2 * std::size_t{num_consecutive_} + 1);
      for (std::uint32_t i = 0; i < num_consecutive_; ++i) listed_.emplace_back(first_ + i, i);
    }
    listed_.emplace_back(tag, index);
  }

  /// Prepares find() after tags were added.
  void finish() {
    table_.clear();
    if (listed_.empty()) return;
    std::sort(listed_.begin(), listed_.end());
    first_ = listed_.front().first;
    const std::uint64_t range = listed_.back().first - first_;
    if (range / 4 > listed_.size()) return;
    table_.resize(static_cast<std::size_t>(range) + 1, none);
    for (std::size_t i = listed_.size(); i-- > 0;) table_[listed_[i].first - first_] = listed_[i].second;
  }

  /// The first index of this tag; `none` if there is none.
  std::uint32_t find(std::uint64_t tag) const {
    const std::uint64_t i = tag - first_;
    if (listed_.empty()) return i < num_consecutive_ ? static_cast<std::uint32_t>(i) : none;
    if (!table_.empty()) return i < table_.size() ? table_[i] : none;
    const auto at = std::lower_bound(listed_.begin(), listed_.end(), std::pair{tag, 0u});
    return at != listed_.end() && at->first == tag ? at->second : none;
  }

  /// Whether two elements have one tag, which is then stored in `tag`. Needs: finish().
  bool has_repeated(std::uint64_t& tag) const {
    for (std::size_t i = 1; i < listed_.size(); ++i)
      if (listed_[i].first == listed_[i - 1].first) {
        tag = listed_[i].first;
        return true;
      }
    return false;
  }
};

/// The tag of an entity and the label of elements of it. Tag 0 stands for none.
struct gmsh_entity_key {
  int entity = 0, label = 0;
  friend auto operator<=>(const gmsh_entity_key&, const gmsh_entity_key&) = default;
};

/// The tags of the entities that a file has for elements of one dimension. Elements of one entity have one label, or
/// Gmsh takes all of them into all groups. An entity is called as its elements say, if no other is; else as its label,
/// or with the smallest number that is left.
class gmsh_entity_tags {
  std::vector<std::pair<gmsh_entity_key, int>> tags_;  // sorted

 public:
  explicit gmsh_entity_tags(std::vector<gmsh_entity_key> keys) {
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<int> used;
    for (const gmsh_entity_key& k : keys) {
      tags_.emplace_back(k, 0);
      if (k.entity > 0 && (used.empty() || used.back() != k.entity)) used.push_back(tags_.back().second = k.entity);
    }
    std::vector<int> labels;
    for (const auto& [key, tag] : tags_)
      if (tag == 0 && key.label > 0 && !std::binary_search(used.begin(), used.end(), key.label))
        labels.push_back(key.label);
    std::sort(labels.begin(), labels.end());
    std::vector<int> taken;
    std::set_union(used.begin(), used.end(), labels.begin(), labels.end(), std::back_inserter(taken));
    taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
    // each label is the tag of the first of its keys; the others are numbered
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    std::vector<bool> is_used(labels.size());
    int next = 1;
    std::size_t passed = 0;
    for (auto& [key, tag] : tags_) {
      if (tag != 0) continue;
      const auto at = std::lower_bound(labels.begin(), labels.end(), key.label);
      const auto i = static_cast<std::size_t>(at - labels.begin());
      if (at != labels.end() && *at == key.label && !is_used[i]) {
        is_used[i] = true;
        tag = key.label;
        continue;
      }
      for (; passed < taken.size() && taken[passed] <= next; ++passed) next += taken[passed] == next;
      tag = next++;
    }
  }

  /// Needs: one of the keys.
  int operator()(gmsh_entity_key key) const {
    return std::lower_bound(tags_.begin(), tags_.end(), std::pair{key, 0})->second;
  }
};

}  // namespace concino::detail
