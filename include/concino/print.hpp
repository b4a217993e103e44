// 3D printing: regions of the plane, slices of meshes, and meshes and volumes of slices.
#pragma once

#include <concino/print/combine_regions.hpp>
#include <concino/print/layer_regions.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/region_offset.hpp>
#include <concino/print/slice_report.hpp>
