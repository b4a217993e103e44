// concino validate: the defects of a mesh, in sentences.
#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/validate/validate.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <limits>

namespace program {

int validate(const validate_options& options) {
  return std::visit(
      [&](const auto& m) -> int {
        concino::terminal_progress line;
        const std::size_t most = options.all ? std::numeric_limits<std::size_t>::max() : 5;
        const auto report = concino::validate(m, {.max_per_kind = most, .progress = line});
        fmt::print("{}", report.text());
        return report.is_clean() ? done : defects_found;
      },
      load_mesh(options.file));
}

}  // namespace program
