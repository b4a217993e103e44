// Defines best_build_direction.hpp. The cost without supports is a lower bound of the cost, and much faster to compute:
// supports are only measured where that bound is lower than the best cost so far.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/print/best_build_direction.hpp>
#include <concino/print/detail/supports/overhang_search.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

/// The principal axes of the area, as columns; the identity if they cannot be computed.
inline std::array<vec3, 3> principal_axes(const part_surface& part) {
  vec3 mean;
  double area = 0;
  std::vector<double> sizes(part.triangles.size());
  for (std::size_t t = 0; t < sizes.size(); ++t) {
    const auto [a, b, c] = part.triangle(t);
    sizes[t] = 0.5 * norm(cross(b - a, c - a));
    mean += sizes[t] / 3 * (a + b + c);
    area += sizes[t];
  }
  mean /= area;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t t = 0; t < sizes.size(); ++t) {
    const auto [a, b, c] = part.triangle(t);
    for (const vec3& x : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {  // exact for polynomials of degree 2
      const Eigen::Vector3d y(x.x - mean.x, x.y - mean.y, x.z - mean.z);
      moments += sizes[t] / 3 * y * y.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  if (solver.info() != Eigen::Success) return {vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::array<vec3, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d e = solver.eigenvectors().col(static_cast<Eigen::Index>(k));
    axes[k] = {e[0], e[1], e[2]};
  }
  return axes;
}

/// The directions in which faces of the convex hull lie on the plate, those of large faces first.
inline std::vector<vec3> hull_directions(const part_surface& part, std::size_t max_count) {
  const convex_hull_result hull = convex_hull(part.points);
  std::vector<vec3> areas;
  for (std::size_t p = 0; p < hull.surface.num_polys(); ++p) {
    vec3 doubled;
    const std::uint32_t first = hull.surface.offsets[p];
    const auto at = [&](std::uint32_t i) {
      return hull.surface.points[hull.surface.verts[i].raw()] - hull.surface.points[hull.surface.verts[first].raw()];
    };
    for (std::uint32_t i = first + 2; i < hull.surface.offsets[p + 1]; ++i) doubled += cross(at(i - 1), at(i));
    if (norm(doubled) > part.tolerance * part.tolerance) areas.push_back(doubled);
  }
  const auto larger = [](const vec3& a, const vec3& b) { return norm(a) > norm(b); };
  std::stable_sort(areas.begin(), areas.end(), larger);
  std::vector<vec3> units, sums;  // of faces that are nearly parallel: the normal of the largest, and the sum
  for (const vec3& a : areas) {
    const vec3 unit = a / norm(a);
    std::size_t i = 0;
    while (i < units.size() && distance(units[i], unit) > 1e-3) ++i;
    if (i < units.size()) {
      sums[i] += a;
    } else if (i < max_count) {
      units.push_back(unit);
      sums.push_back(a);
    }
  }
  std::stable_sort(sums.begin(), sums.end(), larger);
  for (vec3& s : sums) s = -s / norm(s);
  return sums;
}

/// 24 n^2 + 2 directions, mirror images of one another in the planes between the axes.
inline std::vector<vec3> lattice_directions(const std::array<vec3, 3>& axes, int n) {
  std::vector<vec3> directions;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k) {
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) < n) continue;
        const vec3 d = i * axes[0] + j * axes[1] + k * axes[2];
        directions.push_back(d / norm(d));
      }
  return directions;
}

class build_direction_search {
  struct candidate {
    build_direction_found found;  // without supports at first
    overhang_figures figures;
    std::size_t rank = 0;
  };
  static constexpr double noise = 1e-9;  // costs are about 1; what differs by less is equally good

  const part_surface& part_;
  const build_direction_options& options_;
  double area_ = 0;

  candidate without_supports(const vec3& direction) const {
    candidate c;
    c.figures = find_overhangs(part_, direction, {options_.max_angle_deg, {}, options_.plate_tolerance},
                               "best_build_direction");
    const double cost = options_.overhang_weight * c.figures.area / area_ +
                        options_.height_weight * c.figures.height / std::sqrt(area_) +
                        options_.plate_weight * (1 - c.figures.plate_area / area_);
    c.found = {direction, cost, c.figures.area, 0, c.figures.plate_area, c.figures.height};
    return c;
  }
  void add_supports(candidate& c) const {
    c.found.support_volume = supports_below(part_, c.found.direction, c.figures).volume;
    c.found.cost += options_.support_weight * c.found.support_volume / (area_ * std::sqrt(area_));
    c.figures.polygons = {};
  }

