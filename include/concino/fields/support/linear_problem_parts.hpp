// The values of linear problems, and meshes scaled to a size near 1: what adapters need that solve these problems on
// several processes.
#pragma once

#include <concino/fields/detail/problems/field_values.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>
