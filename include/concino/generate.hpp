// Mesh generation: grids, boxes, spheres, tori, Voronoi meshes; dual meshes and agglomeration of a mesh.
#pragma once

#include <concino/generate/agglomerate.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/random_labels.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
