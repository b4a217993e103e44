// concino repair: mends what can be mended of a mesh, and says what it did.
#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/io/save.hpp>
#include <concino/repair.hpp>

#include <fmt/format.h>

#include <cstdio>

namespace cn = concino;

namespace program {
namespace {

template<class M>
void run(M& m, const repair_options& options) {
  cn::terminal_progress line;
  cn::repair_options how;
  how.progress = line;
  how.merge_within = options.merge;
  how.fill_holes = options.fill;
  how.orient = options.orient;
  how.split_non_manifold = options.split;
  if (options.collapse) how.degenerate = cn::degenerate_elements::collapse;
  if (options.remove_intersecting) how.intersecting = cn::intersecting_triangles::remove;
  const cn::repair_result result = or_fail(unreadable_input, [&] { return cn::repair(m, how); });
  for (const std::string& what : result.done) fmt::print("done: {}\n", what);
  for (const std::string& what : result.left) fmt::print("left: {}\n", what);
  if (result.done.empty() && result.left.empty()) fmt::print("nothing to do\n");
  cn::save_report report;
  or_fail(not_written, [&] { cn::save(m, options.to, {.report = &report, .progress = line}); });
  for (const std::string& what : report.lost) say("lost: " + what);
}

}  // namespace

int repair(const repair_options& options) {
  if (options.merge && !(*options.merge >= 0)) throw failure{wrong_usage, "--merge: the distance must be 0 or more"};
  auto mesh = load_mesh(options.from, {.collapses_repeated_verts = true});
  std::visit([&](auto& m) { run(m, options); }, mesh);
  return done;
}

}  // namespace program
