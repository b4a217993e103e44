// What is drawn over a picture of a scene: its title, legend, axes and labels; and the camera that leaves room for
// them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/image.hpp>
#include <concino/render/render_options.hpp>
#include <concino/render/scene.hpp>

#include <span>

namespace concino::detail {

/// The camera of options for things to frame. Unless it is given, it leaves room beside and above them for the title,
/// the legend and the axes of a scene.
/// Errors: as view::of; invalid_argument if the legend is wanted and nothing in the scene has values or labels.
camera camera_of(std::span<const drawable> framed, const scene& s, const render_options& options);

/// Errors: invalid_argument if the legend is wanted and nothing in the scene has values or labels, or an option is out
///         of its range.
void draw_overlays(image& picture, const camera& from, const scene& s, std::span<const point_label> visible_labels,
                   const render_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/overlays/overlays.ipp>
#endif
