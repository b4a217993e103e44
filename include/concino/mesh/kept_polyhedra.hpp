// kept_polyhedra: what tables of polyhedra have in common with earlier ones.
#pragma once

#include <cstdint>
#include <vector>

namespace concino {

/// The verts, faces and polys of tables that are also in new ones. There they come first, in the order that they had; others follow. All faces of a kept poly
/// are kept, and so are all verts of a kept face.
struct kept_polyhedra {
  static constexpr std::uint32_t none = ~0u;

  std::vector<std::uint32_t> verts, faces, polys;  // by number before: the number now, or none
  std::uint32_t num_verts = 0, num_faces = 0, num_polys = 0;
  std::vector<std::uint32_t> edges;                // result: the same for edges; an edge is kept if there is one between the same verts
};

}  // namespace concino
