// Geometry of meshes: points, lengths, areas, volumes, centroids, normals, angles, boxes, queries.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/circumcentre.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/geometry/corner_angles.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/hausdorff_distance.hpp>
#include <concino/geometry/lines_and_planes.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/geometry/outward_vector.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/geometry/tree_hits.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
