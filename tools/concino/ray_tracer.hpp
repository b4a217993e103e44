// What makes pictures: Embree where it is installed.
#pragma once

#ifdef CONCINO_TOOLS_EMBREE
#include <concino/adapters/embree.hpp>
#else
#include <concino/render/box_tree_tracer.hpp>
#endif

namespace program {

#ifdef CONCINO_TOOLS_EMBREE
using ray_tracer = concino::embree;
#else
using ray_tracer = concino::box_tree_tracer;  // slower, and needs no package
#endif

}  // namespace program
