// The lines of an Abaqus file that name the members of sets.
#pragma once

#include <concino/io/detail/abaqus/abaqus_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// What adds members to a set: data lines, or new nodes, or the elements of a block.
struct abaqus_set_block {
  element_kind kind;
  std::string name;
  std::size_t named_in, part;  // the parts of its name and of its members
  const char* data = nullptr;
  bool generate = false;
  std::uint32_t first = 0, last = 0;
  std::size_t block = abaqus_sets::none;
};

struct abaqus_member_reader {
  abaqus_cursor& in;
  const std::vector<abaqus_part>& parts;
  const std::map<std::string, std::size_t>& instances;  // the part of each, by its name in upper case

  /// Reads a data line of a set.
  void operator()(const abaqus_set_block& b, abaqus_sets& sets, std::size_t set) const {
    const auto numbers_of = [&](std::size_t part) -> const abaqus_numbers& {
      return b.kind == element_kind::vert ? parts[part].nodes : parts[part].elements;
    };
    if (b.generate) {
      const std::int64_t first = in.integer_field("the first number of a set");
      const std::int64_t last = in.has_field() ? in.integer_field("the last number of a set") : first;
      const bool has_step = in.has_field();
      const char* const from = in.at;
      const std::int64_t step = has_step ? in.integer_field("the step between numbers of a set") : 1;
      if (step <= 0) in.fail(from, "the step between numbers of a set, from 1");
      numbers_of(b.part).for_each(first, last, step, [&](std::uint32_t i) { sets.add(set, i); });
      return in.skip_line();
    }
    while (in.has_field()) {
      const std::string_view member = in.field();
      std::int64_t number = 0;
      if (member.empty()) continue;
      if (abaqus_cursor::is_integer(member, number)) {
        sets.add(set, numbers_of(b.part).find(number));
        continue;
      }
      const std::size_t point = member.find('.');  // the number or the set of an instance
      const auto instance =
          point == member.npos ? instances.end() : instances.find(upper_case(member.substr(0, point)));
      if (instance == instances.end()) sets.add_set(set, b.part, member);
      else if (abaqus_cursor::is_integer(member.substr(point + 1), number))
        sets.add(set, numbers_of(instance->second).find(number));
      else sets.add_set(set, instance->second, member.substr(point + 1));
    }
  }
};

}  // namespace concino::detail
