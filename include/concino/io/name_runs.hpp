// Names that files give to polys: a line of text holds until the next one.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// For each poly a name, kept as the polys at which it changes. Before the first change, and where the name is empty, a poly has none.
class name_runs {
  struct run {
    std::size_t first;
    std::string name;
  };
  std::vector<run> runs_;

 public:
  /// From poly `first` on; polys come in order.
  void change(std::size_t first, std::string name) {
    if (!runs_.empty() && runs_.back().first == first) runs_.pop_back();
    if (runs_.empty() ? name.empty() : runs_.back().name == name) return;
    runs_.push_back({first, std::move(name)});
  }

  /// Once all polys are known: changes after the last of them are forgotten.
  void end(std::size_t polys) {
    while (!runs_.empty() && runs_.back().first >= polys) runs_.pop_back();
  }

  bool empty() const { return runs_.empty(); }
  void clear() { runs_.clear(); }

  /// f(first, end, name) for every run, the nameless ones too, in order.
  template<class F>
  void for_each(std::size_t polys, const F& f) const {
    const std::size_t begin = runs_.empty() ? polys : runs_.front().first;
    if (begin > 0) f(std::size_t{0}, begin, std::string_view{});
    for (std::size_t i = 0; i < runs_.size(); ++i)
      f(runs_[i].first, i + 1 < runs_.size() ? runs_[i + 1].first : polys, std::string_view(runs_[i].name));
  }

  /// Whether f(name) holds for every name.
  template<class F>
  bool all(const F& f) const {
    return std::all_of(runs_.begin(), runs_.end(), [&](const run& r) { return r.name.empty() || f(std::string_view(r.name)); });
  }

  /// Names f(name) in the place of all names.
  template<class F>
  void rename(const F& f) {
    std::vector<run> old;
    old.swap(runs_);
    for (const run& r : old) change(r.first, f(std::string_view(r.name)));
  }
};

/// Numbers names from 1 in the order in which they are met; no name is 0.
class name_numbers {
  std::map<std::string, int, std::less<>> numbers_;

 public:
  int operator()(std::string_view name) {
    if (name.empty()) return 0;
    const auto at = numbers_.find(name);
    if (at != numbers_.end()) return at->second;
    const int n = static_cast<int>(numbers_.size()) + 1;
    numbers_.emplace(name, n);
    return n;
  }
};

/// A name that says a number, as writers make them where there is a number but no name: "label_7", "color_3".
inline bool says_number(std::string_view name, std::string_view prefix, int& number) {
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
  return problem == std::errc() && end == name.data() + name.size() && !name.empty() &&
         name == std::string_view(std::to_string(number));  // no "label_007": it would not be written again
}

}  // namespace concino::detail
