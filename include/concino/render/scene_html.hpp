// Scenes as pages for web browsers: one file, which needs no network and no server.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/options.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/view.hpp>

#include <cstdint>
#include <string>

namespace concino {

/// The colours of a page: as the reader's system has them, or always the same.
enum class page_theme : std::uint8_t { system, light, dark };

struct html_options {
  std::string title = {};                 // at the upper edge and in the browser's title, in UTF-8
  view camera = {};                       // where the page begins: a concino::camera, a named view, or view_options,
                                          // whose margin is not used
  vec3 up = {0, 1, 0};                    // for named views; of any length but 0
  page_theme theme = page_theme::system;  // light or dark
  bool sync = false;                      // as in save_options
};

/// Writes a scene as a page that opens in any browser with WebGL 2: save_html(s, "a.html", {.title = "bracket"}). There
/// it is turned, cut and coloured. Meshes that were added with `inspect` can be cut and picked from element by element.
/// Needs:  a scene, which may be empty. Texts in UTF-8: they are shown as text, whatever they hold. Points that are
///         finite.
/// Result: the file at `path` is the old one or the whole new one, never a part. Textures are drawn as in pictures, but
///         not on cross-sections. While the view moves, a slow browser draws fewer pixels and triangles.
/// Cost:   O(bytes of the arrays); about 100 kB, and 1.4 times these bytes. Numbers that single precision holds exactly
///         have 4 bytes, others 8.
/// Errors: invalid_argument as view::of; io_error if the file cannot be written.
void save_html(const scene& s, const std::string& path, const html_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/page/scene_html.ipp>
#endif