  /// Moves to the best of eight neighbours while that lowers the cost, with ever smaller angles.
  void improve(candidate& best, const std::array<vec3, 3>& axes) const {
    constexpr double pi = 3.14159265358979323846;
    double angle = 45 / static_cast<double>(options_.samples);
    while (angle >= options_.accuracy_deg) {
      const vec3 d = best.found.direction;
      std::size_t axis = 0;
      for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(dot(d, axes[k])) < std::abs(dot(d, axes[axis]))) axis = k;
      vec3 u = axes[axis] - dot(axes[axis], d) * d;
      u /= norm(u);
      const vec3 v = cross(d, u);
      const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
      bool improved = false;
      for (int k = 0; k < 8; ++k) {
        const vec3 moved = c * d + s * (std::cos(k * pi / 4) * u + std::sin(k * pi / 4) * v);
        candidate next = without_supports(moved / norm(moved));
        if (next.found.cost >= best.found.cost - noise) continue;
        add_supports(next);
        if (next.found.cost >= best.found.cost - noise) continue;
        best = std::move(next);
        improved = true;
      }
      if (!improved) angle /= 2;
    }
  }

  void report(double fraction) const { report_progress(options_.progress, fraction, "best build direction"); }

  /// The candidates with the lowest costs, best first; of equally good ones only the first.
  std::vector<candidate> cheapest(const std::vector<vec3>& directions, std::size_t count, double done) const {
    std::vector<candidate> all(directions.size());
    parallel_for(all.size(), [&](std::size_t i) {
      all[i] = without_supports(directions[i]);
      all[i].rank = i;
      all[i].figures = {};  // found again where it is needed: it would be large for all
    }, 4);
    report(done);
    std::stable_sort(all.begin(), all.end(),
                     [](const candidate& a, const candidate& b) { return a.found.cost < b.found.cost; });
    std::vector<candidate> best;
    for (candidate& next : all) {
      if (best.size() == count && next.found.cost > best.back().found.cost + noise) break;
      const std::size_t rank = next.rank;
      candidate c = without_supports(next.found.direction);
      c.rank = rank;
      add_supports(c);
      // Mirror images have equal costs; one of them is enough to start from.
      const auto same = std::find_if(
          best.begin(), best.end(), [&](const candidate& b) { return std::abs(c.found.cost - b.found.cost) <= noise; });
      if (same != best.end()) {
        if (c.rank < same->rank) *same = std::move(c);
      } else {
        best.insert(
            std::find_if(best.begin(), best.end(), [&](const candidate& b) { return c.found.cost < b.found.cost; }),
            std::move(c));
        if (best.size() > count) best.pop_back();
      }
      report(done);
    }
    return best;
  }

 public:
  build_direction_search(const part_surface& part, const build_direction_options& options)
      : part_(part), options_(options) {
    for (const vec3& a : part.areas) area_ += norm(a);
  }

  build_direction_found operator()() const {
    report(0);
    const auto axes = principal_axes(part_);
    std::vector<candidate> starts = cheapest(hull_directions(part_, options_.max_hull_faces), 2, 0.2);
    for (candidate& c : cheapest(lattice_directions(axes, static_cast<int>(options_.samples)), 6, 0.4))
      starts.push_back(std::move(c));
    build_direction_found best;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      report(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(starts.size()));
      improve(starts[i], axes);
      if (i == 0 || starts[i].found.cost < best.cost - noise) best = starts[i].found;
    }
    report(1);
    return best;
  }
};

CONCINO_INLINE build_direction_found find_build_direction(const part_surface& part,
                                                          const build_direction_options& options) {
  const char* caller = "best_build_direction";
  check_limits({options.max_angle_deg, {}, options.plate_tolerance}, caller);
  for (const double weight :
       {options.overhang_weight, options.support_weight, options.height_weight, options.plate_weight})
    if (!(weight >= 0 && std::isfinite(weight)))
      core::throw_joined<invalid_argument>({caller, ": weights must be 0 or more, and finite"});
  if (options.samples < 1 || options.samples > 100)
    core::throw_joined<invalid_argument>({caller, ": options.samples must be in [1, 100]"});
  if (!(options.accuracy_deg > 0 && options.accuracy_deg <= 45))
    core::throw_joined<invalid_argument>({caller, ": options.accuracy_deg must be in (0, 45]"});
  if (part.areas.empty()) core::throw_joined<invalid_mesh>({caller, ": no poly has an area"});
  return build_direction_search(part, options)();
}

}  // namespace concino::detail
