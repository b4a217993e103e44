// Options and results of clip and split.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <cstddef>
#include <vector>

namespace concino {

struct clip_options {
  bool properties = true;                // whether named properties are transferred, if m has any: interpolated at new
                                         // verts, inherited by parts
  bool convex_only = false;              // whether a poly that would be cut, but is not convex, is an error
  concino::progress progress = nullptr;  // called with the fraction done and "clipping"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// What a cut has made of polys of a mesh of type M.
template<class M>
struct clip_report {
  std::size_t cut_polys = 0;            // polys that were cut
  std::size_t concave_polys = 0;        // of these, polys that are not convex: their parts may overlap
  std::size_t inverted_parts = 0;       // parts of the result that are turned over: their measure is negative or 0
  std::vector<vert_t<M>> moved_verts;   // verts that are on the other side, since nothing but facets that two polys
                                        // share lies between them and the cut
};

/// A surface of type M, cut along a level set: the part above it, or both parts.
template<class M>
struct clipped_surface {
  polygonmesh mesh;
  correspondence from;                // the elements of the mesh before; edges of the cut have no origin unless they
                                      // are edges of that mesh
  std::vector<edge_id> cut_edges;     // the edges on the cut
  std::vector<unsigned char> above;   // by poly: 1 if it is part of {u >= value}, else 0
  clip_report<M> report;
};

/// A volume of type M, cut along a level set: the part above it, or both parts.
template<class M>
struct clipped_volume {
  polyhedralmesh mesh;
  correspondence from;                // the elements of the mesh before; faces of the cut have no origin unless they
                                      // are parts of faces of that mesh
  std::vector<face_id> cut_faces;     // the faces on the cut
  std::vector<unsigned char> above;   // by poly: 1 if it is part of {u >= value}, else 0
  clip_report<M> report;
};

}  // namespace concino
