// singular_edges(frames): the lines around which the frames of a volume turn.
#pragma once

#include <concino/directions/detail/frames/frame_turns.hpp>
#include <concino/directions/frame_field.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/io/skeleton_graph.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

/// The lines around which frames turn, as a graph in space.
template<class M>
struct singular_lines {
  skeleton lines;                // vert i is the centre of faces[i], for all of them; then one for each poly between
  std::vector<face_t<M>> faces;  // those that a line crosses, in the order of faces(m)
  std::vector<int> valences;     // at each: how many hexes a mesh along the frames has around the line, such as 3 or 5;
                                 // 0 if there is no such mesh, since the frames turn about a diagonal
};

/// The singular edges of a field of frames. They cross the faces around which frames turn: each frame at the verts is
/// replaced by the one of its cube that is nearest to the one before, and the first comes back as another.
/// auto lines = singular_edges(frame_field(tets)).lines;
/// Needs:  frames of frame_field, whose mesh has not changed.
/// Result: the lines, from face to face. The index of a line is (4 - valence) / 4. In a mesh of tets, lines end on the
///         boundary only. If the boundary is smooth, the sum of the indices there is its Euler characteristic.
/// Cost:   O(size of the faces).
/// Errors: none.
/// Source: Ray, Sokolov, Levy 2016, as above; the turns, Nieser, Reitebuch, Polthier 2011, "CubeCover: parameterization
///         of 3D volumes".
template<class M>
singular_lines<M> singular_edges(const frame_field_result<M>& frames) {
  const M& m = frames.verts.mesh();
  singular_lines<M> result;
  std::vector<vec3> points;
  std::vector<orthonormal_frame> around;
  for (const face_t<M> f : faces(m)) {
    around.clear();
    for (const vert_t<M> v : adj_f2v(m, f)) around.push_back(frames.verts[v]);
    const int valence = around.empty() ? 4 : detail::valence_of_loop(around, normal(m, f));
    if (valence == 4) continue;
    result.faces.push_back(f), result.valences.push_back(valence);
    points.push_back(centroid(m, f));
  }
  std::vector<std::vector<vert_id>> faces_of(poly_index_bound(m));
  for (std::size_t i = 0; i < result.faces.size(); ++i)
    for (const poly_t<M> p : adj_f2p(m, result.faces[i])) faces_of[index_of(m, p)].push_back(vert_id{i});
  std::vector<std::array<vert_id, 2>> lines;
  for (const poly_t<M> p : polys(m)) {
    const auto& at = faces_of[index_of(m, p)];
    if (at.empty()) continue;
    vec3 mean;
    for (const vert_id v : at) {
      mean += points[v.raw()] / static_cast<double>(at.size());
      lines.push_back({v, vert_id{points.size()}});
    }
    points.push_back(mean);
  }
  result.lines = skeleton(std::move(points), std::move(lines));
  return result;
}

}  // namespace concino
