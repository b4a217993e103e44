// Which elements of one kind there are: indices 0 .. bound-1 without the deleted ones. Deleting leaves a gap, so no other element changes its
// index; nothing is stored while nothing was deleted.
#pragma once

#include <concino/concepts/ranges.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

template<class Id>
class live {
  std::size_t bound_ = 0;
  std::size_t deleted_ = 0;
  std::vector<std::uint8_t> dead_;  // empty, or one flag per index

 public:
  live() = default;
  explicit live(std::size_t n) : bound_(n) {}

  std::size_t bound() const { return bound_; }
  std::size_t size() const { return bound_ - deleted_; }
  bool contains(Id x) const { return x.raw() < bound_ && (dead_.empty() || !dead_[x.raw()]); }
  id_range<Id> all() const { return id_range<Id>(bound_, dead_.empty() ? nullptr : dead_.data()); }

  Id add() {
    if (!dead_.empty()) dead_.push_back(0);
    return Id{bound_++};
  }
  void remove(Id x) {
    if (!contains(x)) return;
    if (dead_.empty()) dead_.resize(bound_, 0);
    dead_[x.raw()] = 1;
    ++deleted_;
  }
};

}  // namespace concino::detail
