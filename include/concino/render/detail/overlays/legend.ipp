// Bodies of legend.hpp: legends and titles of pictures: which colour means which value.
#pragma once

#include <concino/render/detail/colors/band_coverage.hpp>
#include <concino/render/detail/image/coverage.hpp>
#include <concino/render/detail/overlays/ticks.hpp>
#include <concino/render/label_colors.hpp>
#include <concino/render/legend.hpp>
#include <concino/render/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino {

namespace detail {

/// The parts of a legend and their places. Lengths are in sizes of letters, from the upper left corner, until fit()
/// makes them pixels.
class legend_layout {
  const appearance& look_;
  const legend_options& options_;
  std::string title_;
  std::vector<tick> ticks_;  // of labels: their numbers
  bool more_ = false;        // labels than there is room for
  double size_ = 1, bar_ = 0, head_ = 0, width_ = 0, height_ = 0;
  pixel_position corner_;

  static constexpr double swatch_ = 1.1, row_ = 1.5, gap_ = 0.55, margin_ = 1;

  void name_labels(double height) {
    std::size_t n = options_.labels.size(), first = 0;
    if (n == 0) {
      first = static_cast<std::size_t>(std::max(0.0, std::ceil(look_.scale.low())));
      const double last = std::floor(look_.scale.high());
      n = last < static_cast<double>(first)
              ? 0
              : static_cast<std::size_t>(std::min(last - static_cast<double>(first) + 1, 1e6));
    }
    const double most =
        std::max(3.0, (height / (options_.size > 0 ? options_.size : 10) - 2 * margin_ - head_) / row_ - 2);
    more_ = static_cast<double>(n) > most;
    if (more_) n = static_cast<std::size_t>(most);
    for (std::size_t k = 0; k < n; ++k)
      ticks_.push_back(
          {static_cast<double>(first + k), options_.labels.empty() ? std::to_string(first + k) : options_.labels[k]});
  }

  /// The lengths, with letters of size 1 and a bar of `bar`.
  void measure() {
    head_ = title_.empty() ? look_.labels ? 0 : 0.4
                           : 0.8 + 1.2 * static_cast<double>(1 + std::count(title_.begin(), title_.end(), '\n'));
    double text = 0;
    for (const tick& t : ticks_) text = std::max(text, text_width(t.text, 1));
    if (!options_.no_value.empty()) text = std::max(text, text_width(options_.no_value, 1));
    width_ = std::max(swatch_ + gap_ + text, title_.empty() ? 0 : text_width(title_, 1));
    height_ = head_ + (look_.labels ? row_ * static_cast<double>(ticks_.size() + more_) : bar_ + 0.5) +
              (options_.no_value.empty() ? 0 : 0.3 + row_);
  }

  void fit(double width, double height) {
    size_ = options_.size > 0 ? options_.size : std::max(10.0, height / 40);
    bar_ = look_.labels ? 0 : std::max(6.0, 0.5 * height / size_);
    measure();
    if (!look_.labels && (height_ + 2 * margin_) * size_ > height) {
      bar_ = std::max(6.0, bar_ - ((height_ + 2 * margin_) - height / size_));
      measure();
    }
    size_ = std::min({size_, width / (width_ + 2 * margin_), height / (height_ + 2 * margin_)});
    corner_.x = options_.place == legend_place::left ? margin_ * size_ : width - (margin_ + width_) * size_;
    corner_.y = (height - height_ * size_) / 2;
    if (size_ * margin_ < 1) return;
    // Sharp edges: the corner of the bar is that of a pixel.
    corner_.x = std::floor(corner_.x);
    corner_.y = std::floor(corner_.y + head_ * size_) - head_ * size_;
  }

  double x(double s) const { return corner_.x + s * size_; }
  double y(double s) const { return corner_.y + s * size_; }

  void draw_text_at(image& picture, const std::string& text, double left, double middle) const {
    draw_text(picture, text, {x(left), y(middle)},
              {.size = size_, .color = options_.color, .level = text_level::middle});
  }

  void draw_swatch(image& picture, const rgb& color, const std::string& text, double top) const {
    const pixel_box box{x(0), std::round(y(top)), std::round(x(swatch_)), std::round(y(top + swatch_))};
    fill_box(picture, box, color);
    outline(picture, box);
    draw_text_at(picture, text, swatch_ + gap_, top + swatch_ / 2);
  }

