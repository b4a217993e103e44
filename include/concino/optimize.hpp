// Least squares, quadratic programs, and linear systems with known values or constraints.
#pragma once

#include <concino/optimize/constrained.hpp>
#include <concino/optimize/least_squares.hpp>
#include <concino/optimize/qp.hpp>
#include <concino/optimize/qp_result.hpp>
#include <concino/optimize/solve_with_values.hpp>
