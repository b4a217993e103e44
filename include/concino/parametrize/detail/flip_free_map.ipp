// Bodies of flip_free_map.hpp: maps of disks to the plane without flips, by steps that keep the areas of triangles
// positive, from flat arrays.
#pragma once

#include <concino/core/error.hpp>
#include <concino/parametrize/detail/dirichlet_density.hpp>
#include <concino/parametrize/detail/disk_embedding.hpp>
#include <concino/parametrize/detail/flip_free_map.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// Newton's method with steps that flip no triangle.
class flip_free_steps {
  const flat_disk& f_;
  const poly_triangles& cut_;
  plane_unknowns unknown_;
  ldlt solver_;
  plane_points step_;
  double slope_ = 0;  // of the energy along the step

  int row(std::uint32_t v, std::size_t k) const {
    const int n = unknown_.number[v];
    return n < 0 ? -1 : 2 * n + static_cast<int>(k);
  }
  plane_matrix derivative(const plane_triangle& t, const plane_points& x) const {
    return t.derivative(x[f_.corners[t.corner[0]]], x[f_.corners[t.corner[1]]], x[f_.corners[t.corner[2]]]);
  }

  void find_step(const plane_points& uv) {
    const auto n = 2 * unknown_.count;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * cut_.triangles.size());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
    for (const plane_triangle& t : cut_.triangles) {
      const dirichlet_density d(derivative(t, uv));
      const double weight = t.area / cut_.area;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k) {
          const int r = row(f_.corners[t.corner[i]], k);
          if (r < 0) continue;
          const auto& g = t.gradient[i];
          gradient[r] += weight * (d.first[2 * k] * g[0] + d.first[2 * k + 1] * g[1]);
          for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t l = 0; l < 2; ++l) {
              const int c = row(f_.corners[t.corner[j]], l);
              if (c < 0 || c > r) continue;
              const auto& b = t.gradient[j];
              double value = 0;
              for (std::size_t x = 0; x < 2; ++x)
                for (std::size_t y = 0; y < 2; ++y) value += g[x] * d.second[2 * k + x][2 * l + y] * b[y];
              entries.emplace_back(r, c, weight * value);
            }
        }
    }
    Eigen::SparseMatrix<double> system(n, n);
    system.setFromTriplets(entries.begin(), entries.end());
    solver_.factorize(system);
    const Eigen::VectorXd x = solver_.solve(-gradient);
    slope_ = gradient.dot(x);
    for (std::uint32_t v = 0; v < step_.size(); ++v)
      for (std::size_t k = 0; k < 2; ++k) step_[v][k] = row(v, k) < 0 ? 0 : x[row(v, k)];
  }

  /// The first length of the step at which a triangle has no area.
  double first_flip(const plane_points& uv) const {
    double first = std::numeric_limits<double>::infinity();
    for (const plane_triangle& t : cut_.triangles) {
      const plane_matrix j = derivative(t, uv), d = derivative(t, step_);
      // the determinant of J + x D: c + b x + a x^2
      const double a = d.determinant(), b = j.xx * d.yy + d.xx * j.yy - j.xy * d.yx - d.xy * j.yx, c = j.determinant();
      const double root = b * b - 4 * a * c;
      if (root < 0) continue;
      const double s = std::sqrt(root);
      // the smallest positive of 2 c / (-b - s) and 2 c / (-b + s)
      for (const double below : {-b + s, -b - s})
        if (below > 0) first = std::min(first, 2 * c / below);
    }
    return first;
  }

 public:
  flip_free_steps(const flat_disk& f, const poly_triangles& cut, const fixed_points& fixed)
      : f_(f), cut_(cut), unknown_(f.points.size(), fixed), step_(f.points.size()) {}

  /// Infinite if a triangle has no area or is flipped.
  double energy(const plane_points& uv) const {
    double sum = 0;
    for (const plane_triangle& t : cut_.triangles) {
      const plane_matrix j = derivative(t, uv);
      const double square = j.xx * j.xx + j.xy * j.xy + j.yx * j.yx + j.yy * j.yy, det = j.determinant();
      const bool is_flipped =
          !(twice_area(uv[f_.corners[t.corner[0]]], uv[f_.corners[t.corner[1]]], uv[f_.corners[t.corner[2]]]) > 0);
      if (is_flipped || !(det > 0)) return std::numeric_limits<double>::infinity();
      sum += t.area * square * (1 + 1 / (det * det));
    }
    return sum / cut_.area;
  }

  /// Moves uv to a point of smaller energy, which it returns; the same energy if there is none.
  double advance(plane_points& uv, double before) {
    if (unknown_.count == 0) return before;
    find_step(uv);
    double length = std::min(1.0, 0.9 * first_flip(uv));
    plane_points next = uv;
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i, length /= 2) {
      for (std::size_t v = 0; v < uv.size(); ++v)
        next[v] = {uv[v][0] + length * step_[v][0], uv[v][1] + length * step_[v][1]};
      const double after = energy(next);
      constexpr double fraction = 1e-4;  // of the fall that the slope promises
      if (after < before && after <= before + fraction * length * slope_) {
        uv = next;
        return after;
      }
    }
    return before;
  }
};

