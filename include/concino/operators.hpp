// Differential operators on meshes, as sparse matrices or applied without one. Two alternative discretisations have
// headers of their own: virtual_refinement.hpp and de_goes.hpp.
#pragma once

#include <concino/core/product.hpp>
#include <concino/operators/corner_gradients.hpp>
#include <concino/operators/cotangent.hpp>
#include <concino/operators/discretisation.hpp>
#include <concino/operators/divergence.hpp>
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/poly_mass_matrix.hpp>
#include <concino/operators/rotated.hpp>
#include <concino/operators/simplex_gradients.hpp>
#include <concino/operators/stiffness.hpp>
#include <concino/operators/uniform.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>
#include <concino/operators/virtual_elements.hpp>
