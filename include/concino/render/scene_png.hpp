// Pictures of scenes as PNG files.
#pragma once

#include <concino/render/png.hpp>
#include <concino/render/render.hpp>

#include <string>

namespace concino {

/// Renders a scene and writes the picture as a PNG file: save_png(s, "a.png", {.camera = camera::isometric}).
/// Needs:  as render.
/// Result: the file at `path` is the old one or the whole new one, never a part.
/// Cost:   as render and png_bytes.
/// Errors: as render; io_error if the file cannot be written.
template<RayTracer T = box_tree_tracer>
void save_png(const scene& s, const std::string& path, const render_options& options = {}, const T& tracer = {}) {
  save_png(render(s, options, tracer), path);
}

}  // namespace concino
