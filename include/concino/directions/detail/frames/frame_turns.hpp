// The turn of frames around a face.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/frames/octahedral.hpp>

#include <span>

namespace concino::detail {

/// How many hexes a mesh along the frames has around a line through a polygon: 4, fewer if the frames turn with the
/// loop, more if against it. 0 if they turn about no vector of the frame.
/// frames: at the verts of the polygon. normal: on the side from which the verts are counter-clockwise.
int valence_of_loop(std::span<const orthonormal_frame> frames, const vec3& normal);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/frames/frame_turns.ipp>
#endif
