// The order of faces in a polyMesh: inner faces by owner and neighbour, then the faces of each patch.
#pragma once

#include <concino/io/detail/cells/canonical_cells.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/write_context.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The owner of each face, the poly with the smaller number, and its neighbour.
class openfoam_order {
  flat_mesh& m_;
  const flat_polyhedra& all_;
  std::vector<std::uint8_t> outward_;  // whether a face is counter-clockwise as seen from outside its owner

 public:
  static constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> owner, neighbour;
  std::vector<std::uint32_t> inner, boundary;  // faces, in the order of the file within each patch
  std::size_t num_unused = 0;                  // faces of no poly

  /// Errors: unsupported if a face has three polys, or a poly no faces.
  openfoam_order(write_context& c, flat_mesh& m)
      : m_(m), all_(m.polyhedra()), outward_(all_.face_verts.size()), owner(all_.face_verts.size(), none),
        neighbour(all_.face_verts.size(), none) {
    std::size_t k = 0;
    for (std::uint32_t p = 0; p < m.num_polys; ++p) {
      const std::span<const face_id> faces_of_poly = all_.poly_faces[p];
      if (faces_of_poly.empty())
        c.throw_cannot_hold("polyMesh", {"poly ", m.poly_index(p), ", which has no faces"}, ".hedra");
      for (const face_id f : faces_of_poly) {
        const std::size_t i = f.raw();
        if (owner[i] == none) owner[i] = p, outward_[i] = all_.outward[k];
        else if (neighbour[i] == none) neighbour[i] = p;
        else
          c.throw_cannot_hold("polyMesh",
                              {"face ", m.face_indices.empty() ? i : m.face_indices[i], ", which has three polys"},
                              ".hedra");
        ++k;
      }
      c.report_progress();
    }
    for (std::uint32_t f = 0; f < owner.size(); ++f) {
      if (owner[f] == none) ++num_unused;
      else (neighbour[f] == none ? boundary : inner).push_back(f);
    }
    sort(inner);
    // The numbers of faces of tets and hexes depend on the order of the verts of a poly, which files do not keep.
    if (m.arity != 0) sort(boundary);
  }

  /// The verts of a face, counter-clockwise as seen from outside the owner. The first one stays the first; of tets and
  /// hexes it is the one with the smallest number.
  void verts_of(std::uint32_t f, std::vector<vert_id>& v) const {
    const std::span<const vert_id> listed = all_.face_verts[f];
    v.assign(listed.begin(), listed.end());
    if (outward_[f] == 0) std::reverse(v.begin() + 1, v.end());
    if (m_.arity != 0) rotate_to_smallest(v.data(), v.size());
  }

 private:
  void sort(std::vector<std::uint32_t>& faces) const {
    std::vector<vert_id> v, w;
    std::sort(faces.begin(), faces.end(), [&](std::uint32_t f, std::uint32_t g) {
      if (owner[f] != owner[g]) return owner[f] < owner[g];
      if (neighbour[f] != neighbour[g]) return neighbour[f] < neighbour[g];
      if (m_.arity == 0) return f < g;
      verts_of(f, v);
      verts_of(g, w);
      return v < w;
    });
  }
};

}  // namespace concino::detail
