// What an Abaqus file consists of: reads its nodes, finds its elements and sets, and reads the sets once the elements
// are known.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/io/detail/abaqus/abaqus_elements.hpp>
#include <concino/io/detail/abaqus/abaqus_set_lines.hpp>
#include <concino/io/detail/cells/corners.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class abaqus_model {
 public:
  /// The data lines of *ELEMENT.
  struct element_block {
    const char *at, *data;
    std::size_t part;
    std::string type;  // in upper case
    abaqus_element element;
    std::uint64_t num_lines = 0;
    std::uint32_t first = 0, last = 0;  // the polys, once they are read
  };

  std::vector<abaqus_part> parts = std::vector<abaqus_part>(1);  // the first one is no part
  std::vector<vec3> points;
  std::vector<element_block> elements;

  abaqus_model(abaqus_cursor& in, load_report& report) : in_(in), report_(report) {}

  /// Reads the nodes of all parts.
  void read() {
    if (!in_.next_line() || *in_.at != '*') in_.fail(in_.at, "a keyword line, which begins with *");
    while (in_.next_line()) {
      if (*in_.at != '*') {
        in_.skip_line();
        continue;
      }
      read_keyword(in_.read_keyword());
    }
    if (!has_nodes_) in_.fail(in_.end(), "a keyword *NODE");
    check_numbers(&abaqus_part::nodes, "a node number that is not used yet");
    report();
  }

  /// Sorts the numbers of all parts. Errors: parse_error if one is there twice.
  void check_numbers(abaqus_numbers abaqus_part::*numbers, const char* expected) {
    for (abaqus_part& p : parts)
      if (const abaqus_numbers::entry* const twice = (p.*numbers).sort())
        in_.fail(twice->at, {expected}, {twice->number});
  }

  /// Reads the sets, and stores them as properties.
  void read_sets(std::size_t num_points, std::uint32_t num_polys, file_contents& out) {
    const auto size = static_cast<std::uint64_t>(in_.end() - in_.begin());
    abaqus_sets of_nodes(element_kind::vert, num_points, 16 * size),
        of_elements(element_kind::poly, num_polys, 16 * size);
    const abaqus_member_reader read_members{in_, parts, instances_};
    for (const abaqus_set_block& b : sets_) {
      abaqus_sets& sets = b.kind == element_kind::vert ? of_nodes : of_elements;
      const std::size_t set = sets.set_of(b.named_in, b.name);
      for (std::uint32_t i = b.first; i < b.last; ++i) sets.add(set, i);
      if (b.block != abaqus_sets::none)
        for (std::uint32_t i = elements[b.block].first; i < elements[b.block].last; ++i) sets.add(set, i);
      if (!b.data) continue;
      in_.at = b.data;
      while (in_.next_data_line()) read_members(b, sets, set);
    }
    of_nodes.store(parts, out, report_);
    of_elements.store(parts, out, report_);
  }

 private:
  abaqus_cursor& in_;
  load_report& report_;
  std::vector<abaqus_set_block> sets_;
  std::size_t part_ = 0;  // the part whose lines are read
  bool has_nodes_ = false, has_assembly_ = false;
  std::uint64_t num_normals_ = 0;
  std::map<std::string, std::size_t> parts_by_name_, instances_;  // names in upper case
  std::map<std::string, std::uint64_t> skipped_;                  // keywords, and how often they are there

  void read_keyword(const abaqus_keyword& k) {
    constexpr std::string_view generators[] = {"INCLUDE", "NGEN",  "NFILL",  "NCOPY",
                                               "NMAP",    "ELGEN", "ELCOPY", "SYSTEM"};
    for (const std::string_view g : generators)
      if (std::string_view(k.name) == g) fail_unsupported(k, {"is not read"});
    if (k.name == "NODE") read_nodes(k);
    else if (k.name == "ELEMENT") find_elements(k);
    else if (k.name == "NSET") find_set(k, element_kind::vert);
    else if (k.name == "ELSET") find_set(k, element_kind::poly);
    else if (k.name == "PART") begin_part(k);
    else if (k.name == "INSTANCE") begin_instance(k);
    else if (k.name == "ENDPART" || k.name == "ENDINSTANCE") part_ = 0;
    else if (k.name != "ASSEMBLY" && k.name != "ENDASSEMBLY") ++skipped_[k.name];
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_unsupported(const abaqus_keyword& k, core::message why) const {
    core::throw_joined<unsupported>(
        {in_.name(), ":", in_.line_of(k.at), ": *", k.name, " ", core::joined(why), "; write the model without it"});
  }
  const std::string& needed(const abaqus_keyword& k, const char* parameter) const {
    const std::string* const value = k.find(parameter);
    if (!value || value->empty())
      in_.fail(k.at, {"the parameter ", parameter, "= of *", k.name}, {"a line without it"});
    return *value;
  }
  void reject_files(const abaqus_keyword& k) const {
    for (const char* const name : {"INPUT", "FILE"})
      if (k.find(name)) fail_unsupported(k, {"has data in another file (", name, "=)"});
  }

  void begin_part(const abaqus_keyword& k) {
    const std::string name = upper_case(needed(k, "NAME"));
    if (!parts_by_name_.try_emplace(name, parts.size()).second)
      in_.fail(k.at, {"another name of a part"}, {name, " twice"});
    part_ = parts.size();
    parts.push_back({name});
  }

  /// Its lines belong to the part, or if this is empty, to one of its own.
  void begin_instance(const abaqus_keyword& k) {
    has_assembly_ = true;
    const std::string name = upper_case(needed(k, "NAME"));
    const auto found = parts_by_name_.find(upper_case(needed(k, "PART")));
    if (found == parts_by_name_.end()) in_.fail(k.at, {"the name of a part"}, {*k.find("PART")});
    part_ = found->second;
    while (in_.next_data_line()) {
      bool moves = false;
      for (std::size_t i = 0; in_.has_field(); ++i)
        if (in_.real_field("the translation or rotation of an instance") != 0) moves = true;
      if (moves) fail_unsupported(k, {"moves the instance ", name, " of a part"});
    }
    if (parts[part_].empty()) {
      part_ = parts.size();
      parts.push_back({name});
    } else if (parts[part_].has_instance) {
      fail_unsupported(k, {"has another instance of the part ", parts[part_].name, ", at the same place"});
    }
    parts[part_].has_instance = true;
    instances_.try_emplace(name, part_);
  }

  void read_nodes(const abaqus_keyword& k) {
    reject_files(k);
    if (const std::string* const system = k.find("SYSTEM"); system && !system->empty() && upper_case(*system) != "R")
      fail_unsupported(k, {"has cylindrical or spherical coordinates (SYSTEM=)"});
    has_nodes_ = true;
    const auto first = static_cast<std::uint32_t>(points.size());
    while (in_.next_data_line()) {
      const char* const from = in_.at;
      const std::int64_t number = in_.integer_field("the number of a node");
      if (number <= 0) in_.fail(from, "the number of a node, from 1");
      vec3 p;
      if (in_.has_field()) p.x = in_.real_field("the x of a node");
      if (in_.has_field()) p.y = in_.real_field("the y of a node");
      if (in_.has_field()) p.z = in_.real_field("the z of a node");
      num_normals_ += in_.has_field();
      in_.skip_line();
      if (points.size() == max_ids) in_.fail_to_count("nodes");
      parts[part_].nodes.add(number, from, static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    if (const std::string* const name = k.find("NSET"); name && !name->empty())
      sets_.push_back({.kind = element_kind::vert,
                       .name = *name,
                       .named_in = part_,
                       .part = part_,
                       .first = first,
                       .last = static_cast<std::uint32_t>(points.size())});
  }

  void find_elements(const abaqus_keyword& k) {
    reject_files(k);
    element_block b{k.at, in_.at, part_, upper_case(needed(k, "TYPE")), {}};
    b.element = abaqus_element_of(b.type);
    for (; in_.next_data_line(); in_.skip_line()) ++b.num_lines;
    if (const std::string* const name = k.find("ELSET"); name && !name->empty())
      sets_.push_back(
          {.kind = element_kind::poly, .name = *name, .named_in = part_, .part = part_, .block = elements.size()});
    elements.push_back(std::move(b));
  }

  void find_set(const abaqus_keyword& k, element_kind kind) {
    reject_files(k);
    abaqus_set_block b{.kind = kind,
                       .name = needed(k, kind == element_kind::vert ? "NSET" : "ELSET"),
                       .named_in = part_,
                       .part = part_,
                       .data = in_.at,
                       .generate = k.find("GENERATE") != nullptr};
    if (const std::string* const name = k.find("INSTANCE")) {
      const auto found = instances_.find(upper_case(*name));
      if (found == instances_.end()) in_.fail(k.at, {"the name of an instance"}, {*name});
      b.part = found->second;
    }
    while (in_.next_data_line()) in_.skip_line();
    if (kind == element_kind::vert && k.find("ELSET")) ++skipped_["NSET with ELSET="];
    else sets_.push_back(std::move(b));
  }

  void report() {
    for (const auto& [keyword, number] : skipped_)
      report_.skipped.push_back(core::joined({"*", keyword, ", ", number, number == 1 ? " time" : " times"}));
    if (num_normals_) report_.skipped.push_back(core::joined({"the normals of ", num_normals_, " nodes"}));
    for (const abaqus_part& p : parts)
      if (has_assembly_ && &p != &parts[0] && !p.has_instance && !p.empty())
        report_.notes.push_back(core::joined({"the part ", p.name, " has no instance, and is read all the same"}));
  }
};

}  // namespace concino::detail
