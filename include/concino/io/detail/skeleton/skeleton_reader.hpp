// What the readers of curve skeletons have in common.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/message.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The contents of a file: edges may join a vert with itself, and be there more than once.
struct skeleton_contents {
  std::vector<vec3> points;
  std::vector<double> radii;  // empty if the file has none
  std::vector<std::array<vert_id, 2>> edges;
};

/// Drops edges from a vert to itself, and all but the first of equal edges. `both`: the file should list each edge once
/// from each end.
inline void drop_superfluous_edges(std::vector<std::array<vert_id, 2>>& edges, bool both, load_report& report) {
  struct entry {
    vert_id low, high;
    std::uint32_t index;
    bool operator<(const entry& o) const {
      return low != o.low ? low < o.low : high != o.high ? high < o.high : index < o.index;
    }
  };
  std::vector<entry> sorted;
  sorted.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    sorted.push_back(
        {std::min(edges[i][0], edges[i][1]), std::max(edges[i][0], edges[i][1]), static_cast<std::uint32_t>(i)});
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> is_superfluous(edges.size());
  std::uint64_t num_loops = 0, num_repeated = 0, num_from_one = 0;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    std::uint64_t num_upward = 0;
    for (end = first;
         end < sorted.size() && sorted[end].low == sorted[first].low && sorted[end].high == sorted[first].high; ++end) {
      num_upward += edges[sorted[end].index][0] == sorted[end].low;
      if (end != first) is_superfluous[sorted[end].index] = true;
    }
    const std::uint64_t n = end - first, num_downward = n - num_upward;
    if (sorted[first].low == sorted[first].high) {
      is_superfluous[sorted[first].index] = true;
      num_loops += n;
    } else if (both) {
      num_from_one += num_upward == 0 || num_downward == 0;
      num_repeated += n - std::min<std::uint64_t>(num_upward, 1) - std::min<std::uint64_t>(num_downward, 1);
    } else {
      num_repeated += n - 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (!is_superfluous[i]) edges[kept++] = edges[i];
  edges.resize(kept);
  if (num_loops) report.skipped.push_back(core::joined({num_loops, " edges from a vert to itself"}));
  if (num_repeated) report.skipped.push_back(core::joined({num_repeated, " edges that the file lists again"}));
  if (num_from_one)
    report.notes.push_back(core::joined({num_from_one, " edges are listed by one of their verts only"}));
}

/// Reads what all formats have in common.
class skeleton_reader : protected token_cursor {
 protected:
  skeleton_contents& out_;
  load_report& report_;

  static constexpr std::uint64_t max_edges = 0x7FFFFFFE;

  vec3 next_point() {
    const double x = next_real("the x of a vert"), y = next_real("the y of a vert");
    return {x, y, next_real("the z of a vert")};
  }
  void add_edge(std::uint64_t a, std::uint64_t b) {
    if (out_.edges.size() == max_edges) fail_to_count("edges");
    out_.edges.push_back({vert_id{a}, vert_id{b}});
  }
  void end_file(const char* what) {
    skip();
    if (!at_end())
      report_.skipped.push_back(core::joined({"what follows the last ", what, ", from line ", line_of(at), " on"}));
  }

 public:
  skeleton_reader(std::string_view text, std::string_view name, const concino::progress* progress, load_report& report,
                  skeleton_contents& out)
      : token_cursor(text_without_padding(text), name, progress, 0), out_(out), report_(report) {}
};

}  // namespace concino::detail
