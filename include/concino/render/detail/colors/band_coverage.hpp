// Anti-aliasing of bands and lines at equal distances, exact for a sample of any width.
#pragma once

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// The change of a quantity from one sample of the picture to the next one to the right, and to the next one above.
struct sample_step {
  double right = 0, up = 0;

  double length() const { return std::hypot(right, up); }
  double larger() const { return std::max(std::abs(right), std::abs(up)); }
  friend sample_step operator*(const sample_step& s, double factor) { return {s.right * factor, s.up * factor}; }
};

/// The fraction of [x - w/2, x + w/2] that lies in bands of width `band` about 1/2, 3/2, 5/2 ...
inline double band_coverage(double x, double w, double band) {
  const auto integral = [&](double t) {
    const double whole = std::floor(t);
    return whole * band + std::min(std::max(t - whole - (0.5 - band / 2), 0.0), band);
  };
  if (!(w < 1e3)) return band;
  w = std::max(w, 1e-9);
  return std::min(1.0, std::max(0.0, (integral(x + w / 2) - integral(x - w / 2)) / w));
}

/// How much of a sample is covered by lines at 1/2, 3/2, 5/2 ... of x, which are `samples` samples wide. Where lines
/// are close they cover half of the surface.
inline double line_coverage(double x, const sample_step& step, double samples) {
  const double width = step.length();
  if (!(width > 0)) return 0;
  return band_coverage(x, width, std::min(0.5, samples * width));
}

}  // namespace concino::detail
