// Lines over meshes: geodesics.
#pragma once

#include <concino/lines/karcher_mean.hpp>
#include <concino/lines/straighten.hpp>
#include <concino/lines/trace_geodesic.hpp>
