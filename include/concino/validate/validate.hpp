// validate: finds the defects of a mesh, as typed records and as sentences. A bad mesh never causes an exception.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/validate/detail/duplicates.hpp>
#include <concino/validate/detail/geometry_checks.hpp>
#include <concino/validate/detail/volume_checks.hpp>

namespace concino {

namespace detail {

inline void check_options(const validate_options& options) {
  const auto at_least_zero = [](double x, const char* name) {
    if (!(x >= 0))
      core::throw_joined<invalid_argument>(
          {"validate: ", name, " is ", core::number_text(x), "; it must be 0 or more"});
  };
  at_least_zero(options.length_tolerance, "length_tolerance");
  at_least_zero(options.size_tolerance, "size_tolerance");
  at_least_zero(options.planarity_tolerance, "planarity_tolerance");
}

template<class X, class M, class R, class Ring>
void check_duplicates(const M& m, const R& all, std::size_t count, const Ring& ring, defect_log<M>& log) {
  find_duplicates<X>(m, all, count, ring, [&](const X& x, const X& earlier) {
    if (defect<M>* d = log.add(defect_kind::duplicated_element, x)) {
      d->what = core::joined({log.name(x), " has the same verts as ", log.name(earlier)});
      d->others.push_back(earlier);
    }
  });
}

}  // namespace detail

/// The defects of m and facts about it as a whole: `for (auto& defect : validate(m)) ... defect.kind, defect.element,
/// defect.what`.
/// Needs:  AnyMesh M that satisfies the laws of its concept (otherwise see check_laws); if M is Embedded, shapes are
///         checked too.
/// Result: a validation_report. Each defect is reported once, at its cause: consequences of a face of three polys, of
///         an open poly or of a non-finite point are not reported again. A size is zero if it is zero as far as the
///         coordinates tell: the ends of the edge are equal, or moving the coordinates by their rounding errors could
///         make the area or volume
///         0. Larger tolerances are options. Polygons of more than three verts are projected along their vector area.
///         The result does not depend on the scale of the mesh, within the range of floating-point numbers.
/// Cost:   O(elements + adjacencies) time and memory, if the verbs of m cost no more than the size of their results;
///         polygons of n verts O(n log n), to check if they touch themselves.
/// Errors: invalid_argument if a tolerance is negative or not a number; cancelled. No defect of the mesh is an error.
/// Source: Tarjan 1975 for fans, components and windings; the definitions of manifolds are those of Hoffmann 1989,
///         "Geometric and Solid Modeling".
template<AnyMesh M>
validation_report<M> validate(const M& m, const validate_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "validate");
  const validate_options& options = *profiled;
  detail::check_options(options);
  validation_report<M> report;
  detail::defect_log<M> log(m, report, options);
  std::vector<std::uint8_t> encloses_volume(VolumeMesh<M> ? poly_index_bound(m) : 0);
  // surfaces and volumes have different defects
  if constexpr (SurfaceMesh<M>) report.facts = detail::check_surface<M>(m, detail::surface_scope<M, M>{}, log);
  else report.facts = detail::check_volume(m, encloses_volume, log);
  log.begin_stage(0.7, 1);
  if (log.wants(defect_kind::duplicated_element)) {
    detail::check_duplicates<poly_t<M>>(
        m, polys(m), num_polys(m), [&](const poly_t<M>& p) -> decltype(auto) { return adj_p2v(m, p); }, log);
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      detail::check_duplicates<face_t<M>>(
          m, faces(m), num_faces(m), [&](const face_t<M>& f) -> decltype(auto) { return adj_f2v(m, f); }, log);
  }
  if constexpr (Embedded<M>) detail::check_geometry(m, encloses_volume, log);
  report.sort();
  detail::report_progress(options.progress, 1, "validate");
  return report;
}

// What to write instead of calls that cannot compile.
template<class... T> void validate(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
