// Differential operators on meshes as sparse matrices.
#pragma once

#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
