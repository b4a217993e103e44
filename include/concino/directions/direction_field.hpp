// direction_field(m): the smoothest field of n directions at the verts of a surface, such as crosses.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/smoothest/smoothest_values.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/mesh/element_map.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

template<class M>
struct direction_field_options {
  int symmetry = 4;  // n, 1 to 16: how many directions a vert has, with equal angles between them. 1: vectors; 2:
                     // lines; 4: crosses
  std::vector<std::pair<vert_t<M>, vec3>> hard = {};  // verts, and one of the directions there; any length
  std::vector<std::pair<vert_t<M>, vec3>> soft = {};  // as hard, but as a wish
  double soft_weight = 1;          // of wishes, above 0; 1: as much as the Laplacian's weight of the vert
  bool align_with_boundary = false;  // one direction at the boundary is along it; where it has a corner, as near to
                                     // both edges as n allows
  double align_with_curvature = 0;   // 0 or more; above 0 directions tend to those of principal curvatures, where these
                                     // differ; n must be even. 1: as much as the surface bends. n = 2: that of the
                                     // smaller curvature, the axis of a cylinder
  concino::progress progress = nullptr;   // called with "direction_field"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Directions at the verts of a surface, n at each, with equal angles between them. It keeps what it needs of the
/// surface.
///
/// Angles at a vert are those of tangent_vector: 0 is along the first edge of adj_v2e, a full turn inside the surface
/// is 2 pi. They increase counter-clockwise as the first poly of the component in polys(m) is seen.
template<class M>
class direction_field_result {
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::oriented_surface> surface_;
  int symmetry_;
  std::vector<detail::complex_value> value_;
  std::vector<double> energy_;
  double residual_;

 public:
  direction_field_result(const M& m, std::shared_ptr<const detail::oriented_surface> surface, int symmetry,
                         detail::smoothest_values found)
      : mesh_(m), surface_(std::move(surface)), symmetry_(symmetry), value_(std::move(found.value)),
        energy_(std::move(found.energy)), residual_(found.residual) {
    for (double& x : energy_) x = std::ldexp(x, -2 * surface_->exponent);
  }

  const M& mesh() const { return mesh_.get(); }
  int symmetry() const { return symmetry_; }
  /// The surface in flat arrays, for functions of this module.
  const detail::oriented_surface& surface() const { return *surface_; }

  /// How much the field turns: the smallest eigenvalue of the connection Laplacian, in units of length^-2, of each
  /// component in the order of their first polys. Where directions are wanted, the energy of the values over the
  /// integral of their squares.
  const std::vector<double>& energies() const { return energy_; }
  /// Of the eigenvectors, relative to a small eigenvalue: 1e-10 if they are found as well as is possible.
  double residual() const { return residual_; }

