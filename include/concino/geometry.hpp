// Sizes and places: points, areas, volumes, centroids, boxes.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/geometry/rgba.hpp>
#include <concino/geometry/vec3.hpp>
