// Linear systems.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/qp.hpp>
