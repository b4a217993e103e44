// The nodes of elements of second or higher order that are read by their corners.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/file_contents.hpp>

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// What to do about elements of second or higher order, for messages.
inline constexpr std::string_view read_corners_instead = "load with {.corners_only = true} to read only the corners";

/// Collects the nodes that are no corners, and removes them from the contents of a file.
class element_nodes {
  std::vector<bool> is_node_;  // of the verts up to the last one
  std::uint64_t num_elements_ = 0;

 public:
  /// Adds an element with n nodes besides its corners.
  void add(const vert_id* nodes, std::size_t n) {
    ++num_elements_;
    for (std::size_t k = 0; k < n; ++k) {
      if (nodes[k].raw() >= is_node_.size()) is_node_.resize(nodes[k].raw() + std::size_t{1});
      is_node_[nodes[k].raw()] = true;
    }
  }

  /// Whether an element was added.
  bool any() const { return num_elements_ > 0; }

  /// Removes the points that are nodes and no corner of any element.
  /// Needs:  complete contents, whose values of verts can be copied byte by byte.
  template<class Contents>
  void remove(Contents& out, load_report& report) {
    if (num_elements_ == 0) return;
    std::vector<vec3>& points = points_of(out);
    is_node_.resize(points.size());
    for_each_list(out, [&](std::vector<vert_id>& verts) {
      for (const vert_id v : verts) is_node_[v.raw()] = false;
    });
    std::vector<std::uint32_t> number(points.size()), kept;
    for (std::size_t v = 0; v < points.size(); ++v) {
      number[v] = static_cast<std::uint32_t>(kept.size());
      if (!is_node_[v]) kept.push_back(static_cast<std::uint32_t>(v));
    }
    report.skipped.push_back(core::joined({points.size() - kept.size(), " points, the nodes of ", num_elements_,
                                           " elements of second or higher order: only corners were read"}));
    for_each_list(out, [&](std::vector<vert_id>& verts) {
      for (vert_id& v : verts) v = vert_id{number[v.raw()]};
    });
    keep(points, kept, points.size());
    keep(out.vert_labels, kept, out.vert_labels.size());
    keep(out.vert_colors, kept, out.vert_colors.size());
    keep(out.vert_normals, kept, out.vert_normals.size());
    keep(out.vert_textures, kept, out.vert_textures.size());
    for (property_column& c : out.properties)
      if (c.kind == element_kind::vert) keep_values(*c.values, kept);
  }

 private:
  template<class Contents>
  static std::vector<vec3>& points_of(Contents& out) {
    if constexpr (std::is_same_v<Contents, volume_contents>) {
      if (out.filled == arrays_kind::cells) return out.cells.points;
      if (out.filled == arrays_kind::polyhedra) return out.polyhedra.points;
    }
    return out.surface.points;
  }
  /// Calls f for each list of verts.
  template<class Contents, class F>
  static void for_each_list(Contents& out, const F& f) {
    f(out.surface.verts), f(out.edges.verts), f(out.faces.verts);
    if constexpr (std::is_same_v<Contents, volume_contents>) f(out.cells.verts), f(out.polyhedra.face_verts);
  }
  /// Keeps only these of n values, if there are any.
  template<class Values>
  static void keep(Values& values, const std::vector<std::uint32_t>& kept, std::size_t n) {
    if (n == 0) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
  }
  static void keep_values(column& values, const std::vector<std::uint32_t>& kept) {
    const std::size_t size = values.operations().size;
    auto* const bytes = static_cast<unsigned char*>(values.data());
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i] != i) std::memcpy(bytes + i * size, bytes + kept[i] * size, size);
    values.resize(kept.size());
  }
};

}  // namespace concino::detail
