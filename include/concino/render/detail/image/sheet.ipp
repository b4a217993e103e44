// Bodies of sheet.hpp: several pictures as one, in rows and columns, with a line of text under each.
#pragma once

#include <concino/render/sheet.hpp>
#include <concino/render/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace concino {

namespace detail {

/// Where the cells of a sheet are.
struct sheet_layout {
  std::vector<std::size_t> widths, heights;  // of columns and rows, without captions
  std::size_t gap, title = 0, caption = 0;   // pixels
  double size = 0;                           // of letters

  sheet_layout(std::span<const image> pictures, const sheet_options& o) : gap(o.gap) {
    const auto count = static_cast<double>(pictures.size());
    double width = 0, height = 0;
    for (const image& p : pictures) {
      width = std::max(width, static_cast<double>(p.width()));
      height = std::max(height, static_cast<double>(p.height()));
    }
    const double square = std::min(count, std::max(1.0, std::round(std::sqrt(count * height / width))));
    const std::size_t columns = o.columns > 0 ? std::min(o.columns, pictures.size()) : static_cast<std::size_t>(square);
    widths.assign(columns, 0);
    heights.assign((pictures.size() + columns - 1) / columns, 0);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      widths[i % columns] = std::max(widths[i % columns], pictures[i].width());
      heights[i / columns] = std::max(heights[i / columns], pictures[i].height());
    }
    size = o.size > 0 ? o.size : std::max(10.0, height / 20);
    const auto lines = [](const std::string& s) { return 1 + std::count(s.begin(), s.end(), '\n'); };
    std::ptrdiff_t most = 0;
    for (const std::string& s : o.captions)
      if (!s.empty()) most = std::max(most, lines(s));
    const auto room = [](std::ptrdiff_t n, double letters) {
      return static_cast<std::size_t>(std::ceil((1.2 * static_cast<double>(n) + 0.3) * letters));
    };
    if (most > 0) caption = room(most, size);
    if (!o.title.empty()) title = room(lines(o.title), 1.6 * size);
  }

  static std::size_t sum(const std::vector<std::size_t>& v, std::size_t n) {
    return std::accumulate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n), std::size_t{0});
  }
  std::size_t left(std::size_t column) const { return sum(widths, column) + (column + 1) * gap; }
  std::size_t top(std::size_t row) const { return title + sum(heights, row) + row * caption + (row + 1) * gap; }
  std::size_t width() const { return left(widths.size()); }
  std::size_t height() const { return top(heights.size()); }
};

inline void lay_picture(image& sheet, const image& picture, std::size_t left, std::size_t top) {
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) {
      rgb& to = sheet(left + x, top + y);
      to = sheet.has_opacity() ? picture(x, y) : mix(to, picture(x, y), picture.opacity(x, y));
      if (sheet.has_opacity()) sheet.opacity(left + x, top + y) = picture.opacity(x, y);
    }
}

/// A text in the middle of a strip, smaller if it is wider.
inline void draw_caption(image& sheet, const std::string& text, double left, double width, double top, double size,
                         const rgb& color) {
  if (text.empty()) return;
  const double length = text_width(text, 1);
  if (length > 0) size = std::min(size, width / length);
  draw_text(sheet, text, {left + width / 2, top + 0.35 * size},
            {.size = size, .color = color, .align = text_align::middle, .level = text_level::top});
}

}  // namespace detail

CONCINO_INLINE image make_sheet(std::span<const image> pictures, const sheet_options& options) {
  if (pictures.empty()) throw invalid_argument("make_sheet: there is no picture");
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (pictures[i].width() == 0) core::throw_joined<invalid_argument>({"make_sheet: picture ", i, " has no pixels"});
  if (options.captions.size() > pictures.size())
    core::throw_joined<invalid_argument>(
        {"make_sheet: ", options.captions.size(), " captions for ", pictures.size(), " pictures"});
  if (!(options.size >= 0 && options.size <= 65535)) throw invalid_argument("make_sheet: size must be 0 to 65535");
  if (options.gap > 65535) throw invalid_argument("make_sheet: gap must be at most 65535 pixels");
  const detail::sheet_layout layout(pictures, options);
  if (layout.width() > 65535 || layout.height() > 65535)
    core::throw_joined<invalid_argument>({"make_sheet: the sheet would have ", layout.width(), " x ", layout.height(),
                                          " pixels, more than 65535 along an axis"});
  image sheet(layout.width(), layout.height(), options.background);
  if (std::all_of(pictures.begin(), pictures.end(), [](const image& p) { return p.has_opacity(); }))
    sheet.add_opacity(0);
  const std::size_t columns = layout.widths.size();
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t column = i % columns, row = i / columns, width = layout.widths[column],
                      height = layout.heights[row];
    detail::lay_picture(sheet, pictures[i], layout.left(column) + (width - pictures[i].width()) / 2,
                        layout.top(row) + (height - pictures[i].height()) / 2);
    if (i < options.captions.size())
      detail::draw_caption(sheet, options.captions[i], static_cast<double>(layout.left(column)),
                           static_cast<double>(width), static_cast<double>(layout.top(row) + height), layout.size,
                           options.color);
  }
  const double border = static_cast<double>(options.gap), inner = static_cast<double>(layout.width()) - 2 * border;
  detail::draw_caption(sheet, options.title, border, inner, border, 1.4 * layout.size, options.color);
  return sheet;
}

}  // namespace concino
