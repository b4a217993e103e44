// Bodies of name_runs.hpp: names of polys in files where a name applies to all polys up to the next name.
#pragma once

#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/numbers.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE std::size_t name_table::find(std::string_view name) const {
  const auto at = numbers_.find(name);
  return at == numbers_.end() ? none : at->second;
}

CONCINO_INLINE std::size_t name_table::add(std::string_view name) {
  const auto [at, is_new] = numbers_.try_emplace(std::string(name), names_.size());
  if (is_new) names_.push_back(&at->first);
  return at->second;
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
