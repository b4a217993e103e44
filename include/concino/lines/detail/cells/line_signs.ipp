// Bodies of line_signs.hpp: on which side of a line along a field points lie, by exact signs.
#pragma once

#include <concino/core/expansion.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

namespace concino::detail {

CONCINO_INLINE signed_value exact_line_sign(const vec3& g, const vec3& a, const vec3& ax, const vec3& b,
                                            const vec3& bx) {
  const core::expansion<2> ux = core::difference(a.x, ax.x), uy = core::difference(a.y, ax.y),
                           uz = core::difference(a.z, ax.z);
  const core::expansion<2> wx = core::difference(b.x, bx.x), wy = core::difference(b.y, bx.y),
                           wz = core::difference(b.z, bx.z);
  const auto minor = [](const core::expansion<2>& p, const core::expansion<2>& q, const core::expansion<2>& r,
                        const core::expansion<2>& s,
                        double factor) { return product(sum(product(p, q), minus(product(r, s))), factor); };
  const auto det = sum(sum(minor(uy, wz, uz, wy, g.x), minor(uz, wx, ux, wz, g.y)), minor(ux, wy, uy, wx, g.z));
  const int sign = det.sign();
  if (sign == 0) return {};
  double value = 0;
  for (std::size_t i = 0; i < det.size; ++i) value += det.part[i];
  return {sign * std::max(std::abs(value), std::numeric_limits<double>::min()), sign};
}

}  // namespace concino::detail
