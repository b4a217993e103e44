// The views that need no memory: primal(m), dual(m), with_points(m, map). Others: <concino/mesh/submesh.hpp>,
// <concino/mesh/boundary.hpp>.
#pragma once

#include <concino/concepts/views/dual.hpp>
#include <concino/concepts/views/primal.hpp>
#include <concino/concepts/views/with_points.hpp>
