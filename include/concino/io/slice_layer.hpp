// Slices of a part for layered manufacturing: layers of contours, open lines and hatches. <concino/io/slices.hpp> reads
// and writes them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// A point in the plane of a layer, in mm.
using slice_point = std::array<double, 2>;

/// Lines of one kind in a layer. All their points are in one array: line i begins where line i - 1 ends, and ends
/// before ends[i].
///
///   for (std::size_t i = 0; i < layer.outer.size(); ++i)
///     for (const slice_point& p : layer.outer[i]) ...
struct slice_lines {
  std::vector<slice_point> points;
  std::vector<std::size_t> ends;
  std::vector<std::int32_t> ids;  // of each line; slices::label_of names the part that a line belongs to

  std::size_t size() const { return ends.size(); }
  bool empty() const { return ends.empty(); }
  std::span<const slice_point> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return {points.data() + begin, ends[i] - begin};
  }
  void push_back(std::span<const slice_point> line, std::int32_t id = 0) {
    points.insert(points.end(), line.begin(), line.end());
    ends.push_back(points.size());
    ids.push_back(id);
  }

  friend bool operator==(const slice_lines&, const slice_lines&) = default;
};

/// One layer. Closed contours do not repeat their first point at the end.
struct slice_layer {
  double z = 0;         // in mm
  slice_lines outer;    // closed contours around material, counter-clockwise
  slice_lines inner;    // closed contours around holes, clockwise
  slice_lines open;     // open lines, such as supports
  slice_lines hatches;  // groups of segments: points 2k and 2k + 1 are the ends of segment k

  friend bool operator==(const slice_layer&, const slice_layer&) = default;
};

/// The name of the lines with this id.
struct slice_label {
  std::int32_t id = 0;
  std::string text;

  friend bool operator==(const slice_label&, const slice_label&) = default;
};

/// The layers of one or more parts, in the order of the file. All lengths are in mm; files hold numbers of `units`.
struct slices {
  double units = 1;                                // mm for 1 in the file; > 0
  std::optional<std::int64_t> version;             // of the format, times 100
  std::string date;                                // as in the file, usually ddmmyy
  std::optional<std::array<double, 6>> dimension;  // as in the file: the corners x, y, z, x, y, z of a box around the
                                                   // parts
  std::vector<slice_label> labels;
  std::vector<slice_layer> layers;

  /// The text of the first label with this id; empty if there is none.
  std::string_view label_of(std::int32_t id) const {
    for (const slice_label& l : labels)
      if (l.id == id) return l.text;
    return {};
  }

  friend bool operator==(const slices&, const slices&) = default;
};

}  // namespace concino
