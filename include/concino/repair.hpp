// Repair of meshes: merged verts, duplicates, orientation, fans, holes, inverted and open cells.
#pragma once

#include <concino/repair/repair.hpp>
#include <concino/repair/repair_options.hpp>
#include <concino/repair/repair_result.hpp>
