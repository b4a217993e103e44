// The list of points of a .node file, or of a .smesh or .poly file: coordinates, attributes, a marker.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/detail/tetgen/tetgen_cursor.hpp>
#include <concino/io/file_contents.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Numbers of elements, in columns "attribute_1", "attribute_2", ...
class tetgen_attributes {
  std::vector<std::vector<double>> columns_;

 public:
  std::size_t size() const { return columns_.size(); }

  /// Reads how many attributes n elements have, from the first row of a list; none if the row ends before it.
  void read_number(tetgen_cursor& in, std::uint64_t n) {
    if (!in.row_goes_on()) return;
    constexpr std::int64_t max_columns = 4096;  // so that a wrong number takes little memory
    const char* const from = in.at;
    const std::int64_t number = in.integer_of_row("the number of attributes");
    if (number < 0 || number > max_columns)
      in.fail(from, {"the number of attributes, from 0 to ", static_cast<std::uint64_t>(max_columns)});
    if (n > 0) columns_.resize(static_cast<std::size_t>(number));
  }
  void add(std::size_t column, double x) { columns_[column].push_back(x); }
  /// Removes the first column.
  std::vector<double> take_first() {
    std::vector<double> first = std::move(columns_.front());
    columns_.erase(columns_.begin());
    return first;
  }
  void store(element_kind kind, file_contents& out) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const std::vector<double>& values = columns_[k];
      double* const to = out.add_property<double>(kind, core::joined({"attribute_", k + 1}), values.size());
      for (std::size_t i = 0; i < values.size(); ++i) to[i] = values[i];
    }
  }
};

class tetgen_nodes {
  tetgen_attributes attributes_;
  std::vector<int> labels_;
  bool has_markers_ = false;

 public:
  std::vector<vec3> points;
  std::uint32_t first = 0;  // the number of the first point, 0 or 1

  /// Reads the first row: the numbers of points, dimensions, attributes and markers.      Result: that of points.
  std::uint64_t read_header(tetgen_cursor& in) {
    attributes_ = {};
    if (!in.next_row()) in.fail(in.at, "the number of points");
    const std::uint64_t n = in.count_of_row("the number of points", 8);
    if (in.row_goes_on()) {
      const char* const from = in.at;
      const std::int64_t dimension = in.integer_of_row("the dimension, 3");
      if (dimension == 2)
        core::throw_joined<unsupported>(
            {in.name(), ": its points have two coordinates, as in files of the program Triangle; three are needed"});
      if (dimension != 3) in.fail(from, "the dimension, 3");
    }
    attributes_.read_number(in, n);
    has_markers_ = in.flag_of_row("the number of markers, 0 or 1");
    in.end_row();
    return n;
  }

  /// Reads the rows of n points.
  void read_rows(tetgen_cursor& in, std::uint64_t n) {
    points.reserve(in.reservable(n, 8));
    for (std::uint64_t i = 0; i < n; ++i) {
      if (!in.next_row()) in.fail(in.at, "the number of a point");
      const char* const from = in.at;
      const std::int64_t number = in.integer_of_row("the number of a point");
      if (i == 0 && number != 0 && number != 1) in.fail(from, "the number of the first point, 0 or 1");
      if (i == 0) first = static_cast<std::uint32_t>(number);
      if (number != static_cast<std::int64_t>(i + first)) in.fail(from, {"the number of the point, ", i + first});
      vec3 p;
      p.x = in.real_of_row("the x of a point");
      p.y = in.real_of_row("the y of a point");
      p.z = in.real_of_row("the z of a point");
      points.push_back(p);
      for (std::size_t k = 0; k < attributes_.size(); ++k)
        attributes_.add(k, in.real_of_row("an attribute of the point"));
      if (has_markers_) labels_.push_back(in.marker_of_row("the marker of the point, an integer"));
      in.end_row();
    }
  }

  /// Moves the values of the points into the contents.
  void store_values(file_contents& out) {
    out.vert_labels = std::move(labels_);
    attributes_.store(element_kind::vert, out);
  }
};

}  // namespace concino::detail
