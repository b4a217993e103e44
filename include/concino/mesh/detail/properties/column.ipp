// Copies, moves and combines the values of a property; see column.hpp.
#pragma once

#include <concino/mesh/detail/properties/column.hpp>
#include <concino/mesh/element_origins.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace concino::detail {

CONCINO_INLINE void column::make_room(std::size_t n) {
  column fresh(*type_);
  fresh.data_ = static_cast<unsigned char*>(::operator new(n * type_->size, std::align_val_t(type_->alignment)));
  fresh.room_ = n;
  if (type_->move) {
    for (; fresh.size_ < size_; ++fresh.size_) type_->move(fresh.at(fresh.size_), at(fresh.size_));
  } else if (size_ > 0) {
    std::memcpy(fresh.data_, data_, size_ * type_->size);
    fresh.size_ = size_;
  }
  std::swap(data_, fresh.data_), std::swap(size_, fresh.size_), std::swap(room_, fresh.room_);
}

CONCINO_INLINE column::column(const value_type& type, std::size_t n) : column(type) {
  make_room(n);
  resize(n);
}

CONCINO_INLINE column::column(const column& o) : column(*o.type_) {
  rule_ = o.rule_;
  make_room(o.size_);
  if (type_->copy) {
    for (; size_ < o.size_; ++size_) type_->copy(at(size_), o.at(size_));
  } else if (o.size_ > 0) {
    std::memcpy(data_, o.data_, o.size_ * type_->size);
    size_ = o.size_;
  }
}

/// Constructs a default value behind the last one.
CONCINO_INLINE void column::make_default() {
  if (type_->make) type_->make(at(size_));
  else std::memset(at(size_), 0, type_->size);
}

CONCINO_INLINE void column::copy_value(const column& o, std::size_t from) {
  if (type_->copy) type_->copy(at(size_), o.at(from));
  else std::memcpy(at(size_), o.at(from), type_->size);
  ++size_;
}

/// Calls scale or add for value i and a value of another column.
CONCINO_INLINE void column::apply_to_parts(void (*f)(void*, const void*, double), std::size_t i, const column& o,
                                           std::size_t from, double factor) {
  const std::size_t size = type_->size / type_->num_parts;
  for (std::size_t k = 0; k < type_->num_parts; ++k) f(at(i) + k * size, o.at(from) + k * size, factor);
}

/// The origin of one element with the largest weight; the first of several.
CONCINO_INLINE std::uint32_t largest_origin(const element_origins::range& origins) {
  origin largest = origins[0];
  for (const origin x : origins)
    if (x.weight > largest.weight) largest = x;
  return largest.index;
}

CONCINO_INLINE void column::copy_largest(const column& o, const element_origins& from) {
  while (size_ < from.size()) {
    const auto origins = from[size_];
    if (!origins.empty()) copy_value(o, largest_origin(origins));
    else make_default(), ++size_;
  }
}

CONCINO_INLINE void column::interpolate(const column& o, const element_origins& from) {
  while (size_ < from.size()) {
    const auto origins = from[size_];
    if (origins.empty()) {
      make_default(), ++size_;
      continue;
    }
    if (origins.size() == 1) {
      copy_value(o, origins[0].index);
      continue;
    }
    double total = 0;
    for (const origin x : origins) total += x.weight;
    const auto weight = [&](const origin& x) {
      return total > 0 ? x.weight / total : 1 / static_cast<double>(origins.size());
    };
    const std::size_t here = size_;
    apply_to_parts(type_->scale, here, o, origins[0].index, weight(origins[0]));
    ++size_;
    for (std::size_t k = 1; k < origins.size(); ++k)
      apply_to_parts(type_->add, here, o, origins[k].index, weight(origins[k]));
  }
}

