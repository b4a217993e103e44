// Names that files give to polys: a line of text holds until the next one.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/io/numbers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// Different names, numbered from 0 in the order in which they came.
class name_table {
  std::vector<std::string> names_;
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(16);  // open addressed, at most half full: 0 or number + 1

  std::size_t slot_of(std::string_view name) const {
    const std::uint64_t hash = core::hash_bytes(name);
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (hash ^ (hash >> 32)) & mask;
    while (slots_[i] != 0 && std::string_view(names_[slots_[i] - 1]) != name) i = (i + 1) & mask;
    return i;
  }

 public:
  static constexpr std::size_t none = ~std::size_t{0};

  std::size_t size() const { return names_.size(); }
  const std::string& operator[](std::size_t i) const { return names_[i]; }
  std::size_t find(std::string_view name) const { return std::size_t{slots_[slot_of(name)]} - 1; }

  /// The number of a name, which gets one if it has none.
  [[gnu::noinline]] std::size_t add(std::string_view name) {
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
};

/// For each poly a name, kept as the polys at which it changes. Before the first change, and where the name is empty, a poly has none.
class name_runs {
  std::vector<std::string> names_;
  std::vector<std::uint32_t> first_;  // poly of each

 public:
  /// From poly `first` on; polys come in order.
  [[gnu::noinline]] void change(std::size_t first, std::string name) {
    if (!first_.empty() && first_.back() == first) drop_last();
    if (names_.empty() ? name.empty() : std::string_view(names_.back()) == name) return;
    names_.push_back(std::move(name));
    first_.push_back(static_cast<std::uint32_t>(first));
  }

  /// Once all polys are known: changes after the last of them are forgotten.
  void end(std::size_t polys) {
    while (!first_.empty() && first_.back() >= polys) drop_last();
  }

  bool empty() const { return names_.empty(); }
  void clear() {
    names_.clear();
    first_.clear();
  }

  /// f(first, end, name) for every run, the nameless ones too, in order.
  template<class F>
  void for_each(std::size_t polys, const F& f) const {
    const std::size_t begin = empty() ? polys : first_[0];
    if (begin > 0) f(std::size_t{0}, begin, std::string_view{});
    for (std::size_t i = 0; i < first_.size(); ++i)
      f(std::size_t{first_[i]}, i + 1 < first_.size() ? std::size_t{first_[i + 1]} : polys, std::string_view(names_[i]));
  }

  /// Whether f(name) holds for every name.
  template<class F>
  bool all(const F& f) const {
    for (const std::string& name : names_)
      if (!name.empty() && !f(std::string_view(name))) return false;
    return true;
  }

  /// Bytes of the longest name.
  std::size_t longest() const {
    std::size_t n = 0;
    for (const std::string& name : names_) n = std::max(n, name.size());
    return n;
  }

  /// Names f(name) in the place of all names.
  template<class F>
  void rename(const F& f) {
    name_runs renamed;
    for (std::size_t i = 0; i < first_.size(); ++i) renamed.change(first_[i], f(std::string_view(names_[i])));
    names_.swap(renamed.names_);
    first_.swap(renamed.first_);
  }

 private:
  void drop_last() {
    names_.pop_back();
    first_.pop_back();
  }
};

/// Numbers names from 1 in the order in which they are met; no name is 0.
class name_numbers {
  name_table names_;

 public:
  int operator()(std::string_view name) { return name.empty() ? 0 : static_cast<int>(names_.add(name)) + 1; }
};

/// A name that says a number, as writers make them where there is a number but no name: "label_7", "color_3".
[[gnu::noinline]] inline bool says_number(std::string_view name, std::string_view prefix, int& number) {
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  std::int64_t n = 0;
  const char* const end = name.data() + name.size();
  if (parse_integer(name.data(), end, n) != end || n != static_cast<int>(n)) return false;
  number = static_cast<int>(n);
  // no "label_007": it would not be written again
  const char* const digit = name.data() + (name[0] == '-');
  return name[0] != '+' && (*digit != '0' || name.size() == 1);
}

}  // namespace concino::detail
