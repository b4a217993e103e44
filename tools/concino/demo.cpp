// concino demo: a harmonic field between two far ends of any mesh, its picture and its page.
#include "fields.hpp"
#include "kind_names.hpp"
#include "mesh_files.hpp"
#include "ray_tracer.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/render.hpp>

#include <fmt/format.h>

#include <chrono>
#include <limits>

namespace cn = concino;

namespace program {
namespace {

using seconds = std::chrono::duration<double>;

/// The seconds since construction or the last lap.
class stopwatch {
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();

 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return seconds(now - std::exchange(last_, now)).count();
  }
};

/// Two verts of one component that are far apart, and the number of verts of the component.
template<class M>
struct far_ends {
  cn::vert_t<M> first, second;
  std::size_t verts = 0;
};

template<class M>
auto farthest(const M& m, cn::vert_t<M> from) {
  const auto distance = cn::dijkstra(m, from);
  cn::vert_t<M> best = from;
  for (const auto v : cn::verts(m))
    if (distance[v] < std::numeric_limits<double>::infinity() && distance[v] > distance[best]) best = v;
  return best;
}

/// The ends of an approximately longest shortest path in every component that has edges, the largest component first: from any vert to
/// the farthest and from there to the farthest again. Distances are lengths in the largest component and hops in the others.
template<class M>
std::vector<far_ends<M>> ends_of_components(const M& m) {
  std::vector<far_ends<M>> components;
  auto component = cn::make_vert_map<std::size_t>(m, 0);
  // Breadth first, the last vert found in a component is a farthest one: from any vert, then from that one.
  cn::bfs_forest(m, {.visit = [&](cn::vert_t<M> v, int hops) {
                   if (hops == 0) components.push_back({v, v, 0});
                   components.back().first = v;
                   ++components.back().verts;
                   component[v] = components.size() - 1;
                   return true;
                 }});
  if (components.empty()) return components;
  std::vector<cn::vert_t<M>> sources;
  for (const auto& c : components) sources.push_back(c.first);
  cn::bfs(m, sources, {.visit = [&](cn::vert_t<M> v, int) {
            components[component[v]].second = v;
            return true;
          }});
  std::erase_if(components, [](const auto& c) { return c.verts == 1; });
  for (auto& c : components)
    if (c.verts > components.front().verts) std::swap(c, components.front());
  if (!components.empty()) {
    auto& largest = components.front();
    largest.first = farthest(m, largest.first);
    largest.second = farthest(m, largest.first);
  }
  return components;
}

/// Uses virtual elements, whose field does not follow the edges of the mesh. Falls back to uniform weights if a poly is degenerate.
template<class M, class D>
auto solve(const M& m, const D& values, const cn::progress& progress, std::string& weights) {
  try {
    weights = "virtual elements";
    return cn::harmonic_map(m, values, {.progress = progress});
  } catch (const cn::invalid_mesh& e) {
    say(fmt::format("{}; using uniform weights", e.what()));
  }
  weights = "uniform";
  return cn::harmonic_map(m, values, cn::uniform, {.progress = progress});
}

template<class M, class U>
cn::scene scene_of(const M& m, const U& u, const std::vector<far_ends<M>>& ends) {
  cn::scene scene;
  scene.add(m, {.field = u, .inspect = cn::num_polys(m) < 300000, .name = "mesh"});  // a browser needs a second for each 100,000 polys
  cn::drawable& surface = scene.last();
  if (surface.polys.empty()) throw failure{unreadable_input, "the mesh has no polygon to draw"};
  surface.look.scale = cn::value_scale::equalized(surface.values);
  surface.look.isobands = 30;
  if (surface.polys.size() < 12000) surface.look.edge_width = 1.3;

  const double ball = 0.013 * cn::bounding_box(m).diagonal();
  std::vector<cn::vec3> low, high;
  for (std::size_t i = 0; i < std::min<std::size_t>(ends.size(), 8); ++i) {
    low.push_back(cn::to_vec3(cn::point(m, ends[i].first)));
    high.push_back(cn::to_vec3(cn::point(m, ends[i].second)));
  }
  if (!ends.empty() && ball > 0) {
    scene.add_points(low, {.radius = ball, .color = cn::srgb(0.13f, 0.13f, 0.15f)}).last().name = "where it is 0";
    scene.add_points(high, {.radius = ball, .color = cn::srgb(0.84f, 0.13f, 0.14f)}).last().name = "where it is 1";
  }
  return scene;
}

cn::image picture_of(const cn::scene& scene, bool for_print, const cn::progress& progress) {
  cn::render_options options;
  if (!for_print) options.samples = 2, options.occlusion_rays = 8;
  options.progress = progress;
  const double aspect = static_cast<double>(options.width) / static_cast<double>(options.height);
  options.camera = cn::best_view(scene.drawables(), aspect, {}, ray_tracer{});
  return cn::render(scene, options, ray_tracer{});
}

/// The paths of what is written, and the times of the steps.
struct demo_files {
  std::string picture, page, field;
};
using step_times = std::vector<std::pair<const char*, double>>;

template<class M, class U>
void print_facts(const M& m, const U& u, const std::vector<far_ends<M>>& ends, const std::string& weights) {
  const auto line = [](const char* what, const auto& value) { fmt::print("{:<12}{}\n", what, value); };
  line("kind", name_of(m));
  line("verts", cn::num_verts(m));
  line("edges", cn::num_edges(m));
  if constexpr (cn::VolumeMesh<M>) line("faces", cn::num_faces(m));
  line("polys", cn::num_polys(m));
  line("components", ends.size());
  line("weights", weights);
  if (ends.empty()) return;
  cn::vert_t<M> low = ends[0].first, high = low;
  for (const auto v : cn::verts(m)) {
    if (u[v] < u[low]) low = v;
    if (u[v] > u[high]) high = v;
  }
  fmt::print("{:<12}{} at vert {}, {} at vert {}\n", "extrema", u[low], cn::index_of(m, low), u[high],
             cn::index_of(m, high));
}

template<class M>
void run(M& m, bool for_print, const demo_files& files, step_times& times) {
  cn::terminal_progress line;
  stopwatch watch;
  const auto ends = ends_of_components(m);
  std::vector<std::pair<cn::vert_t<M>, double>> values;
  for (const auto& e : ends) {
    values.push_back({e.first, 0.0});
    values.push_back({e.second, 1.0});
  }
  times.push_back({"choose ends", watch.lap()});
  std::string weights;
  const auto u = or_fail(unreadable_input, [&] { return solve(m, values, line, weights); });
  times.push_back({"solve", watch.lap()});
  write_field(m, u, "harmonic", files.field);
  times.push_back({"write field", watch.lap()});
  const cn::scene scene = or_fail(unreadable_input, [&] { return scene_of(m, u, ends); });
  or_fail(not_written, [&] { cn::save_html(scene, files.page, {.title = "A harmonic field"}); });
  times.push_back({"write page", watch.lap()});
  const cn::image image = or_fail(unreadable_input, [&] { return picture_of(scene, for_print, line); });
  times.push_back({"render", watch.lap()});
  or_fail(not_written, [&] { cn::save_png(image, files.picture); });
  times.push_back({"write PNG", watch.lap()});
  print_facts(m, u, ends, weights);
}

}  // namespace

int demo(const demo_options& options) {
  if (!has_extension(options.picture, ".png"))
    throw failure{wrong_usage, fmt::format("{} does not end with .png", options.picture)};
  const std::string stem = options.picture.substr(0, options.picture.size() - 4);
  const demo_files files{options.picture, stem + ".html", stem + ".txt"};
  stopwatch watch;
  auto mesh = load_mesh(options.file);
  step_times times = {{"load", watch.lap()}};
  std::visit([&](auto& m) { run(m, options.for_print, files, times); }, mesh);
  for (const auto& [step, time] : times) fmt::print("{:<12}{:.3f} s\n", step, time);
  fmt::print("{:<12}{}\n{:<12}{}\n{:<12}{}\n", "field", files.field, "picture", files.picture, "page", files.page);
  return done;
}

}  // namespace program
