// Functions on meshes.
#pragma once

#include <concino/fields/harmonic_map.hpp>
