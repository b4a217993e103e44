// Meshes with fewer or better polys for the same shape.
#pragma once

#include <concino/remesh/adaptive_size.hpp>
#include <concino/remesh/decimate.hpp>
#include <concino/remesh/improve.hpp>
#include <concino/remesh/remesh.hpp>
#include <concino/remesh/smooth_points.hpp>
