// Read the result of a simulation, look at what it holds, compute with it, and write it back. The file has two hexes, a pyramid and a polyhedron, which is
// a pentagonal prism. Every named array of the file is a property of the mesh, and every property is written again.
#include <concino/geometry.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main() {
  cn::load_report report;
  auto m = cn::load<cn::polyhedralmesh>("beam.vtu", {.report = &report});
  fmt::print("{} verts, {} polyhedra; turned outward: {}\n", cn::num_verts(m), cn::num_polys(m), report.reoriented_polys);
  for (const cn::property_info& p : cn::property_list(m)) fmt::print("  {} property \"{}\"\n", cn::to_string(p.kind), p.name);

  // A property is found by its name and the type of its values. Its handle is a field, which every algorithm accepts.
  const auto temperature = cn::find_vert_property<double>(m, "temperature");
  const auto material = cn::find_poly_property<int>(m, "material");
  double sum = 0, total = 0;
  for (const auto p : cn::polys(m)) {
    if (material[p] != 1) continue;
    double mean = 0;
    for (const auto v : cn::adj_p2v(m, p)) mean += temperature[v] / static_cast<double>(cn::num_elements(cn::adj_p2v(m, p)));
    sum += cn::volume(m, p) * mean;
    total += cn::volume(m, p);
  }
  fmt::print("mean temperature in material 1: {:.1f}\n", sum / total);

  // A new property is one more array of the file. The gradient of a linear field is exact on every polyhedron.
  auto flux = cn::poly_property<cn::vec3>(m, "heat_flux");
  const auto gradient = cn::gradient(m, temperature);
  for (const auto p : cn::polys(m)) {
    flux[p] = -0.5 * gradient[p];
    fmt::print("heat flux along x in poly {}: {:.2f}\n", cn::index_of(m, p), flux[p].x);
  }
  cn::save(m, "beam_with_flux.vtu");
  cn::save(m, "beam_with_flux.vtk", {.binary = true, .strict = true});  // strict: better an error than a file that lacks something
  const auto again = cn::load_any("beam_with_flux.vtk");
  fmt::print("written and read again: {} properties\n", std::visit([](const auto& mesh) { return cn::property_list(mesh).size(); }, again));

  // Not every format can hold everything.
  cn::save_report lost;
  cn::save(m, "beam.hedra", {.report = &lost});
  fmt::print(".hedra loses {} properties\n", lost.lost.size());
  try {
    cn::save(m, "beam_strict.hedra", {.strict = true});
  } catch (const cn::unsupported& e) {
    fmt::print("{}\n", e.what());
  }
}
