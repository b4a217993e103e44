// Geodesics that go straight ahead over a surface, from a point in a direction.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/lines/detail/geodesics/geodesic_start.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace concino {

struct trace_geodesic_options {
  std::size_t max_steps = 1'000'000;  // edges and verts that are crossed, at least 1
};

/// A geodesic. It is straight between consecutive points; each piece lies in one poly or along an edge.
/// points: from the start to the end, both included; on edges, at verts, and in polys: the start, the end, and where it
/// crosses a diagonal of a
///         polygon that is not a triangle.
/// length: in units of length.
/// direction: at the end, of length 1, along the last piece.
/// stopped_by: why it ended.
template<class M>
struct traced_geodesic {
  std::vector<mesh_point<M>> points;
  double length = 0;
  vec3 direction;
  line_end stopped_by = line_end::max_length;
};

namespace detail {

template<class X> concept tangent_direction = std::same_as<X, tangent_vector> || std::same_as<X, vec3>;

template<class M>
mesh_point<M> geodesic_start_at(const mesh_point<M>& x) { return x; }
template<class M>
mesh_point<M> geodesic_start_at(const vert_t<M>& v) { return {v, {}}; }

}  // namespace detail

/// A surface prepared by prepare_trace_geodesic. Several threads may query it. Copies share the prepared data.
template<SurfaceMesh M>
  requires Embedded<M>
class prepared_trace_geodesic {
  static constexpr const char* caller = "trace_geodesic";
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::geodesic_surface<M>> surface_;

  template<class Direction>
  traced_geodesic<M> run(const mesh_point<M>& start, const Direction& direction, double length,
                         const trace_geodesic_options& options) const {
    const M& m = mesh_.get();
    if (!(length >= 0 && std::isfinite(length)))
      core::throw_joined<invalid_argument>(
          {caller, ": the length is ", core::number_text(length), "; it has to be finite and not negative"});
    if (options.max_steps == 0)
      core::throw_joined<invalid_argument>({caller, ": max_steps is 0; it has to be at least 1"});
    const double size = norm(direction);
    if (!(size > 0 && std::isfinite(size)))
      core::throw_joined<invalid_argument>({caller, ": the direction is 0 or not finite"});
    const detail::geodesic_start<M> find(m, *surface_, caller);
    const int exponent = surface_->triangles().exponent;
    const mesh_point<M> from = detail::lowest_element_of(m, start, caller, "start");
    const detail::walk_state state = find(from, (1 / size) * direction, start);
    traced_geodesic<M> r;
    r.points.push_back(find.first_point(from, state));
    if (state.side < 0) {
      r.stopped_by = line_end::boundary;
      return r;
    }
    const detail::walk_result walk =
        detail::walk_straight(surface_->triangles(), state, std::ldexp(length, -exponent), options.max_steps);
    r.points.reserve(1 + walk.stops.size());
    for (const detail::walk_stop& s : walk.stops) r.points.push_back(surface_->point_of(m, s));
    r.length = std::ldexp(walk.length, exponent);
    r.direction = surface_->direction_of(walk.last);
    r.stopped_by = walk.stopped_by;
    return r;
  }

 public:
  explicit prepared_trace_geodesic(const M& m)
      : mesh_(m), surface_(std::make_shared<const detail::geodesic_surface<M>>(m, caller)) {}

  const M& mesh() const { return mesh_.get(); }

  /// The geodesic from a vert or a point of the surface.
  /// Needs:  as trace_geodesic. The mesh has not changed since it was prepared.
  /// Result: that of trace_geodesic.
  /// Cost:   O(number of points).      Errors: as trace_geodesic, except those about polys.
  template<class Start, detail::tangent_direction Direction = vec3>
    requires(std::convertible_to<Start, vert_t<M>> || std::convertible_to<Start, mesh_point<M>>)
  traced_geodesic<M> trace_from(const Start& start, const Direction& direction, double length,
                                const trace_geodesic_options& options = {})
  const { return run(detail::geodesic_start_at<M>(start), direction, length, options); }
  /// The same from the point x of poly p.
  template<detail::tangent_direction Direction = vec3>
  traced_geodesic<M> trace_from(const poly_t<M>& p, const vec3& x, const Direction& direction, double length,
                                const trace_geodesic_options& options = {}) const {
    return run(mesh_point<M>{p, x}, direction, length, options);
  }
  void trace_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0
};

/// Prepares geodesics from many points: auto trace = prepare_trace_geodesic(m); auto t = trace.trace_from(v,
/// cn::tangent_vector{1, 0}, 2.5).
/// Needs:  as trace_geodesic; the mesh must not change afterwards.
/// Result: an object with trace_from(start, direction, length).      Cost: O(size of the mesh).
/// Errors: invalid_mesh if a poly has no area, or points that are not finite.
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
prepared_trace_geodesic<std::remove_cvref_t<M>> prepare_trace_geodesic(M&& m) {
  return prepared_trace_geodesic<std::remove_cvref_t<M>>(m);
}

/// The straightest geodesic from a point in a direction: auto t = trace_geodesic(m, v, cn::tangent_vector{1, 0}, 2.5).
/// It crosses edges as if both polys lay in one plane, and passes verts with equal angles on both sides.
/// Needs:  Embedded SurfaceMesh, not a temporary. start: a vert, a mesh_point of a vert, an edge or a poly, or a poly p
///         and a position x in it. direction: a tangent_vector in the frame of that element, or a vec3, which is
///         projected onto the surface: of the polys at a vert or an edge, onto the one to which it is nearest. Only the
///         direction of either counts. length: finite, in units of length. A place of a poly on its edges or verts is a
///         place of these, see lowest_element.
/// Result: see traced_geodesic. It ends at the length, at the boundary, or where the surface is not manifold, and says
///         which. It may cross itself. It goes on along a straight boundary, and past a vert of the boundary with half
///         a turn or more of surface on one side of it. On parts that can be unrolled into the plane it is a straight
///         line there, to rounding. It passes through a vert if it comes nearer than 1e-12 of the edge's length.
///         Polygons other than triangles are walked by their triangulation (triangulate_polygon).
/// Cost:   O(size of the mesh) to prepare, then O(number of points); see prepare_trace_geodesic.
/// Errors: those of lowest_element about the start. invalid_mesh if a poly has no area or points that are not finite.
///         invalid_argument if the length, the direction or max_steps is out of its range, or the direction is
///         perpendicular to the surface. unsupported if the start is a vert about which the polys are not one fan, and
///         the direction is in its frame.
/// Source: Polthier, Schmies 1998, "Straightest geodesics on polyhedral surfaces".
template<class M, class Start, detail::tangent_direction Direction = vec3>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      (std::convertible_to<Start, vert_t<M>> || std::convertible_to<Start, mesh_point<std::remove_cvref_t<M>>>)
          traced_geodesic<std::remove_cvref_t<M>> trace_geodesic(M&& m, const Start& start, const Direction& direction,
                                                                 double length,
                                                                 const trace_geodesic_options& options = {}) {
    return prepare_trace_geodesic(m).trace_from(start, direction, length, options);
  }
template<class M, detail::tangent_direction Direction = vec3>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> traced_geodesic<std::remove_cvref_t<M>>
  trace_geodesic(M&& m, const poly_t<M>& p, const vec3& x, const Direction& direction, double length,
                 const trace_geodesic_options& options = {}) {
    return prepare_trace_geodesic(m).trace_from(p, x, direction, length, options);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_trace_geodesic(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_trace_geodesic(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_trace_geodesic(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void trace_geodesic(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void trace_geodesic(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void trace_geodesic(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void trace_geodesic(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
