// Differential operators on meshes, as sparse matrices or applied without one.
#pragma once

#include <concino/operators/divergence.hpp>
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/poly_mass_matrix.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>
