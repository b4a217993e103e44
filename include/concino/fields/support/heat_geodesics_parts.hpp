// The parts of heat_geodesics that adapters need which solve it on several processes.
#pragma once

#include <concino/fields/detail/heat/build_distance_graph.hpp>
#include <concino/fields/detail/heat/distance_bounds.hpp>
#include <concino/fields/detail/heat/distance_constants.hpp>
#include <concino/fields/detail/heat/euclidean_distance.hpp>
#include <concino/fields/detail/heat/geodesic_preparation.hpp>
#include <concino/fields/detail/heat/geodesic_sources.hpp>
#include <concino/fields/detail/heat/heat_matrix.hpp>
#include <concino/fields/detail/heat/heat_preparation.hpp>
#include <concino/fields/detail/heat/rescaled_heat.hpp>
