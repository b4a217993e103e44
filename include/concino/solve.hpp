// Solvers for sparse linear systems.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/bicgstab.hpp>
#include <concino/solve/checked_solver.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>
#include <concino/solve/direct_solver_options.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>
#include <concino/solve/lu.hpp>
#include <concino/solve/multigrid.hpp>
#include <concino/solve/multigrid_options.hpp>
#include <concino/solve/qr.hpp>
#include <concino/solve/solve_columns.hpp>
