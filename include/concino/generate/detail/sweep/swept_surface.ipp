// Bodies of swept_surface.hpp: the verts and polys of a surface that moves, as flat arrays, and the volume between its
// layers.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/generate/detail/sweep/swept_surface.hpp>

namespace concino::detail {

CONCINO_INLINE std::uint32_t sweep_edges::add(const char* caller, swept_surface& s, std::size_t edge,
                                              const swept_surface::ends& ends, std::size_t poly, bool reversed) {
  user& u = users_[edge];
  if (u.number == ~0u) {
    u = {static_cast<std::uint32_t>(s.edge_ends.size()), static_cast<std::uint32_t>(poly), reversed, false};
    s.edge_ends.push_back(ends);
    return 2 * u.number;
  }
  if (u.is_full)
    core::throw_joined<invalid_mesh>(
        {caller, ": edge ", edge,
         " has more than two polys, of which two would have cells that overlap; split the surface there"});
  if (s.edge_ends[u.number] == ends) {
    if (u.reversed == reversed)
      core::throw_joined<invalid_mesh>({caller, ": polys ", u.poly, " and ", poly, " run along edge ", edge,
                                        " in the same direction; turn one of them by flip_winding()"});
    core::throw_joined<invalid_argument>(
        {caller, ": polys ", u.poly, " and ", poly, ", which share edge ", edge,
         ", move to opposite directions of their normals, so that their cells would overlap; move them apart"});
  }
  u.is_full = true;
  return 2 * u.number + 1;
}

CONCINO_INLINE void check_sweep_counts(const char* caller, const char* option, std::size_t num_layers,
                                       std::size_t num_verts, std::size_t num_polys, std::size_t num_corners) {
  const double n = static_cast<double>(num_layers), cells = n * static_cast<double>(num_polys),
               all_verts = (n + 1) * static_cast<double>(num_verts);
  // of caps and of the quads between them, one for each corner at most
  const double corners = (5 * n + 1) * static_cast<double>(num_corners);
  if (cells < 1073741823.0 && all_verts < 4294967295.0 && corners + 2 * cells < 4294967295.0) return;
  core::throw_joined<invalid_argument>({caller, ": ", option, " asks for ", core::number_text(cells), " polys and ",
                                        core::number_text(all_verts),
                                        " verts; at most 2^30 polys and 2^32 verts and corners fit"});
}

CONCINO_INLINE cell_arrays swept_hexes(const swept_surface& s, const sweep_layers& layers) {
  cell_arrays a{{}, {}, 8};
  a.verts.resize(2 * s.verts.size() * layers.num_layers);
  parallel_for(layers.num_layers, [&](std::size_t layer) {
    vert_id* next = a.verts.data() + layer * 2 * s.verts.size();
    for (std::size_t i = 0; i < s.verts.size(); i += 4)
      for (const std::size_t level : {layer, layer + 1})
        for (std::size_t k = i; k < i + 4; ++k) *next++ = layers.number(level, s.verts[k]);
  }, 1);
  return a;
}

/// The faces between the layers of a polyhedral volume: one for each edge with an end that moves.
CONCINO_INLINE std::vector<std::uint32_t> numbered_lateral_faces(const swept_surface& s, const sweep_layers& layers,
                                                                 std::uint32_t& count) {
  std::vector<std::uint32_t> number(s.edge_ends.size(), ~0u);
  count = 0;
  for (std::size_t e = 0; e < number.size(); ++e)
    if (layers.moves(s.edge_ends[e].from) || layers.moves(s.edge_ends[e].to)) number[e] = count++;
  return number;
}

CONCINO_INLINE polyhedra_arrays swept_polyhedra(const swept_surface& s, const sweep_layers& layers) {
  std::uint32_t num_lateral = 0;
  const std::vector<std::uint32_t> lateral = numbered_lateral_faces(s, layers, num_lateral);
  const std::size_t n = s.num_polys(), levels = layers.num_levels(), caps = levels * n;
  polyhedra_arrays a;
  a.face_offsets.reserve(caps + layers.num_layers * num_lateral + 1);
  a.face_verts.reserve(levels * s.verts.size() + 4 * layers.num_layers * num_lateral);
  a.face_offsets.push_back(0);
  const auto end_face = [&] { a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size())); };
  for (std::size_t level = 0; level < levels; ++level)
    for (std::size_t p = 0; p < n; ++p) {
      for (std::uint32_t i = s.offsets[p]; i < s.offsets[p + 1]; ++i)
        a.face_verts.push_back(layers.number(level, s.verts[i]));
      end_face();
    }
  for (std::size_t layer = 0; layer < layers.num_layers; ++layer)
    for (std::size_t e = 0; e < lateral.size(); ++e) {
      if (lateral[e] == ~0u) continue;
      const auto [from, to] = s.edge_ends[e];
      a.face_verts.push_back(layers.number(layer, from));
      a.face_verts.push_back(layers.number(layer, to));
      if (layers.moves(to)) a.face_verts.push_back(layers.number(layer + 1, to));
      if (layers.moves(from)) a.face_verts.push_back(layers.number(layer + 1, from));
      end_face();
    }
  a.poly_offsets.reserve(layers.num_layers * n + 1);
  a.poly_faces.reserve(layers.num_layers * (2 * n + s.edges.size()));
  a.outward.reserve(layers.num_layers * (2 * n + s.edges.size()));
  a.poly_offsets.push_back(0);
  const auto add_face = [&](std::size_t face, bool outward) {
    a.poly_faces.push_back(face_id{face}), a.outward.push_back(outward);
  };
  for (std::size_t layer = 0; layer < layers.num_layers; ++layer)
    for (std::size_t p = 0; p < n; ++p) {
      add_face(layer * n + p, false);
      add_face((layer + 1 == levels ? 0 : layer + 1) * n + p, true);
      for (std::uint32_t i = s.offsets[p]; i < s.offsets[p + 1]; ++i)
        if (const std::uint32_t face = lateral[s.edges[i] / 2]; face != ~0u)
          add_face(caps + layer * num_lateral + face, s.edges[i] % 2 == 0);
      a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
    }
  return a;
}

CONCINO_INLINE correspondence swept_origins(const swept_surface& s, const sweep_layers& layers) {
  std::vector<std::uint32_t> of_verts(layers.size()), of_polys;
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    of_verts[v] = s.vert_index[v];
    if (layers.moves(v))
      for (std::size_t level = 1; level < layers.num_levels(); ++level)
        of_verts[layers.number(level, v).raw()] = s.vert_index[v];
  }
  of_polys.reserve(s.num_polys() * layers.num_layers);
  for (std::size_t layer = 0; layer < layers.num_layers; ++layer)
    of_polys.insert(of_polys.end(), s.poly_index.begin(), s.poly_index.end());
  correspondence c;
  c.verts = element_origins(std::move(of_verts)), c.polys = element_origins(std::move(of_polys));
  return c;
}

}  // namespace concino::detail