inline plane_points tutte_start(const flat_disk& f, const poly_triangles& cut) {
  plane_points uv = embed_disk(f, {}, {}).uv;
  scale_to_area(f, cut, uv);
  return uv;
}

CONCINO_INLINE iterated_map flip_free_map(const flat_disk& f, plane_points start, bool fixed_boundary,
                                          const iteration_limits& limits) {
  check_limits(limits, "injective_map");
  const poly_triangles cut(f);
  cut.check_areas(f, "injective_map");
  const bool by_tutte = start.empty();
  for (std::size_t v = 0; v < start.size(); ++v)
    if (!std::isfinite(start[v][0]) || !std::isfinite(start[v][1]))
      core::throw_joined<invalid_argument>(
          {"injective_map: the start has a point that is not finite at vert ", f.vert_index[v]});
  iterated_map result{by_tutte ? tutte_start(f, cut) : std::move(start), {}};
  fixed_points fixed;
  if (fixed_boundary)
    for (const std::uint32_t v : f.loop) fixed.push_back({v, result.uv[v]});
  else fixed = {{far_pair(f).first, result.uv[far_pair(f).first]}};
  flip_free_steps steps(f, cut, fixed);
  result.energies.push_back(steps.energy(result.uv));
  if (!std::isfinite(result.energies[0])) {
    if (!by_tutte)
      throw invalid_argument("injective_map: the start has flips; see map_distortion(m, start).flips");
    throw solver_error(
        attached_pieces(f).empty()
            ? "injective_map: the map of tutte, the start, has flips by rounding errors: parts of the surface are too "
              "far from the boundary; cut it open further with cut_along, or pass a start without flips"
            : "injective_map: the map of tutte, the start, has flips: two verts separate pieces from the boundary, see "
              "tutte(m).attached; subdivide the polys there, or pass a start without flips");
  }
  for (int i = 0; i < limits.max_iterations && !result.has_converged; ++i) {
    report_progress(limits.on_progress, static_cast<double>(i) / limits.max_iterations, "injective_map");
    const double before = result.energies.back(), after = steps.advance(result.uv, before);
    result.has_converged = before - after <= limits.tolerance * before;
    if (after < before) result.energies.push_back(after);
  }
  if (by_tutte && !fixed_boundary) {
    plane_points placed = result.uv;
    place_upright(f, placed);
    if (std::isfinite(steps.energy(placed))) result.uv = std::move(placed);  // rounding flips nothing
  }
  report_progress(limits.on_progress, 1, "injective_map");
  return result;
}

}  // namespace concino::detail
