// The parts of an Abaqus file, each with its own numbers of nodes and elements, and the instances of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The numbers of nodes or elements: any positive integers. Needs: sort() before find() and for_each().
class abaqus_numbers {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct entry {
    std::int64_t number;
    const char* at;       // where the file defines it
    std::uint32_t index;  // in the mesh
  };

  void add(std::int64_t number, const char* at, std::uint32_t index) { all_.push_back({number, at, index}); }
  bool empty() const { return all_.empty(); }

  /// Result: the second entry with a number that is there twice, or null.
  const entry* sort() {
    const auto less = [](const entry& a, const entry& b) {
      return a.number != b.number ? a.number < b.number : a.at < b.at;
    };
    if (!std::is_sorted(all_.begin(), all_.end(), less)) std::sort(all_.begin(), all_.end(), less);
    for (std::size_t i = 1; i < all_.size(); ++i)
      if (all_[i].number == all_[i - 1].number) return &all_[i];
    return nullptr;
  }
  /// The index of a number, or none.
  std::uint32_t find(std::int64_t number) const {
    if (all_.empty() || number < all_.front().number || number > all_.back().number) return none;
    const auto guess = static_cast<std::size_t>(number - all_.front().number);
    if (guess < all_.size() && all_[guess].number == number) return all_[guess].index;
    const auto i = lower_bound(number);
    return i != all_.end() && i->number == number ? i->index : none;
  }
  /// Calls f(index) for all numbers first, first + step, ... up to last. Needs: step > 0.
  template<class F>
  void for_each(std::int64_t first, std::int64_t last, std::int64_t step, const F& f) const {
    for (auto i = lower_bound(first); i != all_.end() && i->number <= last; ++i)
      if ((i->number - first) % step == 0) f(i->index);
  }

 private:
  std::vector<entry> all_;

  std::vector<entry>::const_iterator lower_bound(std::int64_t number) const {
    return std::lower_bound(all_.begin(), all_.end(), number,
                            [](const entry& e, std::int64_t n) { return e.number < n; });
  }
};

/// A part; the first one is what belongs to no part.
struct abaqus_part {
  std::string name;  // in upper case
  abaqus_numbers nodes = {}, elements = {};
  bool has_instance = false;

  bool empty() const { return nodes.empty() && elements.empty(); }
};

}  // namespace concino::detail
