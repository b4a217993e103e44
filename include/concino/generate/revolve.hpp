// Revolution: the volume that a surface passes through when it turns around an axis.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/shapes/rotation.hpp>
#include <concino/generate/extrude.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace concino {

struct revolve_options {
  double angle_deg = 360;   // the whole angle in degrees, from -360 to 360, not 0; counter-clockwise seen from where
                            // the axis points to. 360 and -360 join the ends
  bool properties = true;                             // whether named properties of verts, of polys and of the mesh are
                                                      // transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the vert or poly of m of which each
                                                      // vert and poly was made
  std::vector<poly_id>* inverted = nullptr;           // unless null, filled with the polys of the result whose scaled
                                                      // Jacobian is not above 0
};

namespace detail {

/// Whether the polys of m are clockwise seen from where they turn to.
template<class M>
class revolved_polys {
  const M& m_;
  const rotation& turn_;
  double step_;
  sweep_direction towards_{"revolve"};

 public:
  revolved_polys(const M& m, const rotation& turn, double step) : m_(m), turn_(turn), step_(step) {}

  /// Errors: those of sweep_direction; unsupported that names a quad with a vert on the axis; invalid_argument that
  ///         names a poly of which some verts move to one side, some to the other.
  bool operator()(const poly_t<M>& p) const {
    const vec3 n = normal(m_, p);
    const std::size_t i = index_of(m_, p);
    bool is_known = false, reversed = false;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      const vec3 x = to_vec3(point(m_, v));
      if (turn_.is_on_axis(x)) {
        // a hex has eight verts
        if constexpr (arity_v<M> == 4)
          core::throw_joined<unsupported>({"revolve: poly ", i, " has vert ", index_of(m_, v),
                                           " on the axis, where its cells are no hexes; turn convert<polygonmesh>(m)"});
        continue;
      }
      // The chords of the steps before and after: the cells on both sides of the poly must have positive volumes.
      for (const vec3& chord : {turn_(x, step_) - x, x - turn_(x, -step_)}) {
        const bool clockwise = towards_.is_reversed(i, n, direction_of_length_1(chord));
        if (is_known && clockwise != reversed)
          core::throw_joined<invalid_argument>(
              {"revolve: verts of poly ", i,
               " move to both of its sides; it must not cross the axis, and more segments may be needed"});
        is_known = true, reversed = clockwise;
      }
    }
    // all verts are on the axis: the error of a poly without area
    return is_known ? reversed : towards_.is_reversed(i, vec3(), vec3());
  }
};

/// Errors: as revolve, for its arguments.
inline void check_revolution(const vec3& centre, const vec3& axis, std::size_t segments, double angle_deg) {
  check_finite("revolve", "centre", centre);
  check_finite("revolve", "axis", axis);
  if (axis == vec3()) core::throw_joined<invalid_argument>({"revolve: axis is 0; it must have a direction"});
  if (!(angle_deg >= -360 && angle_deg <= 360) || angle_deg == 0)
    core::throw_joined<invalid_argument>(
        {"revolve: angle_deg is ", core::number_text(angle_deg), "; it must be between -360 and 360, and not 0"});
  check_at_least("revolve", "segments", segments, static_cast<std::size_t>(std::abs(angle_deg) / 180) + 1);
}

/// The numbers of the verts that are not on the axis.
inline sweep_layers layers_around_axis(const swept_surface& s, const rotation& turn, std::size_t segments,
                                       bool closed) {
  sweep_layers layers{s.points.size(), segments, closed, std::vector<std::uint32_t>(s.points.size(), ~0u), 0};
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (!turn.is_on_axis(s.points[v])) layers.moving[v] = static_cast<std::uint32_t>(layers.num_moving++);
  return layers;
}

}  // namespace detail

/// The volume that a surface passes through when it turns around the axis through `centre`: revolve(m, {0, 0, 0}, {0,
/// 0, 1}, 32).
/// Needs:  Embedded SurfaceMesh on one side of the axis, whose polys all turn to one of their sides, as those of a
///         surface in a half-plane that the axis bounds. Verts within 1e-12 times the largest distance of a vert from
///         `centre` are on the axis.
/// Result: a hexmesh if M has quads only by type, else a polyhedralmesh. Verts are those of verts(m), then those off
///         the axis for each further level, and polys those of polys(m) for each segment. Verts on the axis are not
///         repeated: polyhedra there have triangles, and edges on the axis no faces. Cells have a positive volume,
///         whichever way the surface is wound. Those of polygons that are not convex are inverted at a corner;
///         options.inverted lists them. Properties of verts and polys, and of the mesh, are transferred by their rules.
///         After a whole turn, the last level is the first one.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: invalid_argument if angle_deg is out of range, if a segment turns by 180 degrees or more, if the axis is 0,
///         if it or the centre is not finite, or if the result would have too many elements. It names a poly that
///         crosses the axis or turns in itself, and two polys that share an edge and turn to different sides.
///         unsupported that names a quad with a vert on the axis, if M has quads only by type. invalid_mesh as extrude.
template<SurfaceMesh M>
  requires Embedded<M> detail::swept_mesh<M> revolve(const M& m, const vec3& centre, const vec3& axis,
                                                     std::size_t segments, const revolve_options& options = {}) {
    detail::check_revolution(centre, axis, segments, options.angle_deg);
    detail::check_sweep_counts("revolve", "segments", segments, num_verts(m), num_polys(m),
                               detail::num_poly_corners(m));
    double far = 0;
    for (const vert_t<M> v : verts(m)) far = std::max(far, norm(to_vec3(point(m, v)) - centre));
    const detail::rotation turn(centre, detail::direction_of_length_1(axis), 1e-12 * far);
    const double angle = options.angle_deg * (std::numbers::pi / 180), step = angle / static_cast<double>(segments);
    const auto s = detail::read_swept_surface("revolve", m, detail::revolved_polys<M>(m, turn, step));
    const bool closed = std::abs(options.angle_deg) == 360;
    const auto layers = detail::layers_around_axis(s, turn, segments, closed);
    const auto at = [&](std::size_t level, std::uint32_t v) {
      return turn(s.points[v], angle * (static_cast<double>(level) / static_cast<double>(segments)));
    };
    auto result = detail::construct_swept(m, s, layers, at, options.properties, options.correspondence);
    if (options.inverted) *options.inverted = detail::inverted_polys(result);
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void revolve(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void revolve(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
