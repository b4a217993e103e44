// Pictures of meshes. Rays are cast by an adapter that is handed in: <concino/adapters/embree.hpp>; files are written by
// <concino/adapters/stb.hpp>.
#pragma once

#include <concino/render/ambient_occlusion.hpp>
#include <concino/render/best_view.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/color.hpp>
#include <concino/render/colormap.hpp>
#include <concino/render/drawable.hpp>
#include <concino/render/image.hpp>
#include <concino/render/polygon_weights.hpp>
#include <concino/render/ray_caster.hpp>
#include <concino/render/render.hpp>
#include <concino/render/shapes.hpp>
#include <concino/render/smooth_normals.hpp>
#include <concino/render/value_scale.hpp>
