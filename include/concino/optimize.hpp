// Least squares, quadratic programmes, and systems some of whose unknowns or relations are given.
#pragma once

#include <concino/optimize/constrained.hpp>
#include <concino/optimize/least_squares.hpp>
#include <concino/optimize/qp.hpp>
#include <concino/optimize/solve_with_values.hpp>
