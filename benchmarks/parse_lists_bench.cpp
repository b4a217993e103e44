// Measures the readers of fields, slices and skeletons, in megabytes of text per second. Fields are read from a file, the others from memory.
#include "support/parse.hpp"

#include <concino/io/field.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/slices.hpp>
#include <concino/mesh.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

namespace {

void measure_fields(const bench::program& p) {
  const auto measure = [&]<class T>(const char* name, const concino::trimesh& m, auto value, T) {
    if (!p.wants(std::string("parse.") + name)) return;
    auto u = concino::make_vert_map<T>(m);
    for (const concino::vert_id v : concino::verts(m)) u[v] = value(concino::point(m, v));
    const std::string path = p.file("field.txt");
    concino::save_field(u, m, path, {.sync = false});
    std::ifstream in(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    bench::measure_parse(p, name, text, false, [&] { return concino::load_vert_field<T>(m, path); });
  };
  const concino::trimesh m(p.data.tri1m());
  measure("field.scalars", m, [](const concino::vec3& x) { return x.x * x.y + std::sin(x.z); }, 0.0);
  measure("field.vectors", m, [](const concino::vec3& x) { return 0.7 * x; }, concino::vec3());
}

/// Layers of 20 circles with 500 points each, and hatches.
concino::slices circles(int layers) {
  concino::slices s;
  s.units = 0.01;
  std::vector<concino::slice_point> points(500);
  for (int k = 0; k < layers; ++k) {
    concino::slice_layer& layer = s.layers.emplace_back();
    layer.z = 0.1 * k;
    for (int c = 0; c < 20; ++c) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(points.size());
        points[i] = {30 * c + 10 * std::cos(angle), 10 * std::sin(angle) + 0.01 * k};
      }
      layer.outer.push_back(points, c + 1);
      layer.hatches.push_back(std::span(points).first(100), c + 1);
    }
  }
  return s;
}

void measure_slices(const bench::program& p) {
  const concino::slices s = circles(p.data.tiny ? 2 : 100);
  for (const bool binary : {false, true}) {
    const std::string name = binary ? "cli-binary" : "cli";
    if (!p.wants("parse." + name)) continue;
    const std::string text = concino::save_slices_text(s, {.binary = binary});
    bench::measure_parse(p, name, text, binary, [&] { return concino::load_slices_text(text).layers.size(); });
  }
}

/// A tree: each node but the first is joined with one of the ten before it.
concino::skeleton tree(std::uint32_t n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  std::vector<concino::vec3> points(n);
  std::vector<double> radii(n);
  std::vector<std::array<concino::vert_id, 2>> edges;
  for (std::uint32_t i = 0; i < n; ++i) {
    points[i] = {number(random), number(random), number(random)};
    radii[i] = number(random);
    if (i > 0) edges.push_back({concino::vert_id{i - 1 - random() % std::min(i, 10u)}, concino::vert_id{i}});
  }
  return concino::skeleton(std::move(points), std::move(edges), std::move(radii));
}

void measure_skeletons(const bench::program& p) {
  using namespace concino;
  const skeleton k = tree(p.data.tiny ? 100 : 300000);
  const auto measure = [&](auto format, const std::string& text) {
    const std::string name = std::string(format.name) + ".tree";
    if (p.wants("parse." + name)) bench::measure_parse(p, name, text, false, [&] { return load_skeleton_text(text, {.format = format}).num_verts(); });
  };
  measure(file_format::skel, save_skeleton_text(k, {.format = file_format::skel}));
  measure(file_format::cg, save_skeleton_text(k, {.format = file_format::cg}));
  // The library does not write the other two.
  text_sink skc, csv;
  skc << k.num_verts() << ' ' << k.num_edges() << '\n';
  for (const vert_id v : verts(k)) {
    const vec3& x = k.point(v);
    skc << x.x << ' ' << x.y << ' ' << x.z << '\n';
    csv << x.x << ',' << x.y << ',' << x.z << '\n';
  }
  for (const edge_id e : edges(k)) skc << k.end_verts(e)[0].raw() << ' ' << k.end_verts(e)[1].raw() << " 1 0.5 0.25 0\n";
  measure(file_format::skc, std::move(skc).release());
  measure(file_format::csv, std::move(csv).release());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    measure_fields(p);
    measure_slices(p);
    measure_skeletons(p);
  });
}
