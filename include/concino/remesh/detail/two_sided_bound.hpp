// Whether edits keep a surface near the one that it was, and that one near it. It does not depend on the mesh type, so
// it is compiled once.
//
// A triangle of the input is near the result if each of its points is near one of the `parts` that are linked with it.
// An edit replaces parts; only the triangles linked with these are measured again, against what remains and what is
// new. All points are unit points.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/polygon_part.hpp>
#include <concino/geometry/support/triangle_tree.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// A triangle of the result, or an edge of its boundary: a, b, b.
struct surface_part {
  std::uint32_t id;
  triangle_points points;
};

/// The parts that an edit removes or moves, and those that it makes or moves.
struct part_change {
  std::vector<std::uint32_t> old;
  std::vector<surface_part> added;

  void clear() { old.clear(), added.clear(); }
};

class two_sided_bound {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct link {
    std::uint32_t item, part, next_of_item, next_of_part;
  };

  std::vector<triangle_points> items_, parts_;  // of the input, and of the result by id
  core::triangle_tree input_;
  double squared_limit_;
  std::vector<link> links_;  // lists of the links of each item and of each part
  std::vector<std::uint32_t> first_of_item_, first_of_part_;
  std::uint32_t free_ = none;
  // the edit that was asked about last
  part_change change_;
  std::vector<std::uint32_t> changed_items_;
  std::vector<link> new_links_;
  // working memory
  std::vector<core::polygon_part> stack_;
  std::vector<triangle_points> candidates_;
  std::vector<char> is_used_;

  template<class Triangles>
  bool is_near(const triangle_points& t, const Triangles& to, std::size_t guess, std::size_t max_cuts);
  void find_changed_items();
  bool item_is_near(std::uint32_t item);
  void add_link(std::uint32_t item, std::uint32_t part);
  void remove_links_of(std::uint32_t part);

 public:
  /// The parts of the input, which are those of the result before the first edit.
  two_sided_bound(std::span<const surface_part> input, double limit);

  /// Whether after the change all points of the new parts are near the input, and all points of the input near the
  /// result.
  bool stays_near(const part_change& change);
  /// The change that was asked about last has been made.
  void accept();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/remesh/detail/two_sided_bound.ipp>
#endif
