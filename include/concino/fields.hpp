// Functions on meshes.
#pragma once

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>
