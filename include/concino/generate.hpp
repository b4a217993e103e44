// Meshes made from nothing, or from another mesh.
#pragma once

#include <concino/generate/grid.hpp>
