// Quality of triangles and tets.
#pragma once

#include <concino/quality/mean_ratio.hpp>
#include <concino/quality/scaled_jacobian.hpp>
