// repair(m, options): mends what can be mended of a mesh, and says what it did. repaired(m) does it for any mesh, to a
// new one.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/support/arrays_of.hpp>
#include <concino/mesh/support/native_mesh_of.hpp>
#include <concino/repair/detail/carry_properties.hpp>
#include <concino/repair/detail/repair_cells.hpp>
#include <concino/repair/detail/repair_polyhedra.hpp>
#include <concino/repair/detail/repair_surface.hpp>
#include <concino/repair/repair_options.hpp>
#include <concino/repair/repair_result.hpp>

#include <limits>
#include <optional>
#include <utility>

namespace concino {

/// A new mesh, and what was done for it.
template<class M>
struct repaired_mesh {
  M mesh;
  repair_result result;
};

/// The mesh that repaired(m) makes: of triangles if the type of m has triangles only, and so on, else a polygonmesh or
/// polyhedralmesh.
template<class M>
using repaired_mesh_of = typename core::native_mesh_of<dimension_v<M>, static_cast<int>(arity_v<M>)>::type;

namespace requirement {

/// A native mesh.
template<class M> concept is_native_mesh = AnyMesh<M> && std::is_same_v<M, repaired_mesh_of<M>>;

}  // namespace requirement

namespace detail {

inline void check_options(const repair_options& options, bool has_transaction) {
  const double d = options.merge_within.value_or(0);
  if (!(d >= 0 && d <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {"repair: merge_within is ", core::number_text(d), "; it is a distance, finite and 0 or more"});
  if (has_transaction)
    throw invalid_argument("repair: a transaction of the mesh is open, which could not undo it; end it first");
}

/// The elements of a range, by their numbers without gaps.
template<class M, class R>
std::vector<std::uint32_t> indices_of(const M& m, const R& elements, std::size_t count) {
  std::vector<std::uint32_t> all;
  all.reserve(count);
  for (const auto x : elements) all.push_back(static_cast<std::uint32_t>(index_of(m, x)));
  return all;
}

template<class To, class M>
auto repaired_arrays_of(const M& m, const repair_options& options, repair_log& log) {
  const std::vector<std::uint32_t> number = core::numbered(m, verts(m), vert_index_bound(m));
  constexpr auto arity = static_cast<std::uint32_t>(arity_v<To>);
  if constexpr (dimension_v<M> == 2) {  // each kind of arrays has repairs of its own
    return repair_surface(core::arrays_of(m, number, 0), arity, options, log);
  } else if constexpr (arity > 0) {  // cells of one shape are lists of verts
    cell_arrays a{core::copy_points(m), {}, arity};
    a.verts.reserve(arity * num_polys(m));
    core::for_each_cell(m, number, arity, [&](const poly_t<M>&, const vert_id* corners) {
      a.verts.insert(a.verts.end(), corners, corners + arity);
    });
    return repair_cells(std::move(a), options, log);
  } else {
    return repair_polyhedra(core::polyhedra_of(m, number, core::numbered(m, faces(m), face_index_bound(m))), options,
                            log);
  }
}

/// The mesh after the repair of m; none if it is a To and nothing was done.
template<class To, class M>
std::optional<To> repair_to(const M& m, const repair_options& input_options, repair_result& result) {
  const core::profiled_options profiled(input_options, "repair");
  const repair_options& options = *profiled;
  report_progress(options.progress, 0, "repair");
  repair_log log(indices_of(m, verts(m), num_verts(m)), indices_of(m, polys(m), num_polys(m)));
  auto repaired = repaired_arrays_of<To>(m, options, log);
  report_progress(options.progress, 0.8, "repair");
  std::optional<To> mesh;
  if (!std::is_same_v<To, M> || log.has_changes()) mesh.emplace(std::move(repaired.arrays));
  if (mesh) {
    result.from.verts = renamed(std::move(repaired.verts), log.vert_index());
    result.from.polys = renamed(std::move(repaired.polys), log.poly_index());
    carry_properties(m, *mesh, result.from, repaired.cluster, log.vert_index());
  } else {
    result.from.verts = origins_of_themselves(log.vert_index(), vert_index_bound(m));
    result.from.polys = origins_of_themselves(log.poly_index(), poly_index_bound(m));
  }
  log.write(result);
  report_progress(options.progress, 1, "repair");
  return mesh;
}

}  // namespace detail

/// Mends a mesh, as the options say. Without options it does what has one right answer: of polys with the same verts
/// the first remains, verts and faces without polys are removed, inverted cells are turned, equal faces of polyhedra
/// become one. The order is: verts are merged, duplicates, degenerate and intersecting polys removed, fans split, polys
/// turned, holes filled, and unreferenced elements removed.
/// Needs:  a native mesh.
/// Result: records and sentences of what was done, and of what was to be mended but is left. If nothing is to be done,
///         m is as it was. Otherwise verts and polys keep their order and are numbered without gaps; new ones come
///         last. Named properties follow by their rules, but descriptors, maps and handles of properties from before
///         are not valid any more: result.from has the origins of elements, and handles are found anew.
/// Cost:   O(elements) for merging, duplicates, orientation, fans; O(k^3) to fill a hole of k edges; that of
///         self_intersections, if these are looked for.
/// Errors: invalid_argument if the tolerance is negative, infinite or not a number, or a transaction of m is open.
///         unsupported that names a poly which a mesh of fixed arity cannot hold once its verts are merged.
///         invalid_mesh if intersections are looked for and a point is not finite. cancelled. m is unchanged then, also
///         if memory runs out.
/// Source: Barequet, Sharir 1995, "Filling gaps in the boundary of a polyhedron", for fillings of minimal area;
///         Gueziec, Taubin, Lazarus, Horn 2001, "Cutting and stitching", for fans.
template<requirement::is_native_mesh M>
repair_result repair(M& m, const repair_options& options = {}) {
  detail::check_options(options, m.edits().recorder != nullptr);
  repair_result result;
  if (std::optional<M> mesh = detail::repair_to<M>(m, options, result)) m = *std::move(mesh);
  return result;
}

/// A native mesh of any mesh, mended as by repair.
/// Needs:  EmbeddedMesh M.
/// Result: the mesh, with the named properties of m if it has some, and what was done.
/// Cost:   as repair.
/// Errors: as repair; m is not changed.
template<EmbeddedMesh M>
repaired_mesh<repaired_mesh_of<M>> repaired(const M& m, const repair_options& options = {}) {
  detail::check_options(options, false);
  repair_result result;
  std::optional<repaired_mesh_of<M>> mesh = detail::repair_to<repaired_mesh_of<M>>(m, options, result);
  if constexpr (std::is_same_v<repaired_mesh_of<M>, M>)  // only then can it be the mesh itself
    if (!mesh) return {m, std::move(result)};
  return {*std::move(mesh), std::move(result)};
}

// What to write instead of calls that cannot compile.
namespace mistake {
inline constexpr sentence call_repaired(
    "repair changes native meshes only; repaired makes one of any other mesh: auto [mesh, fix] = repaired(m);");
}
template<class M, class R = mistake::remedy<mistake::call_repaired>>
  requires(!requirement::is_native_mesh<M>)
void repair(M&, const repair_options& = {}) = delete;  // auto [mesh, fix] = repaired(m);
template<class... T> void repaired(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void repaired(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
