// The patches and zones of an OpenFOAM file that is written: valid names for labels, and their other entries.
#pragma once

#include <concino/io/detail/openfoam/foam_entries.hpp>
#include <concino/io/label_names.hpp>
#include <concino/io/write_context.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// The name as a word of OpenFOAM: characters that it cannot hold become `_`, and so does what is before the first
/// letter.
inline std::string foam_word(std::string_view name) {
  std::string word;
  int depth = 0;
  for (const char c : name) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    const bool fits = static_cast<unsigned char>(c) > 32 && c != 127 && depth >= 0 &&
                      std::string_view("\"'/;{}#$\\").find(c) == std::string_view::npos;
    depth = std::max(depth, 0);
    word += fits ? c : '_';
  }
  if (depth != 0) std::replace(word.begin(), word.end(), '(', '_'), std::replace(word.begin(), word.end(), ')', '_');
  const auto is_letter = [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; };
  if (word.empty() || !(is_letter(word[0]) || word[0] == '_' || static_cast<unsigned char>(word[0]) >= 128))
    word.insert(word.begin(), '_');
  return word;
}

/// The key and the value of a line that is one entry; two empty texts if it is none.
inline std::pair<std::string, std::string> foam_entry_of(const std::string& line) {
  try {
    foam_cursor in(line, "line");
    in.skip();
    std::string key(next_foam_key(in)), value = next_foam_value(in);
    in.require_end("the end of the line");
    return {std::move(key), std::move(value)};
  } catch (const error&) {
    return {};
  }
}

/// A patch or zone.
struct foam_group {
  int label = 0;
  std::string name = {};
  std::vector<std::string> lines = {};       // with the type first, if it was missing
  std::vector<std::uint32_t> elements = {};  // faces or polys
};

/// The groups of a kind of elements: those with names in the order of label_names, then those without a name by their
/// labels, then what has no label.
class foam_groups {
  save_report& report_;
  const char* what_;                                    // "patch", for messages
  std::vector<std::pair<int, std::uint32_t>> numbers_;  // of the group of each label, sorted

  void add(int label, std::string_view name) {
    std::string word = foam_word(name), unique = word;
    const auto is_used = [&](const std::string& n) {
      return std::any_of(all.begin(), all.end(), [&](const foam_group& g) { return g.name == n; });
    };
    for (unsigned k = 2; is_used(unique); ++k) unique = core::joined({word, "_", k});
    if (std::string_view(unique) != name)
      report_.notes.push_back(core::joined({"the ", what_, " \"", name, "\" is called ", unique}));
    const auto number = static_cast<std::uint32_t>(all.size());
    numbers_.insert(std::upper_bound(numbers_.begin(), numbers_.end(), std::pair{label, number}), {label, number});
    all.push_back({label, std::move(unique)});
  }

  void add_lines(foam_group& g, const std::vector<std::string>& lines, std::string_view type) {
    bool has_type = false;
    for (const std::string& line : lines) {
      const auto [key, value] = foam_entry_of(line);
      if (key.empty())
        report_.lost.push_back(
            core::joined({"the line '", line, "' of the ", what_, " ", g.name, ", which is no entry"}));
      if (key.empty() || key == "nFaces" || key == "startFace" || key == "cellLabels") continue;
      has_type = has_type || key == "type";
      g.lines.push_back(foam_line(key, value));
    }
    if (!has_type) g.lines.insert(g.lines.begin(), core::joined({"type ", type, ";"}));
  }

 public:
  std::vector<foam_group> all;

  foam_groups(save_report& report, const char* what) : report_(report), what_(what) {}

  /// The number of the group of a label; no_group if it has none.
  static constexpr std::size_t no_group = ~std::size_t{0};
  std::size_t find(int label) const {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), std::pair{label, 0u});
    return found != numbers_.end() && found->first == label ? found->second : no_group;
  }

  /// Makes the groups. `used` are the labels of elements. Elements with the label 0 belong to the group `unlabelled`,
  /// unless that is empty or the label has a name. `type` is that of groups whose lines have none.
  void make(const label_names* names, element_kind kind, std::vector<int> used, std::string_view unlabelled,
            std::string_view type) {
    for (const concino::label_name& n : names ? names->names : std::vector<concino::label_name>()) {
      if (n.kind != kind || find(n.label) != no_group) continue;
      add(n.label, n.name);
      add_lines(all.back(), n.lines, type);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto add_unnamed = [&](int label, std::string_view name) {
      add(label, name);
      add_lines(all.back(), {}, type);
    };
    for (const int label : used)
      if (label != 0 && find(label) == no_group) add_unnamed(label, core::joined({"label_", label}));
    if (!unlabelled.empty() && std::binary_search(used.begin(), used.end(), 0) && find(0) == no_group)
      add_unnamed(0, unlabelled);
  }

  /// Reports labels that read back as others.
  void report_numbers(std::string_view elements) const {
    std::string changed;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].label != 0 && all[i].label != static_cast<int>(i + 1))
        changed = core::joined({changed, changed.empty() ? "" : ", ", all[i].label, " as ", i + 1});
    if (!changed.empty())
      report_.notes.push_back(
          core::joined({"labels of ", elements, " are numbered anew when the file is read: ", changed}));
  }

  static void write_lines(text_sink& out, const foam_group& g) {
    for (const std::string& line : g.lines) {
      const std::size_t blank = std::min(line.find(' '), line.size());
      out << "        " << std::string_view(line).substr(0, blank);
      for (std::size_t k = blank; k < 16 && blank < line.size(); ++k) out << ' ';
      if (blank >= 16 && blank < line.size()) out << ' ';
      out << std::string_view(line).substr(std::min(blank + 1, line.size())) << '\n';
    }
  }
};

}  // namespace concino::detail
