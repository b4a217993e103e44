// What a mesh looks like in a picture: its colours, its lines, and which of its polys are shown.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/render/any_colors.hpp>
#include <concino/render/any_field.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/poly_criterion.hpp>
#include <concino/render/polygon_selection.hpp>

#include <optional>
#include <string>

namespace concino {

/// Options for drawing a mesh of type M. Maps and criteria are read when the mesh is added to a scene.
template<AnyMesh M>
struct mesh_look {
  any_field<M> field = {};                            // numbers at verts, polys, edges or faces: colours by `map`
  any_field<M> labels = {};                           // whole numbers at polys or faces: a colour for each, instead of
                                                      // a field
  any_colors<M> colors = {};                          // rgb or rgba at verts, polys, faces or corners, instead of field
                                                      // and labels
  colormap map = colormap::blue_to_yellow;            // for the field
  std::optional<value_scale> scale = {};              // from values to positions in the map; empty: linear over the
                                                      // finite values that are shown
  int isobands = 0;                                   // number of white bands; 0: none
  int isolines = 0;                                   // number of dark lines; 0: none
  bool edges = false;                                 // draws the edges of the mesh; edges with values are always drawn
  double edge_width = 1.3;                            // in pixels
  rgb edge_color = srgb(0.1f, 0.1f, 0.12f);
  poly_criterion<M> visible = {};                     // polys that are shown: below('x', 0.3), or a map of bool; empty:
                                                      // all
  polygon_selection<M> exposed = {};                  // more polygons that a cut laid bare, such as c.cut_faces of a
                                                      // result c of clip
  rgb color = srgb(0.80f, 0.80f, 0.82f);              // without field and labels
  rgb exposed_color = srgb(0.93f, 0.78f, 0.50f);       // of faces inside the mesh that a cut laid bare, without field
                                                       // and labels
  concino::texture texture = {};                      // drawn over these colours where there are texture coordinates
  any_texture_coordinates<M> texture_coordinates = {};  // two numbers at verts or corners
  double opacity = 1;                                 // in [0, 1]; what lies behind shows through the rest
  double shine = 1;                                   // strength of the highlights, 0 or more
  surface_material material = {};                     // daylight, or one with its own light
  double crease_angle = 60;                           // degrees, in [0, 180]: edges with a larger angle look sharp; 0:
                                                      // flat shading, 180: smooth everywhere
  bool inspect = false;                               // keeps all elements and named properties of the mesh for
                                                      // pages, where they are picked and cut: save_html
  std::string name = {};                              // of the mesh in pages, in UTF-8
};

}  // namespace concino
