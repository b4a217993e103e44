// 3D printing: regions of the plane, slices of meshes, meshes and volumes of slices, supports, build directions.
#pragma once

#include <concino/print/best_build_direction.hpp>
#include <concino/print/combine_regions.hpp>
#include <concino/print/hatch.hpp>
#include <concino/print/height_map.hpp>
#include <concino/print/heights.hpp>
#include <concino/print/layer_options.hpp>
#include <concino/print/layer_regions.hpp>
#include <concino/print/overhangs.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/region_offset.hpp>
#include <concino/print/shadow_on_plate.hpp>
#include <concino/print/slice_mesh.hpp>
#include <concino/print/slice_report.hpp>
#include <concino/print/slices_to_mesh.hpp>
#include <concino/print/slices_to_volume.hpp>
#include <concino/print/wall_thickness.hpp>
