// Names that files give to polys: a line of text holds until the next one.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Different names, numbered from 0 in the order in which they came.
class name_table {
  std::vector<std::string> names_;
  std::vector<std::uint32_t> slots_;  // open addressed, at most half full: 0 or number + 1

  std::size_t slot_of(std::string_view name) const;

 public:
  static constexpr std::size_t none = ~std::size_t{0};

  name_table();

  std::size_t size() const { return names_.size(); }
  const std::string& operator[](std::size_t i) const { return names_[i]; }
  std::size_t find(std::string_view name) const;

  /// The number of a name, which gets one if it has none.
  std::size_t add(std::string_view name);
};

/// For each poly a name, kept as the polys at which it changes. Before the first change, and where the name is empty, a poly has none.
class name_runs {
  std::vector<std::string> names_;
  std::vector<std::uint32_t> first_;  // poly of each

 public:
  /// From poly `first` on; polys come in order.
  void change(std::size_t first, std::string name);

  /// Once all polys are known: changes after the last of them are forgotten.
  void end(std::size_t polys);

  bool empty() const { return names_.empty(); }
  void clear();

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
  std::size_t longest() const;

  /// Names f(name) in the place of all names.
  template<class F>
  void rename(const F& f) {
    name_runs renamed;
    for (std::size_t i = 0; i < first_.size(); ++i) renamed.change(first_[i], f(std::string_view(names_[i])));
    names_.swap(renamed.names_);
    first_.swap(renamed.first_);
  }

 private:
  void drop_last();
};

/// Numbers names from 1 in the order in which they are met; no name is 0.
class name_numbers {
  name_table names_;

 public:
  int operator()(std::string_view name) { return name.empty() ? 0 : static_cast<int>(names_.add(name)) + 1; }
};

/// A name that says a number, as writers make them where there is a number but no name: "label_7", "color_3".
bool is_number(std::string_view name, std::string_view prefix, int& number);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/name_runs.ipp>
#endif
