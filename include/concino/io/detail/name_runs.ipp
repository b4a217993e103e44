// Definitions of name_runs.hpp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/io/detail/name_runs.hpp>
#include <concino/io/numbers.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE name_table::name_table() : slots_(16) {}

CONCINO_INLINE std::size_t name_table::slot_of(std::string_view name) const {
  const std::uint64_t hash = core::hash_bytes(name);
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = (hash ^ (hash >> 32)) & mask;
  while (slots_[i] != 0 && std::string_view(names_[slots_[i] - 1]) != name) i = (i + 1) & mask;
  return i;
}

CONCINO_INLINE std::size_t name_table::find(std::string_view name) const { return std::size_t{slots_[slot_of(name)]} - 1; }

CONCINO_INLINE std::size_t name_table::add(std::string_view name) {
  const std::size_t found = find(name);
  if (found != none) return found;
  names_.push_back(std::string(name));
  if (2 * names_.size() > slots_.size()) {
    slots_ = std::vector<std::uint32_t>(2 * slots_.size());
    for (std::size_t i = 0; i + 1 < names_.size(); ++i) slots_[slot_of(names_[i])] = static_cast<std::uint32_t>(i + 1);
  }
  slots_[slot_of(name)] = static_cast<std::uint32_t>(names_.size());
  return names_.size() - 1;
}

CONCINO_INLINE void name_runs::change(std::size_t first, std::string name) {
  if (!first_.empty() && first_.back() == first) drop_last();
  if (names_.empty() ? name.empty() : std::string_view(names_.back()) == name) return;
  names_.push_back(std::move(name));
  first_.push_back(static_cast<std::uint32_t>(first));
}

CONCINO_INLINE void name_runs::end(std::size_t polys) {
  while (!first_.empty() && first_.back() >= polys) drop_last();
}

CONCINO_INLINE void name_runs::clear() {
  names_.clear();
  first_.clear();
}

CONCINO_INLINE std::size_t name_runs::longest() const {
  std::size_t n = 0;
  for (const std::string& name : names_) n = std::max(n, name.size());
  return n;
}

CONCINO_INLINE void name_runs::drop_last() {
  names_.pop_back();
  first_.pop_back();
}

CONCINO_INLINE bool is_number(std::string_view name, std::string_view prefix, int& number) {
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  std::int64_t n = 0;
  const char* const end = name.data() + name.size();
  if (parse_integer(name.data(), end, n) != end || n != static_cast<int>(n)) return false;
  number = static_cast<int>(n);
  // rejects "label_007": a writer would not write it in this form
  const char* const digit = name.data() + (name[0] == '-');
  return name[0] != '+' && (*digit != '0' || name.size() == 1);
}

}  // namespace concino::detail
