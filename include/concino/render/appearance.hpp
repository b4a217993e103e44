// The appearance of drawables: colours, iso-bands, edges, highlights.
#pragma once

#include <concino/render/color.hpp>
#include <concino/render/colormap.hpp>
#include <concino/render/surface_material.hpp>
#include <concino/render/texture.hpp>
#include <concino/render/value_scale.hpp>

namespace concino {

/// The appearance of a drawable: colours, iso-bands, edges, highlights.
struct appearance {
  rgb color = srgb(0.80f, 0.80f, 0.82f);          // if there are no values
  rgb exposed_color = srgb(0.93f, 0.78f, 0.50f);  // of polygons that a cut laid bare, if there are no values
  rgb no_value = srgb(0.55f, 0.55f, 0.55f);       // of points whose value is infinite or not a number
  colormap map = colormap::blue_to_yellow;
  value_scale scale;          // maps values to positions in the colour map
  bool labels = false;        // values are labels, whole numbers from 0: each polygon or point has the label_color of
                              // its value instead of that of the map
  int isobands = 0;           // number of white iso-bands, at equal distances of the scale; 0: none
  double band_width = 0.12;   // as a fraction of the distance between two bands, in [0, 1]
  double band_limit = 0.008;  // the maximal width of bands in the picture, as a fraction of its height, so that bands
                              // stay lines where the field is flat
  int isolines = 0;           // number of lines at equal distances of the scale, in the middles of equal parts; 0: none
  double isoline_width = 1.5;  // in pixels
  rgb isoline_color = srgb(0.1f, 0.1f, 0.12f);
  double edge_width = 0;      // lines along the edges of the mesh, in pixels; 0: none
  rgb edge_color = srgb(0.1f, 0.1f, 0.12f);  // unless edges have values, which have the colours of the map
  double edge_opacity = 0.6;  // in [0, 1]
  concino::texture texture = {};  // drawn over these colours by the texture coordinates, if there are any
  surface_material material = {};  // daylight by default
  double shine = 1;           // strength of the highlights in daylight; 0: none
  double opacity = 1;         // in [0, 1]; what lies behind shows through the rest
};

}  // namespace concino
