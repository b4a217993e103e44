// concino::tetgen: TetGen as a back end of tetrahedralize().
//
//   const auto tets = tetrahedralize(surface, tetgen, {.radius_edge = 1.4});
//
// Needs: TetGen 1.5 (Debian: libtet1.5-dev). It is under the AGPL, which then holds for a program that uses this
//        header.
#pragma once

#include <concino/adapters/detail/tetgen_call.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/tetrahedralize.hpp>

namespace concino {

/// TetGen 1.5. It can do all that tetrahedralize() can be asked for. Since it crashes on some input, it runs in a child
/// process on Linux unless options.in_process is set: the caller lives on, and gets `unsupported` with the reason. The
/// child is a copy of the caller with one thread; options.edge_length is called there, so it must not wait for other
/// threads, and what it changes is lost. For the report it is called by the caller, too. With in_process, calls must
/// not overlap: TetGen has global variables.
/// Cost:   that of TetGen, and of a copy of its result.
/// Errors: unsupported if TetGen fails, crashes, or needs more time or memory than allowed. cancelled.
/// Source: Si 2015, "TetGen, a Delaunay-based quality tetrahedral mesh generator".
struct tetgen_back_end {
  static constexpr const char* name() { return "TetGen"; }
  tetrahedralize_output tetrahedralize(const tetrahedralize_input& input, const tetrahedralize_options& options) const {
    detail::tetgen_call call(input, options);
    return options.in_process ? call.here() : call.in_child();
  }
};
inline constexpr tetgen_back_end tetgen;

}  // namespace concino
