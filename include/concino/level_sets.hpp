// Level sets: iso-lines of surfaces, iso-surfaces of volumes, slices, clipped meshes, measures between values,
// embedding.
#pragma once

#include <concino/level_sets/clip.hpp>
#include <concino/level_sets/clip_options.hpp>
#include <concino/level_sets/embed.hpp>
#include <concino/level_sets/embed_path.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/level_sets/measure_between.hpp>
#include <concino/level_sets/slice.hpp>
#include <concino/level_sets/to_verts.hpp>
