// A limit on the size of the adjacencies of polyhedra.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <cstdint>
#include <string_view>

namespace concino {

/// Rejects polyhedra whose adjacencies would be far longer than their input lists. Real volumes are far from this
/// limit: if each face has one or two polys, the adjacencies are at most twice as long. Only meshes with a face that
/// has more than 16 verts and more than 16 polys are rejected.
/// Needs:  poly_corners: the verts of all faces, a face counted for every poly that has it; face_corners: each face
///         counted once; poly_faces: the number of faces of all polys; before: how the message begins.
/// Result: nothing.                                                                Cost: O(1).
/// Errors: unsupported if they are too long.
inline void check_poly_corners(std::uint64_t poly_corners, std::uint64_t face_corners, std::uint64_t poly_faces,
                               std::string_view before) {
  constexpr std::uint64_t always = 1 << 20, times = 16;
  if (poly_corners > always + times * (face_corners + poly_faces))
    core::throw_joined<unsupported>({before, "large faces belong to so many polys that the adjacencies would have ",
                                     poly_corners, " entries for input lists of ", face_corners + poly_faces,
                                     "; a face of more than ", times, " verts should belong to at most ", times,
                                     " polys"});
}

}  // namespace concino
