// Measures pictures of 1600 x 1200 pixels, with one sample a pixel: the seconds from the mesh to the picture, and the peak of memory as a multiple of the
// mesh. Half of the pixels show the mesh; there is no ground. The library uses its own ray tracer; the peer is the library with Embree.
#include "support/check.hpp"
#include "support/heap.hpp"
#include "support/kinds.hpp"

#include <concino/geometry/bounding_box.hpp>
#include <concino/render.hpp>

#ifdef CONCINO_BENCHMARK_EMBREE
#include <concino/adapters/embree.hpp>
#endif

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace cn = concino;

cn::render_options options_for(const bench::program& p, int occlusion_rays) {
  cn::render_options o{.camera = cn::view_options{.towards = {0.3, -0.6, 1}, .margin = 0}, .samples = 1, .occlusion_rays = occlusion_rays};
  o.up = {0, 0, 1};
  o.ground = false;
  if (p.data.tiny) o.width = 64, o.height = 48;
  return o;
}

/// The part of the picture that shows the mesh.
template<class M>
double filled_part(const M& m, cn::render_options o) {
  o.occlusion_rays = 0;
  cn::scene s;
  s.add(m);
  const cn::image picture = cn::render(s, o);
  std::size_t filled = 0;
  for (std::size_t y = 0; y < o.height; ++y)
    for (std::size_t x = 0; x < o.width; ++x) filled += !(picture(x, y) == o.background);
  return static_cast<double>(filled) / static_cast<double>(o.width * o.height);
}

template<class M>
void draw(const bench::program& p, const std::string& work, const M& m, const cn::mesh_look<M>& look, const cn::render_options& o) {
  const auto with = [&](const auto& tracer) {
    return bench::seconds_of([&] {
      cn::scene s;
      s.add(m, look);
      return cn::render(s, o, tracer);
    });
  };
  std::vector<bench::contender> all = {{"concino", [&] { return with(cn::box_tree_tracer{}); }}};
#ifdef CONCINO_BENCHMARK_EMBREE
  all.push_back({"embree", [&] { return with(cn::embree{}); }});
#endif
  p.print(bench::compare(work, o.occlusion_rays > 0 ? std::min(p.rounds, 3) : p.rounds, all));
}

/// The peak of the heap while a picture is made, as a multiple of what the mesh holds after every adjacency was used.
template<class M, class Arrays>
void measure_memory(const bench::program& p, const std::string& work, const Arrays& arrays, const cn::render_options& o) {
  const std::size_t before = bench::heap::live;
  const M m(arrays);
  bench::digest_of(m);
  const std::size_t held = bench::heap::live - before;
  bench::heap::peak = bench::heap::live;
  cn::scene s;
  s.add(m);
  cn::render(s, o);
  const std::size_t peak = bench::heap::peak - before - held;
  p.print({{work, "concino", "x mesh", static_cast<double>(peak) / static_cast<double>(held), 1}});
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto arrays = [&] { return p.data.once(353, 708); };  // 499,848 triangles
    if (p.wants("render.tri500k") || p.wants("render.occlusion.tri500k")) {
      const cn::trimesh m(arrays());
      const double filled = filled_part(m, options_for(p, 0));
      if (filled < 0.5) throw std::runtime_error("render.tri500k: the mesh fills less than half of the picture: " + std::to_string(filled));
      if (p.wants("render.tri500k")) draw(p, "render.tri500k", m, {}, options_for(p, 0));
      if (p.wants("render.occlusion.tri500k")) draw(p, "render.occlusion.tri500k", m, {}, options_for(p, 64));
    }
    if (p.wants("render.slice.hex1m")) {
      const cn::hexmesh m(p.data.hex1m());
      const cn::box all = cn::bounding_box(m);
      draw(p, "render.slice.hex1m", m, {.visible = cn::below('x', (all.min.x + all.max.x) / 2)}, options_for(p, 0));
    }
    if (p.wants("render.memory.tri500k")) measure_memory<cn::trimesh>(p, "render.memory.tri500k", arrays(), options_for(p, 0));
  });
}
