// Measure where a program spends its time: scopes of your own, those that functions open in a profiler, and a trace for a browser. The picture shows
// the scopes: as wide as the time in them, inside of the scopes around them.
#include <concino/core/profiler.hpp>
#include <concino/core/terminal_progress.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/smooth.hpp>
#include <concino/generate/torus.hpp>
#include <concino/mesh.hpp>
#include <concino/remesh/decimate.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

/// A picture of the entries: each is a rectangle in the one around it, with its name if there is room.
void draw(const std::vector<cn::profile_entry>& entries, const std::string& path) {
  std::vector<cn::vec3> points;
  std::vector<std::vector<unsigned>> rectangles;
  cn::scene s;
  double all = 0;
  for (const auto& e : entries) all += e.depth == 0 ? e.total : 0;
  std::vector<double> next = {0};  // by depth: where the next rectangle begins
  for (const auto& e : entries) {
    const double begin = next[e.depth], width = 12 * e.total / all, y = -static_cast<double>(e.depth);
    next.resize(e.depth + 1);
    next[e.depth] += width;
    next.push_back(begin);
    const auto first = static_cast<unsigned>(points.size());
    for (const auto& [x, up] : {std::pair{0.0, 0.0}, {width, 0.0}, {width, 0.9}, {0.0, 0.9}}) points.push_back({begin + x, y + up, 0});
    rectangles.push_back({first, first + 1, first + 2, first + 3});
    if (width > 0.9) s.add_label({begin + width / 2, y + 0.3, 0.01}, fmt::format("{}: {:.0f} %", e.name, 100 * e.total / all));
  }
  const cn::quadmesh m(points, rectangles);
  auto depth = cn::make_poly_map<double>(m);
  for (const auto p : cn::polys(m)) depth[p] = static_cast<double>(cn::index_of(m, p));
  s.add(m, {.labels = depth, .opacity = 0.8});
  cn::save_png(s, path, {.width = 900, .height = 300, .camera = cn::view_options{.towards = {0, 0, 1}, .up = {0, 1, 0}}, .samples = 4, .ground = false});
}

int main(int argc, char** argv) {
  cn::profiler p;
  {
    const auto everything = p.scope("everything");  // until the end of this block
    auto m = [&] {
      const auto s = p.scope("make a torus");
      return cn::make_torus<cn::trimesh>({.cells = {200, 100}});
    }();

    // Functions that take progress take a profiler too. In a terminal, this one also says how far it is, and how long it will take.
    const cn::vert_id a{0}, b{10050};
    const auto u = cn::harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {.progress = cn::terminal_progress(), .profiler = &p});
    const auto smoother = cn::smooth(m, u, 0.01, {.profiler = &p});
    cn::decimate(m, {.target_polys = 38000, .profiler = &p});

    for (int i = 0; i < 3; ++i) {
      const auto s = p.scope("measure");
      cn::total_measure(m);
    }
  }

  // The same in figures: each scope, inside of the one around it. Times differ, so the lesson shows calls only; p.report() has both.
  const auto entries = p.entries();
  double own = 0;
  for (const auto& e : entries) {
    fmt::print("{:>{}}{:<{}} {:2} calls\n", "", 2 * e.depth, e.name, 24 - 2 * e.depth, e.calls);
    own += e.own;
  }
  fmt::print("the own times of {} entries add up to the whole: {}\n", entries.size(), std::abs(own - entries[0].total) < 1e-6);
  p.save_trace("trace.json");  // open it in chrome://tracing or https://ui.perfetto.dev

  if (argc > 1) draw(entries, argv[1]);
}
