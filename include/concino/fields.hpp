// Fields: functions on the verts of a mesh, such as solutions of equations and distances.
#pragma once

#include <concino/fields/contour_tree.hpp>
#include <concino/fields/critical_points.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/fields/exact_paths.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/heat_geodesics_options.hpp>
#include <concino/fields/hodge_decomposition.hpp>
#include <concino/fields/hodge_decomposition_of_forms.hpp>
#include <concino/fields/log_map.hpp>
#include <concino/fields/normalized.hpp>
#include <concino/fields/parallel_transport.hpp>
#include <concino/fields/persistence.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/prepared_heat_geodesics.hpp>
#include <concino/fields/reeb_graph.hpp>
#include <concino/fields/regions_of_maxima.hpp>
#include <concino/fields/resample.hpp>
#include <concino/fields/simplified.hpp>
#include <concino/fields/simplified_on_cells.hpp>
#include <concino/fields/smooth.hpp>
#include <concino/fields/statistics.hpp>
#include <concino/fields/to_polys.hpp>
