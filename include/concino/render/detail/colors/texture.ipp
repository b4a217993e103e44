// Bodies of texture.hpp: textures: colours that depend on two coordinates, such as a checkerboard, lines, or a picture.
#pragma once

#include <concino/render/detail/colors/band_coverage.hpp>
#include <concino/render/texture.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

namespace detail {

inline constexpr int max_texture_probes = 8;  // along the longer axis of a sample

CONCINO_INLINE void need_positive(double x, const char* what) {
  if (!(x > 0) || !std::isfinite(x))
    core::throw_joined<invalid_argument>({"texture: ", what, " must be positive and finite"});
}

/// The picture of half the size, each pixel the mean of up to four.
CONCINO_INLINE image half_size(const image& from) {
  image to((from.width() + 1) / 2, (from.height() + 1) / 2);
  if (from.has_opacity()) to.add_opacity();
  for (std::size_t y = 0; y < to.height(); ++y)
    for (std::size_t x = 0; x < to.width(); ++x) {
      const std::size_t right = std::min(2 * x + 1, from.width() - 1), below = std::min(2 * y + 1, from.height() - 1);
      to(x, y) = (from(2 * x, 2 * y) + from(right, 2 * y) + from(2 * x, below) + from(right, below)) * 0.25f;
      if (to.has_opacity())
        to.opacity(x, y) = 0.25f * (from.opacity(2 * x, 2 * y) + from.opacity(right, 2 * y) +
                                    from.opacity(2 * x, below) + from.opacity(right, below));
    }
  return to;
}

/// The colour at (u, v), interpolated between four pixels.
CONCINO_INLINE texture_color between_pixels(const image& picture, double u, double v, texture::outside border) {
  const bool repeats = border == texture::outside::repeat;
  const auto reduced = [&](double t) { return repeats ? t - std::floor(t) : std::min(2.0, std::max(-1.0, t)); };
  const double x = reduced(u) * static_cast<double>(picture.width()) - 0.5,
               y = (1 - reduced(v)) * static_cast<double>(picture.height()) - 0.5;
  const double left = std::floor(x), above = std::floor(y);
  const auto index = [&](double i, std::size_t n) {
    const auto size = static_cast<std::int64_t>(n), at = static_cast<std::int64_t>(i);
    return static_cast<std::size_t>(repeats ? (at % size + size) % size : std::clamp<std::int64_t>(at, 0, size - 1));
  };
  const std::size_t columns[2] = {index(left, picture.width()), index(left + 1, picture.width())};
  const std::size_t rows[2] = {index(above, picture.height()), index(above + 1, picture.height())};
  const float fx = static_cast<float>(x - left), fy = static_cast<float>(y - above);
  texture_color sum;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const float weight = (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
      sum.color += picture(columns[i], rows[j]) * weight;
      sum.cover += picture.opacity(columns[i], rows[j]) * weight;
    }
  return sum;
}

CONCINO_INLINE texture_color mix(const texture_color& a, const texture_color& b, float t) {
  return {mix(a.color, b.color, t), a.cover * (1 - t) + b.cover * t};
}

}  // namespace detail

CONCINO_INLINE texture texture::checkerboard(double squares, const rgb& first, const rgb& second) {
  detail::need_positive(squares, "squares");
  texture t;
  t.kind_ = kind::checkerboard;
  t.count_ = squares;
  t.first_ = first;
  t.second_ = second;
  return t;
}

CONCINO_INLINE texture texture::isolines(double lines, const rgb& color, double width) {
  detail::need_positive(lines, "lines");
  detail::need_positive(width, "width");
  texture t;
  t.kind_ = kind::isolines;
  t.count_ = lines;
  t.width_ = width;
  t.first_ = color;
  return t;
}

CONCINO_INLINE texture texture::from(const image& picture, outside border) {
  if (picture.width() == 0) throw invalid_argument("texture: the picture has no pixels");
  std::vector<image> levels{picture};
  image& first = levels.front();
  if (first.has_opacity())
    for (std::size_t y = 0; y < first.height(); ++y)
      for (std::size_t x = 0; x < first.width(); ++x) first(x, y) *= first.opacity(x, y);
  while (levels.back().width() > 1 || levels.back().height() > 1) levels.push_back(detail::half_size(levels.back()));
  texture t;
  t.kind_ = kind::picture;
  t.border_ = border;
  t.levels_ = std::make_shared<const std::vector<image>>(std::move(levels));
  return t;
}

CONCINO_INLINE texture_color texture::of_picture(double u, double v, const texture_steps& s) const {
  const double width = static_cast<double>(levels_->front().width()),
               height = static_cast<double>(levels_->front().height());
  // in pixels of the texture
  const double right = std::hypot(s.u_right * width, s.v_right * height),
               up = std::hypot(s.u_up * width, s.v_up * height);
  const std::size_t last = levels_->size() - 1;
  if (!std::isfinite(right) || !std::isfinite(up)) return detail::between_pixels(levels_->back(), u, v, border_);
  const bool along_right = right >= up;
  const double longer = std::max(right, up),
               shorter = std::max({1.0, std::min(right, up), longer / detail::max_texture_probes});
  const int probes =
      std::max(1, static_cast<int>(std::ceil(std::min<double>(longer / shorter, detail::max_texture_probes))));
  const double level = std::min(std::log2(shorter), static_cast<double>(last));
  const std::size_t finer = static_cast<std::size_t>(level), coarser = std::min(finer + 1, last);
  const float part = static_cast<float>(level - static_cast<double>(finer));
  texture_color sum;
  for (int i = 0; i < probes; ++i) {
    const double offset = (i + 0.5) / probes - 0.5;
    const double x = u + offset * (along_right ? s.u_right : s.u_up),
                 y = v + offset * (along_right ? s.v_right : s.v_up);
    texture_color c = detail::between_pixels((*levels_)[finer], x, y, border_);
    if (part > 0) c = detail::mix(c, detail::between_pixels((*levels_)[coarser], x, y, border_), part);
    sum.color += c.color * (1 / static_cast<float>(probes));
    sum.cover += c.cover / static_cast<float>(probes);
  }
  return sum;
}

CONCINO_INLINE texture_color texture::operator()(double u, double v, const texture_steps& s) const {
  if (kind_ == kind::none || !std::isfinite(u) || !std::isfinite(v)) return {};
  if (kind_ == kind::picture) return of_picture(u, v, s);
  const detail::sample_step du{s.u_right * count_, s.u_up * count_}, dv{s.v_right * count_, s.v_up * count_};
  if (kind_ == kind::isolines) {
    const double samples = width_ * s.samples_per_pixel;
    const double free = (1 - detail::line_coverage(u * count_ + 0.5, du, samples)) *
                        (1 - detail::line_coverage(v * count_ + 0.5, dv, samples));
    const float cover = static_cast<float>(1 - free);
    return {first_ * cover, cover};
  }
  // The mean of a product is the product of means: 1 in the even intervals of a coordinate, -1 in the odd ones.
  const auto sign = [](double t, const detail::sample_step& step) {
    return 2 * detail::band_coverage(t / 2 + 0.25, step.larger() / 2, 0.5) - 1;
  };
  const double share = (1 - sign(u * count_, du) * sign(v * count_, dv)) / 2;
  return {mix(first_, second_, static_cast<float>(share)), 1};
}

}  // namespace concino
