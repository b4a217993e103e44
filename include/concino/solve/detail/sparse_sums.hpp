// Sums of numbers by index.
#pragma once

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Sums of numbers by index, for a few of many indices. Adding does not branch on whether an index is new, which cannot be predicted.
class sparse_sums {
  std::vector<int> position_;  // of each index in the next arrays, if they have it
  std::vector<int> index_;
  std::vector<double> sum_;
  int size_ = 0;

 public:
  explicit sparse_sums(std::size_t indices) : position_(indices) {}

  int size() const { return size_; }
  int index(int k) const { return index_[static_cast<std::size_t>(k)]; }
  double sum(int k) const { return sum_[static_cast<std::size_t>(k)]; }
  void clear() { size_ = 0; }

  /// Makes place for so many more terms.
  void expect(int terms) {
    const auto needed = static_cast<std::size_t>(size_) + static_cast<std::size_t>(terms) + 1;
    if (index_.size() >= needed) return;
    index_.resize(2 * needed);
    sum_.resize(2 * needed);
  }
  void add(int i, double x) {
    int& known = position_[static_cast<std::size_t>(i)];
    const bool is_known = known < size_ && index_[static_cast<std::size_t>(known)] == i;
    const int at = is_known ? known : size_;
    const double before = is_known ? sum_[static_cast<std::size_t>(at)] : 0;
    known = at;
    index_[static_cast<std::size_t>(at)] = i;
    sum_[static_cast<std::size_t>(at)] = before + x;
    size_ += !is_known;
  }
};

}  // namespace concino::detail
