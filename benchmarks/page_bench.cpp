// Measures pages of save_html in headless Chromium, on the graphics processor or in software: the seconds until a page shows its mesh, those of a picture of
// 1280 x 800 pixels at rest and while the view moves, and those of an exact cut. speed.mjs of tests/browser drives the browser.
#include "support/program.hpp"

#include <concino/convert.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

namespace cn = concino;

template<class M>
void write_page(const M& m, const std::string& path) {
  auto u = cn::make_vert_map<double>(m, 0.0);
  for (const auto v : cn::verts(m)) u[v] = std::sin(5 * cn::to_vec3(cn::point(m, v)).x);
  cn::scene s;
  s.add(m, {.field = u, .inspect = true});
  cn::save_html(s, path);
}

void measure(const bench::program& p, const std::string& name, const std::string& page) {
  const std::string command = std::string("'" CONCINO_BENCHMARK_NODE "' '" CONCINO_BENCHMARK_SPEED "' '" CONCINO_BENCHMARK_CHROMIUM "' '") + page + "'";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(::popen(command.c_str(), "r"), &::pclose);
  char step[32] = {};
  double seconds = 0;
  int steps = 0;
  for (; out && std::fscanf(out.get(), "%31s %lf", step, &seconds) == 2; ++steps)
    p.print({{std::string("page.") + step + "." + name, "concino", "s", seconds, 1}});
  if (steps != 4) throw std::runtime_error("page." + name + ": the browser failed: " + command);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    bench::use_cores(p.cores);  // the browser has several processes
    const std::size_t part = p.data.tiny ? 20 : 1;
    const auto run = [&](const std::string& name, const auto& make) {
      bool wanted = false;
      for (const char* step : {"load.", "frame.", "moving.", "cut."}) wanted = wanted || p.wants("page." + (step + name));
      if (!wanted) return;
      const std::string page = p.file(name + ".html");
      write_page(make(), page);
      measure(p, name, page);
    };
    run("tri100k", [&] { return cn::make_torus<cn::trimesh>({.cells = {316 / part, 158 / part}}); });
    run("tri1m", [&] { return cn::make_torus<cn::trimesh>({.cells = {1000 / part, 500 / part}}); });
    run("poly100k", [&] { return cn::convert<cn::polyhedralmesh>(cn::make_grid<cn::hexmesh>({.cells = {46 / part, 46 / part, 47 / part}})); });
  });
}
