// What functions from slices to meshes share: kinds of material, and options.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>

namespace concino {

/// What a poly of a mesh made of slices was: the values of its property "kind".
enum class slice_kind : int { part = 0, support = 1, hatch = 2 };

struct layer_options {
  double thicken = 0;                // the radius of open lines, in units of length, 0 or more; 0: they are left out,
                                     // which the report says
  double thicken_hatches = 0;        // the same for hatches. Only what is neither part nor support becomes material of
                                     // hatches
  double chord_error = 0;            // the largest distance between the round ends of lines and their chords, in units
                                     // of length; 0: 1/100 of the radius
  concino::progress progress = {};   // called with the fraction of the layers
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

}  // namespace concino
