// UV maps: disks of any polys as parts of the plane, and how much that distorts them.
#pragma once

#include <concino/parametrize/arap_map.hpp>
#include <concino/parametrize/injective_map.hpp>
#include <concino/parametrize/lscm.hpp>
#include <concino/parametrize/map_distortion.hpp>
#include <concino/parametrize/spectral_conformal.hpp>
#include <concino/parametrize/tutte.hpp>
#include <concino/parametrize/uv_at_corners.hpp>
#include <concino/parametrize/uv_map.hpp>
