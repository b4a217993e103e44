// Renders pictures of meshes. Another ray tracer may be passed, such as the adapter <concino/adapters/embree.hpp>. <concino/adapters/stb.hpp> reads
// picture files for textures.
#pragma once

#include <concino/render/ambient_occlusion.hpp>
#include <concino/render/any_field.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/arrows.hpp>
#include <concino/render/balls.hpp>
#include <concino/render/best_view.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/color.hpp>
#include <concino/render/colormap.hpp>
#include <concino/render/criterion.hpp>
#include <concino/render/drawable.hpp>
#include <concino/render/image.hpp>
#include <concino/render/label_colors.hpp>
#include <concino/render/peeled.hpp>
#include <concino/render/labels.hpp>
#include <concino/render/legend.hpp>
#include <concino/render/png.hpp>
#include <concino/render/poly_criterion.hpp>
#include <concino/render/polygon_weights.hpp>
#include <concino/render/position_criteria.hpp>
#include <concino/render/ray_caster.hpp>
#include <concino/render/render.hpp>
#include <concino/render/render_options.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/shapes.hpp>
#include <concino/render/slicing.hpp>
#include <concino/render/smooth_normals.hpp>
#include <concino/render/texture.hpp>
#include <concino/render/tubes.hpp>
#include <concino/render/value_criteria.hpp>
#include <concino/render/text.hpp>
#include <concino/render/value_scale.hpp>
#include <concino/render/view.hpp>
