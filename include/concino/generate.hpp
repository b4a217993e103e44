// Mesh generation: grids, boxes, spheres, tori, Voronoi meshes; dual meshes, agglomeration and subdivision of a mesh.
#pragma once

#include <concino/generate/agglomerate.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/extrude.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/limit_points.hpp>
#include <concino/generate/random_labels.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/revolve.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/subdivide_1_to_4.hpp>
#include <concino/generate/subdivide_1_to_8.hpp>
#include <concino/generate/subdivide_barycentric.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/subdivide_loop.hpp>
#include <concino/generate/subdivide_midpoint.hpp>
#include <concino/generate/subdivide_options.hpp>
#include <concino/generate/subdivide_root3.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
