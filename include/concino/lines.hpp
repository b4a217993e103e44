// Lines over meshes: geodesics.
#pragma once

#include <concino/lines/trace_geodesic.hpp>