  void outline(image& picture, const pixel_box& b) const {
    const double w = std::max(1.0, std::round(size_ / 16));
    fill_box(picture, {b.left, b.top, b.right, b.top + w}, options_.color);
    fill_box(picture, {b.left, b.bottom - w, b.right, b.bottom}, options_.color);
    fill_box(picture, {b.left, b.top + w, b.left + w, b.bottom - w}, options_.color);
    fill_box(picture, {b.right - w, b.top + w, b.right, b.bottom - w}, options_.color);
  }

  rgb color_at(double t, double pixel) const {
    rgb c = look_.map(t);
    if (look_.isobands > 0) {
      const double width = std::min(1.0, std::max(0.0, look_.band_width));
      c = mix(c, {1, 1, 1}, static_cast<float>(band_coverage(t * look_.isobands, pixel * look_.isobands, width)));
    }
    if (look_.isolines > 0)
      c = mix(c, look_.isoline_color,
              static_cast<float>(line_coverage(t * look_.isolines, {0, pixel * look_.isolines}, look_.isoline_width)));
    return c;
  }

  void draw_bar(image& picture) const {
    const pixel_box box{x(0), std::round(y(head_)), std::round(x(swatch_)), std::round(y(head_ + bar_))};
    const double rows = box.height();
    for (double r = 0; r < rows; ++r)
      fill_box(picture, {box.left, box.top + r, box.right, box.top + r + 1}, color_at(1 - (r + 0.5) / rows, 1 / rows));
    outline(picture, box);
    double last = std::numeric_limits<double>::infinity();
    for (const tick& t : ticks_) {
      const double at = box.bottom - look_.scale(t.value) * rows;
      if (last - at < 1.1 * size_) continue;  // it would touch the number below
      last = at;
      const double w = std::max(1.0, std::round(size_ / 16)),
                   line = std::min(std::max(std::round(at - w / 2), box.top), box.bottom - w);
      fill_box(picture, {box.right, line, x(swatch_ + 0.3), line + w}, options_.color);
      draw_text(picture, t.text, {x(swatch_ + gap_), at},
                {.size = size_, .color = options_.color, .level = text_level::middle});
    }
  }

 public:
  legend_layout(std::size_t width, std::size_t height, const appearance& look, const legend_options& options,
                const char* what)
      : look_(look), options_(options) {
    if (!(options.size >= 0 && options.size <= 65535))
      core::throw_joined<invalid_argument>({what, ": size must be 0 to 65535"});
    if (options.ticks < 1 || options.ticks > 100)
      core::throw_joined<invalid_argument>({what, ": ticks must be 1 to 100"});
    title_ = options.title;
    if (!options.unit.empty()) ((title_ += title_.empty() ? "[" : " [") += options.unit) += "]";
    if (look.labels) name_labels(static_cast<double>(height));
    else ticks_ = round_ticks(look.scale, options.ticks);
    fit(static_cast<double>(width), static_cast<double>(height));
  }

  pixel_box box() const { return {corner_.x, corner_.y, x(width_), y(height_)}; }

  void draw(image& picture) const {
    if (!title_.empty())
      draw_text(picture, title_, {x(0), y(0.3)}, {.size = size_, .color = options_.color, .level = text_level::top});
    double top = head_;
    if (!look_.labels) {
      draw_bar(picture);
      top += bar_ + 0.5;
    } else
      for (const tick& t : ticks_) {
        draw_swatch(picture, label_color(static_cast<std::size_t>(t.value)), t.text, top);
        top += row_;
      }
    if (more_) draw_text_at(picture, "…", swatch_ + gap_, top + swatch_ / 2), top += row_;
    if (!options_.no_value.empty()) draw_swatch(picture, look_.no_value, options_.no_value, top + 0.3);
  }
};

}  // namespace detail

CONCINO_INLINE pixel_box draw_legend(image& picture, const appearance& look, const legend_options& options) {
  const detail::legend_layout layout(picture.width(), picture.height(), look, options, "draw_legend");
  if (picture.width() > 0) layout.draw(picture);
  return layout.box();
}

CONCINO_INLINE pixel_box legend_box(std::size_t width, std::size_t height, const appearance& look,
                                    const legend_options& options) {
  return detail::legend_layout(width, height, look, options, "legend_box").box();
}

CONCINO_INLINE pixel_box draw_title(image& picture, std::string_view title, const rgb& color) {
  if (picture.width() == 0) return {};
  const double width = static_cast<double>(picture.width()), wanted = static_cast<double>(picture.height()) / 24;
  const double length = text_width(title, 1),
               size = std::max(0.1, std::min(wanted, length > 0 ? (width - wanted) / length : wanted));
  return draw_text(picture, title, {width / 2, 0.6 * wanted},
                   {.size = size, .color = color, .align = text_align::middle, .level = text_level::top});
}

}  // namespace concino
