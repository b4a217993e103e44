// Meshes with fewer or better polys for the same shape.
#pragma once

#include <concino/remesh/decimate.hpp>
