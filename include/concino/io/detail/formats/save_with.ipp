// Bodies of save_with.hpp: the implementation of all functions that save meshes, for any list of formats.
#pragma once

#include <concino/io/detail/cells/face_key.hpp>
#include <concino/io/detail/formats/save_with.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#ifdef CONCINO_COMPILED
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#endif

namespace concino::detail {

/// Reports the properties that a format drops: all except those in `stored`.
CONCINO_INLINE void report_lost_properties(const property_set& all,
                                           const std::vector<write_context::stored_property>& stored,
                                           std::string_view format, std::vector<std::string>& lost) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const property_info p = all.info(i);
    bool is_kept = false;
    for (const write_context::stored_property& k : stored)
      is_kept = is_kept || (p.kind == k.kind && k.name == p.name && *p.type == *k.type);
    if (!is_kept)
      lost.push_back(core::joined({to_string(p.kind), " property \"", p.name, "\": ", format, " cannot store it"}));
  }
}

CONCINO_INLINE void check_savable_points(std::string_view name, const flat_mesh& m) {
  for (std::size_t v = 0; v < m.points.size(); ++v)
    if (!is_finite(m.points[v]))
      core::throw_joined<invalid_mesh>(
          {name, ": vert ", m.vert_index(v), " has a coordinate that is not a finite number; no file can hold it"});
}

CONCINO_INLINE void report_lost_faces(save_report& report, flat_mesh& m, std::string_view format) {
  if (m.arity != 0) return;  // the faces of tets and hexes are those of the polys
  const flat_polyhedra& all = m.polyhedra();
  std::vector<bool> is_used(all.face_verts.size());
  for (const face_id f : all.poly_faces.values) is_used[f.raw()] = true;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  std::size_t num_unused = 0, num_equal = 0;
  for (std::uint32_t f = 0; f < all.face_verts.size(); ++f) {
    if (is_used[f]) keys.emplace_back(face_key(all.face_verts[f].data(), all.face_verts[f].size()), f);
    else ++num_unused;
  }
  std::sort(keys.begin(), keys.end());
  const auto sorted = [&](std::uint32_t f) {
    std::vector<vert_id> verts_of_face(all.face_verts[f].begin(), all.face_verts[f].end());
    std::sort(verts_of_face.begin(), verts_of_face.end());
    return verts_of_face;
  };
  for (std::size_t i = 1; i < keys.size(); ++i)
    num_equal += keys[i].first == keys[i - 1].first && sorted(keys[i].second) == sorted(keys[i - 1].second);
  if (num_equal)
    report.lost.push_back(
        core::joined({num_equal, " faces with the verts of another face: ", format,
                      " lists no faces, so that readers unite them, and polys become neighbours; .hedra holds them"}));
  if (num_unused)
    report.lost.push_back(
        core::joined({num_unused, " faces of no poly: ", format, " lists no faces; .hedra holds them"}));
}

CONCINO_INLINE void report_lost(const write_context& c, const flat_mesh& m, std::string_view format) {
  if (const std::size_t n = m.num_loose_edges())
    c.report.lost.push_back(core::joined(
        {n, m.dimension == 2 ? " edges without polys" : " edges without faces", ": ", format, " cannot store them"}));
  if (m.properties) report_lost_properties(*m.properties, c.stored, format, c.report.lost);
  if (c.num_not_finite)
    c.report.lost.push_back(
        core::joined({c.num_not_finite, " numbers of colours and other properties that are not finite: written as 0"}));
}

[[noreturn, gnu::cold]] CONCINO_INLINE void throw_lossy(std::string_view name, const save_report& report) {
  std::string all;
  for (const std::string& what : report.lost) all = core::joined({all, all.empty() ? "" : "; ", what});
  core::throw_joined<unsupported>({name, ": the file would lose something, and options.strict is set: ", all});
}

#ifdef CONCINO_COMPILED
template<class M>
void visit_precompiled_flat_mesh(const M& m, function_ref<void(flat_mesh&)> f) {
  flat_mesh_of<M> flat(m);
  f(flat);
}
template void visit_precompiled_flat_mesh(const trimesh&, function_ref<void(flat_mesh&)>);
template void visit_precompiled_flat_mesh(const quadmesh&, function_ref<void(flat_mesh&)>);
template void visit_precompiled_flat_mesh(const polygonmesh&, function_ref<void(flat_mesh&)>);
template void visit_precompiled_flat_mesh(const tetmesh&, function_ref<void(flat_mesh&)>);
template void visit_precompiled_flat_mesh(const hexmesh&, function_ref<void(flat_mesh&)>);
template void visit_precompiled_flat_mesh(const polyhedralmesh&, function_ref<void(flat_mesh&)>);
#endif

}  // namespace concino::detail
