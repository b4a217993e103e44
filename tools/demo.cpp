// A harmonic field between two far ends of any mesh, its picture and its page:  concino_demo [--print] mesh picture.png [field.txt]
// With --print, the picture has 9 samples a pixel; without, 4, in a few seconds.

#include "kind_names.hpp"
#include "ray_tracer.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cn = concino;

namespace {

using program::name_of;
using program::ray_tracer;

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
    fmt::print(stderr, "concino_demo: {}; using uniform\n", e.what());
  }
  weights = "uniform";
  return cn::harmonic_map(m, values, cn::uniform, {.progress = progress});
}

/// Writes one number per line, in the order of the verts.
template<class M, class U>
void write_field(const M& m, const U& u, const std::string& path) {
  cn::atomic_file file(path);
  fmt::memory_buffer text;
  for (const auto v : cn::verts(m)) fmt::format_to(std::back_inserter(text), "{}\n", u[v]);
  cn::text_sink out(file.descriptor(), path);
  out << std::string_view(text.data(), text.size());
  out.flush();
  file.commit();
}

template<class M, class U>
cn::scene scene_of(const M& m, const U& u, const std::vector<far_ends<M>>& ends) {
  cn::scene scene;
  scene.add(m, {.field = u, .inspect = cn::num_polys(m) < 300000, .name = "mesh"});  // a browser needs a second for each 100,000 polys
  cn::drawable& surface = scene.last();
  if (surface.polys.empty()) throw cn::invalid_mesh("the mesh has no polygon to draw");
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

template<class M>
void run(const M& m, double read, double build, bool for_print, const std::string& picture, const std::string& page, const std::string& field) {
  cn::terminal_progress line;
  stopwatch watch;
  const auto ends = ends_of_components(m);
  std::vector<std::pair<cn::vert_t<M>, double>> values;
  for (const auto& e : ends) {
    values.push_back({e.first, 0.0});
    values.push_back({e.second, 1.0});
  }
  const double choose = watch.lap();
  std::string weights;
  const auto u = solve(m, values, line, weights);
  const double solved = watch.lap();
  write_field(m, u, field);
  const double written = watch.lap();
  const cn::scene scene = scene_of(m, u, ends);
  cn::save_html(scene, page, {.title = "A harmonic field"});
  const double paged = watch.lap();
  const cn::image image = picture_of(scene, for_print, line);
  const double rendered = watch.lap();
  cn::save_png(image, picture);
  const double saved = watch.lap();

  fmt::print("{:<12}{}\n{:<12}{}\n{:<12}{}\n", "kind", name_of(m), "verts", cn::num_verts(m), "edges", cn::num_edges(m));
  if constexpr (cn::VolumeMesh<M>) fmt::print("{:<12}{}\n", "faces", cn::num_faces(m));
  fmt::print("{:<12}{}\n{:<12}{}\n{:<12}{}\n", "polys", cn::num_polys(m), "components", ends.size(), "weights", weights);
  if (!ends.empty()) {
    cn::vert_t<M> low = ends[0].first, high = low;
    for (const auto v : cn::verts(m)) {
      if (u[v] < u[low]) low = v;
      if (u[v] > u[high]) high = v;
    }
    fmt::print("{:<12}{} at vert {}, {} at vert {}\n", "extrema", u[low], cn::index_of(m, low), u[high], cn::index_of(m, high));
  }
  const std::pair<const char*, double> stages[] = {{"read", read},      {"build", build},         {"choose ends", choose},
                                                   {"solve", solved},   {"write field", written}, {"write page", paged},
                                                   {"render", rendered}, {"write PNG", saved}};
  for (const auto& [stage, time] : stages) fmt::print("{:<12}{:.3f} s\n", stage, time);
  fmt::print("{:<12}{}\n{:<12}{}\n{:<12}{}\n", "field", field, "picture", picture, "page", page);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool for_print = std::erase(words, "--print") > 0;
  if (words.size() != 2 && words.size() != 3) {
    fmt::print(stderr, "usage: concino_demo [--print] mesh picture.png [field.txt]\n");
    return 2;
  }
  const std::string path = words[0], picture = words[1];
  const std::size_t dot = picture.find_last_of("./");
  const std::string stem = dot != std::string::npos && dot > 0 && picture[dot] == '.' ? picture.substr(0, dot) : picture;
  const std::string field = words.size() == 3 ? words[2] : stem + ".txt";
  try {
    stopwatch watch, total;
    double read = 0;
    const auto mesh = [&] {
      cn::terminal_progress line;
      const auto on_progress = [&](double fraction, const char* label) {
        read += watch.lap();  // the last call comes when the whole file is read
        return line(fraction, label);
      };
      return cn::load_any(path, {.progress = on_progress});
    }();
    const double loaded = total.lap();
    std::visit([&](const auto& m) { run(m, read, loaded - read, for_print, picture, stem + ".html", field); }, mesh);
  } catch (const std::exception& e) {
    fmt::print(stderr, "concino_demo: {}\n", e.what());
    return 1;
  }
}
