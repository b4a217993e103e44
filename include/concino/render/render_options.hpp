// How a picture is made: its size, camera, light, ground and fineness.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>
#include <concino/render/axes.hpp>
#include <concino/render/color.hpp>
#include <concino/render/labels.hpp>
#include <concino/render/legend.hpp>
#include <concino/render/view.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace concino {

struct render_options {
  std::size_t width = 1600, height = 1200;  // pixels, 1 to 65535 each
  view camera = {};                           // a concino::camera, a named view such as camera::isometric, or
                                              // view_options
  int samples = 3;                          // per pixel along each axis, 1 to 32: 3 means 9 samples
  int occlusion_rays = 36;                  // rays per pixel to estimate the visible sky, at least one for each sample;
                                            // 0: none; at most 2^20
  double occlusion_distance = 0.9;          // above 0: surfaces farther away do not occlude the sky, in half diagonals
                                            // of the bounding box
  bool ground = true;                       // adds a plane under the lowest point, which receives shadows; visible only
                                            // from above
  vec3 up = {0, 1, 0};                      // away from the ground; of any length but 0
  vec3 light = {-0.55, 0.9, 0.75};          // towards the light, in the frame of the camera: right, up, back; of any
                                            // length but 0
  double light_size = 9;                    // angular radius in degrees, in [0, 90); larger lights give softer shadows
  rgb background = {1, 1, 1};               // also the colour of the ground
  bool transparent_background = false;      // of background and ground only the shadow is drawn; the image then has
                                            // opacities
  std::string title = {};                   // at the upper edge, in UTF-8
  legend_options legend = {};               // of the first thing with values or labels; drawn if it has a title or a
                                            // unit, or if legend.show is true
  std::optional<axes_options> axes = {};    // drawn if given: axes_options{}
  label_options labels = {};                // of the texts at points of the scene
  concino::progress progress = {};          // called with the fraction done and "rendering"
  concino::profiler* profiler = nullptr;    // measures the call and its steps
};

}  // namespace concino
