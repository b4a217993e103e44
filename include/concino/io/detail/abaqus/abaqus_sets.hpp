// The sets of an Abaqus file, which become properties of verts and polys.
#pragma once

#include <concino/io/detail/abaqus/abaqus_cursor.hpp>
#include <concino/io/detail/abaqus/abaqus_parts.hpp>
#include <concino/io/file_contents.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// Sets of one kind, verts or polys. Sets of the same name in one part are one set.
class abaqus_sets {
  struct named_set {
    std::string name;
    std::size_t part;
    std::vector<bool> is_member;
  };

  element_kind kind_;
  std::size_t num_elements_;
  std::uint64_t room_;  // how many values more may be stored
  std::vector<named_set> sets_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> numbers_;  // by part and name in upper case
  std::uint64_t num_refused_ = 0, num_missing_ = 0;

 public:
  /// Many sets of a few elements could take much more memory than the file: no more than `max_values` are stored.
  abaqus_sets(element_kind kind, std::size_t num_elements, std::uint64_t max_values)
      : kind_(kind), num_elements_(num_elements), room_(max_values) {}

  static constexpr std::size_t none = ~std::size_t{0};

  /// The set of that name, which is new if there is none yet; none if there is no room for it.
  std::size_t set_of(std::size_t part, const std::string& name) {
    const auto [at, is_new] = numbers_.try_emplace({part, upper_case(name)}, sets_.size());
    if (!is_new) return at->second;
    if (num_elements_ > room_) {
      ++num_refused_;
      return at->second = none;
    }
    room_ -= num_elements_;
    sets_.push_back({name, part, std::vector<bool>(num_elements_)});
    return at->second;
  }
  void add(std::size_t number, std::uint32_t element) {
    if (number == none) return;
    if (element < num_elements_) sets_[number].is_member[element] = true;
    else ++num_missing_;
  }
  /// Adds the members of the set of that name.
  void add_set(std::size_t number, std::size_t part, std::string_view name) {
    const auto at = numbers_.find({part, upper_case(name)});
    if (at == numbers_.end()) ++num_missing_;
    if (number == none || at == numbers_.end() || at->second == none) return;
    const std::vector<bool>& from = sets_[at->second].is_member;
    for (std::size_t i = 0; i < num_elements_; ++i)
      if (from[i]) sets_[number].is_member[i] = true;
  }
  /// Makes the sets properties. If sets of several parts have the same name, those after the first one have that of
  /// their part and a point before it.
  void store(const std::vector<abaqus_part>& parts, file_contents& out, load_report& report) {
    std::map<std::string, std::size_t> used;
    for (const named_set& s : sets_) {
      const bool is_first = used.try_emplace(upper_case(s.name), 0).second;
      const std::string name = is_first ? s.name : core::joined({parts[s.part].name, ".", s.name});
      int* const values = out.add_property<int>(kind_, name, num_elements_);
      for (std::size_t i = 0; i < num_elements_; ++i) values[i] = s.is_member[i] ? 1 : 0;
    }
    const char* const what = kind_ == element_kind::vert ? "nodes" : "elements";
    if (num_missing_)
      report.skipped.push_back(
          core::joined({num_missing_, " members of sets of ", what, ", which the mesh does not have"}));
    if (num_refused_)
      report.skipped.push_back(
          core::joined({num_refused_, " sets of ", what, ", as so many would take too much memory"}));
  }
};

}  // namespace concino::detail
