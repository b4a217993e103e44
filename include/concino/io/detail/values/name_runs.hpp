// Names of polys in files where a name applies to all polys up to the next name.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// A set of names, numbered from 0 in the order of insertion.
class name_table {
  std::map<std::string, std::size_t, std::less<>> numbers_;
  std::vector<const std::string*> names_;  // keys of the map, by number

 public:
  static constexpr std::size_t none = ~std::size_t{0};

  name_table() = default;
  name_table(name_table&&) = default;
  name_table& operator=(name_table&&) = default;

  std::size_t size() const { return names_.size(); }
  const std::string& operator[](std::size_t i) const { return *names_[i]; }
  std::size_t find(std::string_view name) const;

  /// The number of a name. Inserts the name if it is new.
  std::size_t add(std::string_view name);
};

/// A name for each poly, stored as the polys at which it changes. Polys before the first change, and polys with an
/// empty name, have none.
class name_runs {
  std::vector<std::string> names_;
  std::vector<std::uint32_t> first_;  // the first poly of each run

 public:
  /// Sets the name from poly `first` on. `first` never decreases.
  void change(std::size_t first, std::string name);

  /// Drops changes after the last poly. Called once the number of polys is known.
  void end(std::size_t polys);

  bool empty() const { return names_.empty(); }
  void clear();

  /// Calls f(first, end, name) for every run in order, including those without a name.
  template<class F>
  void for_each(std::size_t polys, const F& f) const {
    const std::size_t begin = empty() ? polys : first_[0];
    if (begin > 0) f(std::size_t{0}, begin, std::string_view{});
    for (std::size_t i = 0; i < first_.size(); ++i)
      f(std::size_t{first_[i]}, i + 1 < first_.size() ? std::size_t{first_[i + 1]} : polys,
        std::string_view(names_[i]));
  }

  /// Whether f(name) holds for every name.
  template<class F>
  bool all(const F& f) const {
    for (const std::string& name : names_)
      if (!name.empty() && !f(std::string_view(name))) return false;
    return true;
  }

  /// The length of the longest name in bytes.
  std::size_t longest() const;

  /// Replaces the first poly of each run by f(poly), which does not decrease.
  template<class F>
  void renumber(const F& f) {
    name_runs renumbered;
    for (std::size_t i = 0; i < first_.size(); ++i) renumbered.change(f(std::size_t{first_[i]}), std::move(names_[i]));
    names_.swap(renumbered.names_);
    first_.swap(renumbered.first_);
  }

  /// Replaces every name by f(name).
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

/// Numbers names from 1 in the order of their first occurrence; 0 stands for no name.
class name_numbers {
  name_table names_;

 public:
  int operator()(std::string_view name) { return name.empty() ? 0 : static_cast<int>(names_.add(name)) + 1; }
};

/// Whether a name is a prefix and a number, such as "label_7" or "color_3". Writers use such names for numbers without
/// a name.
bool is_number(std::string_view name, std::string_view prefix, int& number);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/values/name_runs.ipp>
#endif
