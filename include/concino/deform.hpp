// Deformation: cages, skinning, and shapes that bend by handles.
#pragma once

#include <concino/deform/affine_map.hpp>
#include <concino/deform/biharmonic_deform.hpp>
#include <concino/deform/bounded_biharmonic_weights.hpp>
#include <concino/deform/cage_coordinates.hpp>
#include <concino/deform/cage_weights.hpp>
#include <concino/deform/deform_options.hpp>
#include <concino/deform/green_coordinates.hpp>
#include <concino/deform/harmonic_coordinates.hpp>
#include <concino/deform/heat_weights.hpp>
#include <concino/deform/laplacian_deform.hpp>
#include <concino/deform/prepare_deform.hpp>
#include <concino/deform/skin.hpp>
#include <concino/deform/skin_weights.hpp>