/// Splits each old value among the elements that have it as origin, in proportion to their weights. A value that cannot
/// be split goes to the element with the largest weight.
CONCINO_INLINE void column::sum(const column& o, const element_origins& from) {
  struct parts {
    double total = 0, largest = -1;
    std::size_t count = 0, owner = 0;
  };
  std::vector<std::uint32_t> few;  // sorted: the origins, if they are few
  const bool are_few = from.size() < o.size_ / 8;
  if (are_few) {
    for (std::size_t i = 0; i < from.size(); ++i)
      for (const origin x : from[i]) few.push_back(x.index);
    std::sort(few.begin(), few.end());
    few.erase(std::unique(few.begin(), few.end()), few.end());
  }
  const auto number = [&](std::uint32_t i) {
    return are_few ? static_cast<std::size_t>(std::lower_bound(few.begin(), few.end(), i) - few.begin()) : i;
  };
  std::vector<parts> all(are_few ? few.size() : o.size_);
  for (std::size_t i = 0; i < from.size(); ++i)
    for (const origin x : from[i]) {
      parts& p = all[number(x.index)];
      p.total += x.weight;
      ++p.count;
      if (x.weight > p.largest) p.largest = x.weight, p.owner = i;
    }
  const bool can_be_parted = type_->scale != nullptr;
  while (size_ < from.size()) {
    const std::size_t here = size_;
    for (const origin x : from[here]) {
      parts& p = all[number(x.index)];
      // an owner may have it as origin twice
      if (!can_be_parted && std::exchange(p.owner, p.owner == here ? from.size() : p.owner) != here) continue;
      const double part = !can_be_parted || p.count == 1 ? 1
                          : p.total > 0                  ? x.weight / p.total
                                                         : 1 / static_cast<double>(p.count);
      if (size_ > here) apply_to_parts(type_->add, here, o, x.index, part);
      else if (part == 1) copy_value(o, x.index);
      else apply_to_parts(type_->scale, here, o, x.index, part), ++size_;
    }
    if (size_ == here) make_default(), ++size_;
  }
}

CONCINO_INLINE column::column(const column& o, const element_origins& from) : column(*o.type_) {
  rule_ = o.rule_;
  make_room(from.size());
  if (rule_ == property_rule::interpolate) interpolate(o, from);
  else if (rule_ == property_rule::sum) sum(o, from);
  else copy_largest(o, from);
}

CONCINO_INLINE bool column::set_rule(property_rule rule) {
  const bool is_possible = rule == property_rule::copy ||
                           (rule == property_rule::interpolate ? type_->scale != nullptr : type_->add != nullptr);
  if (is_possible) rule_ = rule;
  return is_possible;
}

CONCINO_INLINE column::~column() {
  resize(0);
  ::operator delete(data_, std::align_val_t(type_->alignment));
}

CONCINO_INLINE void column::resize(std::size_t n) {
  if (n > room_) make_room(std::max(n, 2 * size_));
  if (type_->destroy) {
    while (size_ > n) type_->destroy(at(--size_));
    for (; size_ < n; ++size_) type_->make(at(size_));
    return;
  }
  if (size_ < n) {
    // the first value is constructed, then copied in ever larger blocks, but no larger than a cache
    make_default();
    for (std::size_t num_filled = 1, more = 1; size_ + num_filled < n; num_filled += more) {
      more = std::min({num_filled, n - size_ - num_filled, std::size_t{1024}});
      std::memcpy(at(size_ + num_filled), at(size_), more * type_->size);
    }
  }
  size_ = n;
}

CONCINO_INLINE void column::take(std::size_t i, column& from, std::size_t k) noexcept {
  if (!type_->move) {
    std::memcpy(at(i), from.at(k), type_->size);
    return;
  }
  type_->destroy(at(i));
  type_->move(at(i), from.at(k));
}

CONCINO_INLINE void column::swap_values(column& o) noexcept {
  std::swap(data_, o.data_), std::swap(size_, o.size_), std::swap(room_, o.room_);
}

}  // namespace concino::detail
