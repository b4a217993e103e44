// Defines hatch.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/print/detail/regions/contour_reader.hpp>
#include <concino/print/hatch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace concino::detail {

/// Fills a layer with lines along the x axis of a turned frame.
class hatcher {
  struct crossing {
    std::int64_t line;  // its height is (line + 1/2) * distance
    double x;
    std::uint32_t contour;
    std::int8_t turn;   // by how much the winding number of the contour is larger behind it

    bool operator<(const crossing& other) const { return line != other.line ? line < other.line : x < other.x; }
  };
  double distance_, cos_, sin_;
  std::vector<crossing> crossings_;
  std::vector<std::int8_t> weight_;  // by contour: 1 of outer ones, -1 of inner ones

  slice_point turned(const slice_point& p) const { return {cos_ * p[0] + sin_ * p[1], cos_ * p[1] - sin_ * p[0]}; }
  slice_point turned_back(double x, double y) const { return {cos_ * x - sin_ * y, sin_ * x + cos_ * y}; }
  double height(std::int64_t line) const { return (static_cast<double>(line) + 0.5) * distance_; }

  /// A point on a line counts as above it.
  void add_segment(const slice_point& a, const slice_point& b, std::uint32_t contour) {
    const slice_point &low = a[1] < b[1] ? a : b, &high = a[1] < b[1] ? b : a;
    auto line = static_cast<std::int64_t>(std::floor(low[1] / distance_ - 0.5));
    while (height(line) <= low[1]) ++line;
    for (; height(line) <= high[1]; ++line) {
      const double t = (height(line) - low[1]) / (high[1] - low[1]);
      crossings_.push_back(
          {line, low[0] + t * (high[0] - low[0]), contour, static_cast<std::int8_t>(a[1] < b[1] ? -1 : 1)});
    }
  }

 public:
  hatcher(double distance, double angle_deg) : distance_(distance) {
    // multiples of 90 are exact
    const double quarter = std::nearbyint(angle_deg / 90), rest = (angle_deg - 90 * quarter) * std::numbers::pi / 180;
    const double c = std::cos(rest), s = std::sin(rest);
    const int k = static_cast<int>(std::fmod(std::fmod(quarter, 4) + 4, 4));
    cos_ = k == 0 ? c : k == 1 ? -s : k == 2 ? -c : s;
    sin_ = k == 0 ? s : k == 1 ? c : k == 2 ? -s : -c;
  }

  void add(const slice_lines& lines, std::int8_t weight) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto contour = static_cast<std::uint32_t>(weight_.size());
      weight_.push_back(weight);
      const auto points = lines[i];
      for (std::size_t k = 0; k < points.size(); ++k)
        add_segment(turned(points[k]), turned(points[(k + 1) % points.size()]), contour);
    }
  }

  slice_lines segments() {
    std::sort(crossings_.begin(), crossings_.end());
    std::vector<slice_point> points;
    std::vector<std::pair<double, double>> on_line;
    std::unordered_map<std::uint32_t, int> winding;  // of the contours that wind around the place
    bool forward = true;
    for (std::size_t i = 0; i < crossings_.size();) {
      const std::int64_t line = crossings_[i].line;
      on_line.clear();
      winding.clear();
      int sum = 0;
      double begin = 0;
      for (; i < crossings_.size() && crossings_[i].line == line; ++i) {
        int& w = winding[crossings_[i].contour];
        const int before = sum, was_inside = w != 0;
        w += crossings_[i].turn;
        sum += weight_[crossings_[i].contour] * ((w != 0) - was_inside);
        if (before <= 0 && sum > 0) begin = crossings_[i].x;
        if (before > 0 && sum <= 0 && crossings_[i].x > begin) {
          if (!on_line.empty() && on_line.back().second == begin) on_line.back().second = crossings_[i].x;
          else on_line.push_back({begin, crossings_[i].x});
        }
      }
      if (!forward) std::reverse(on_line.begin(), on_line.end());
      for (const auto& [from, to] : on_line) {
        points.push_back(turned_back(forward ? from : to, height(line)));
        points.push_back(turned_back(forward ? to : from, height(line)));
      }
      if (!on_line.empty()) forward = !forward;
    }
    slice_lines result;
    if (!points.empty()) result.push_back(points);
    return result;
  }
};

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE slice_lines hatch(const slice_layer& layer, double distance, double angle_deg) {
  if (!(distance > 0) || !std::isfinite(distance))
    core::throw_joined<invalid_argument>(
        {"hatch: distance is ", core::number_text(distance), "; it must be finite and above 0"});
  if (!(std::abs(angle_deg) <= 1e6))
    core::throw_joined<invalid_argument>(
        {"hatch: angle_deg is ", core::number_text(angle_deg), "; it must be at most 1e6"});
  detail::planar_box around;
  detail::add_layer("hatch", layer, detail::single_layer, around);
  if (around.is_empty()) return {};
  double far = 0;
  for (const std::size_t k : {0u, 1u}) far = std::max({far, std::abs(around.min[k]), std::abs(around.max[k])});
  if (std::hypot(around.max[0] - around.min[0], around.max[1] - around.min[1]) / distance > 1e8 ||
      far / distance > 1e15)
    core::throw_joined<invalid_argument>(
        {"hatch: distance ", core::number_text(distance), " is too small for the size of the layer"});
  detail::hatcher h(distance, angle_deg);
  h.add(layer.outer, 1);
  h.add(layer.inner, -1);
  return h.segments();
}

}  // namespace concino