  /// Of all verts, by index.
  const std::vector<std::complex<double>>& values() const { return value_; }
  /// The n-th power of the directions at v as complex numbers, times a length that is small near singularities; 0 at
  /// verts without polys.
  std::complex<double> value(const vert_t<M>& v) const { return value_[index_of(mesh_.get(), v)]; }
  /// The directions of angle 0 and of angle pi/2 in space, of length 1; 0 at verts without polys.
  std::array<vec3, 2> basis(const vert_t<M>& v) const { return surface_->axes[index_of(mesh_.get(), v)]; }
  /// The angle of direction k, counter-clockwise from the first, which is in (-pi/n, pi/n].
  double angle(const vert_t<M>& v, int k = 0) const {
    return (std::arg(value(v)) + 2 * std::numbers::pi * k) / symmetry_;
  }
  /// Direction k at v in space, of length 1; 0 at verts without polys.
  vec3 direction(const vert_t<M>& v, int k = 0) const {
    const std::array<vec3, 2> axes = basis(v);
    const double at = angle(v, k);
    return std::cos(at) * axes[0] + std::sin(at) * axes[1];
  }
  /// All n directions at v.
  std::vector<vec3> directions(const vert_t<M>& v) const {
    std::vector<vec3> all;
    for (int k = 0; k < symmetry_; ++k) all.push_back(direction(v, k));
    return all;
  }
};

namespace detail {

/// The n-th power of a direction in space, in the frame of a vert.
/// Errors: invalid_mesh if v is no vert of a poly; invalid_argument if the vector is not finite, or 0 in the tangent
///         plane.
template<class M>
std::pair<std::size_t, complex_value> power_of(const M& m, const oriented_surface& s, int n, const vert_t<M>& v,
                                               const vec3& d, const char* caller) {
  if (!contains(m, v) || s.component[index_of(m, v)] == oriented_surface::none)
    core::throw_joined<invalid_mesh>({caller, ": a direction is given at what is no vert of a poly of the mesh"});
  const std::size_t i = index_of(m, v);
  if (!is_finite(d))
    core::throw_joined<invalid_argument>({caller, ": the direction of vert ", i, " is not finite"});
  const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const vec3 unit = largest > 0 ? d / largest : d;
  const complex_value z(dot(unit, s.axes[i][0]), dot(unit, s.axes[i][1]));
  constexpr double rounding = 1e-9;
  if (!(std::abs(z) > rounding))
    core::throw_joined<invalid_argument>(
        {caller, ": the direction of vert ", i, " is 0 in its tangent plane; give one along the surface"});
  return {i, unit_complex(n * std::arg(z))};
}

template<class M>
void check_direction_options(const direction_field_options<M>& options, const char* caller) {
  const auto refuse = [&](const char* what) { core::throw_joined<invalid_argument>({caller, ": ", what}); };
  if (options.symmetry < 1 || options.symmetry > 16) refuse("symmetry must be from 1 to 16");
  if (!(options.soft_weight > 0 && std::isfinite(options.soft_weight)))
    refuse("soft_weight must be finite and above 0");
  if (!(options.align_with_curvature >= 0 && std::isfinite(options.align_with_curvature)))
    refuse("align_with_curvature must be finite and 0 or more");
  if (options.align_with_curvature > 0 && options.symmetry % 2 != 0)
    refuse("principal directions are lines; align_with_curvature needs an even symmetry");
}

}  // namespace detail

/// The smoothest field of n directions at the verts of a surface: auto f = direction_field(m, {.symmetry = 4}); then
/// f.directions(v) are the directions at v, and singularities(f) where they cannot agree.
/// Needs:  Embedded SurfaceMesh, no temporary, of polys of any shape, with or without boundary, and orientable; its
///         polys need not be oriented alike. The polys at each vert are one fan.
/// Result: see direction_field_result. Without wishes each component has the field with the smallest energy among
///         those of one size. It is unique but for a turn of all directions if the eigenvalue is simple, and
///         then does not depend on the order of storage or the size. With wishes it is the field with the smallest
///         energy that has them: hard ones exactly, soft ones by their weights. On a sphere of radius R the energy
///         tends to n / R^2.
/// Cost:   one sparse factorisation of two rows for each vert. Without wishes also some 5 to 30 rounds of 4 n + 4
///         solves with it, 24 at most.
/// Errors: invalid_mesh if there are no polys, one has no area or points that are not finite, or a wish is at what is
///         no vert of a poly. unsupported if the surface is not orientable, an edge has more than two polys, or the
///         polys at a vert are not one fan. invalid_argument if an option is out of its range, hard directions
///         contradict each other or the boundary, or a direction is not finite or 0 in the tangent plane. solver_error;
///         cancelled.
/// Source: Knoppel, Crane, Pinkall, Schroder 2013, "Globally optimal direction fields", with virtual elements in place
///         of their linear elements; Crane, Desbrun, Schroder 2010, for transport along edges.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
direction_field_result<std::remove_cvref_t<M>> direction_field(
    M&& m, const direction_field_options<std::remove_cvref_t<M>>& options = {}) {
  constexpr const char* caller = "direction_field";
  const core::profiled_options profiled(options, caller);
  detail::check_direction_options(options, caller);
  detail::report_progress(profiled->progress, 0, caller);
  const std::remove_cvref_t<M>& mesh = m;
  const int n = options.symmetry;
  auto surface = std::make_shared<const detail::oriented_surface>(detail::read_oriented_surface(mesh, caller));
  const auto energy = detail::make_connection_energy(*surface, n);
  detail::wanted_values wishes(surface->num_verts());
  if (options.align_with_boundary) detail::fix_at_boundary(*surface, n, wishes, caller);
  for (const auto& [v, d] : options.hard) {
    const auto [i, z] = detail::power_of(mesh, *surface, n, v, d, caller);
    wishes.fix(i, z, caller);
  }
  for (const auto& [v, d] : options.soft) {
    const auto [i, z] = detail::power_of(mesh, *surface, n, v, d, caller);
    wishes.pull(i, options.soft_weight * energy.diagonal[i], z);
  }
  if (options.align_with_curvature > 0)
    detail::pull_to_curvature(*surface, n, options.align_with_curvature, wishes);
  auto found = detail::find_smoothest(*surface, energy, n, wishes, profiled->progress);
  detail::report_progress(profiled->progress, 1, caller);
  return {mesh, std::move(surface), n, std::move(found)};
}

// What to write instead of calls that cannot compile.
template<class... T> void direction_field(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void direction_field(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void direction_field(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
