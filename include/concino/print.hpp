// 3D printing: overhangs, supports, thin walls, and which way up to print.
#pragma once

#include <concino/print/best_build_direction.hpp>
#include <concino/print/height_map.hpp>
#include <concino/print/overhangs.hpp>
#include <concino/print/wall_thickness.hpp>
