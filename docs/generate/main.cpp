// Prints what docs/ says about concepts and algorithms, found by asking the compiler: `verbs` and `algorithms` are tables, `lattice` is a graph for dot.
// `metrics` is the table of quality metrics; `convergence ...` is a table of errors, from the file that docs/convergence writes.
#include "../convergence/tables.hpp"
#include "lacking.hpp"
#include "metrics.hpp"

#include <concino/concepts/archetypes.hpp>
#include <concino/convert.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/quality.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

// Concepts: which verbs each needs.

using needs = std::vector<bool>;  // per verb

template<template<class> class Models, int Dimension>
needs needed() {
  return [&]<int... L>(std::integer_sequence<int, L...>) {
    return needs{!Models<stranger::mesh<L, Dimension>>::value...};
  }(std::make_integer_sequence<int, stranger::num_verbs>());
}

#define MODELS(name) template<class M> struct models_##name { static constexpr bool value = cn::name<M>; }
MODELS(PrimalGraph);
MODELS(DualGraph);
MODELS(SurfaceMesh);
MODELS(VolumeMesh);
MODELS(Embedded);
MODELS(MutablePoints);
MODELS(EditableSurfaceMesh);
MODELS(EditableVolumeMesh);
#undef MODELS

struct concept_row {
  const char* name;
  needs verbs;
  int dimension = 0;  // 0: either
};

std::vector<concept_row> all_concepts() {
  const needs surface = needed<models_SurfaceMesh, 2>(), volume = needed<models_VolumeMesh, 3>();
  needs both = surface;
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = surface[i] && volume[i];
  return {{"PrimalGraph", needed<models_PrimalGraph, 2>()}, {"DualGraph", needed<models_DualGraph, 2>()}, {"Embedded", needed<models_Embedded, 2>()},
          {"MutablePoints", needed<models_MutablePoints, 2>()}, {"AnyMesh", both}, {"SurfaceMesh", surface, 2}, {"VolumeMesh", volume, 3},
          {"EditableSurfaceMesh", needed<models_EditableSurfaceMesh, 2>(), 2}, {"EditableVolumeMesh", needed<models_EditableVolumeMesh, 3>(), 3}};
}

bool within(const needs& a, const needs& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] && !b[i]) return false;
  return true;
}

/// The concepts that c refines: all whose verbs it needs, but for those that another of them brings.
std::vector<const concept_row*> refined(const std::vector<concept_row>& all, const concept_row& c) {
  std::vector<const concept_row*> below;
  for (const concept_row& d : all)
    if (&d != &c && within(d.verbs, c.verbs) && (d.dimension == 0 || d.dimension == c.dimension) && !(d.dimension == c.dimension && within(c.verbs, d.verbs))) below.push_back(&d);
  std::vector<const concept_row*> direct;
  for (const concept_row* d : below)
    if (std::none_of(below.begin(), below.end(), [&](const concept_row* x) { return x != d && within(d->verbs, x->verbs) && d->dimension <= x->dimension; })) direct.push_back(d);
  return direct;
}

void print_verbs() {
  const auto all = all_concepts();
  fmt::print("| concept | refines | and needs |\n|---|---|---|\n");
  for (const concept_row& c : all) {
    needs rest = c.verbs;
    std::string names, verbs;
    for (const concept_row* d : refined(all, c)) {
      names += (names.empty() ? "`" : ", `") + std::string(d->name) + "`";
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] && !d->verbs[i];
    }
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (rest[i]) verbs += (verbs.empty() ? "`" : ", `") + std::string(stranger::verbs[i]) + "`";
    fmt::print("| `{}` | {} | {} |\n", c.name, names, verbs);
  }
}

// Algorithms: on which archetypes each compiles.

/// Descriptors, of what has none those of no mesh.
template<class M> struct verts_of { using type = cn::vert_id; };
template<class M>
  requires requires { typename cn::vert_t<M>; }
struct verts_of<M> { using type = cn::vert_t<M>; };
template<class M> struct polys_of { using type = cn::poly_id; };
template<class M>
  requires requires { typename cn::poly_t<M>; }
struct polys_of<M> { using type = cn::poly_t<M>; };

using surface = cn::polygonmesh;
using volume = cn::polyhedralmesh;
template<class M> using primal = decltype(cn::only_primal_graph(std::declval<const M&>()));
template<class M> using embedded_graph = decltype(cn::only_embedded_graph(std::declval<const M&>()));
template<class M> using dual = decltype(cn::only_dual_graph(std::declval<const M&>()));
template<class M> using graphs = decltype(cn::only_graphs(std::declval<const M&>()));
template<class M> using mesh = decltype(cn::only_mesh(std::declval<const M&>()));
template<class M> using embedded_mesh = decltype(cn::only_embedded_mesh(std::declval<const M&>()));

/// The weakest of what compiles, in words; `runs` is asked of archetypes.
template<class Runs>
std::string weakest(const Runs& runs) {
  const auto on = [&]<class M>(std::type_identity<M> m) { return runs(m); };
  std::vector<std::string> names;
  const bool p = on(std::type_identity<primal<surface>>()), d = on(std::type_identity<dual<surface>>());
  if (p) names.push_back("`PrimalGraph`");
  if (d) names.push_back("`DualGraph`");
  if (!p && on(std::type_identity<embedded_graph<surface>>())) names.push_back("`PrimalGraph` and `Embedded`");
  if (names.empty() && on(std::type_identity<graphs<surface>>())) names.push_back("`PrimalGraph` and `DualGraph`");
  if (names.empty()) {
    const bool s = on(std::type_identity<mesh<surface>>()), w = on(std::type_identity<mesh<volume>>());
    if (s || w) names.push_back(s && w ? "`AnyMesh`" : s ? "`SurfaceMesh`" : "`VolumeMesh`");
    if (!s && !w) {
      const bool es = on(std::type_identity<embedded_mesh<surface>>()), ew = on(std::type_identity<embedded_mesh<volume>>());
      if (es || ew) names.push_back(std::string(es && ew ? "`AnyMesh`" : es ? "`SurfaceMesh`" : "`VolumeMesh`") + " and `Embedded`");
    }
  }
  std::string all;
  for (const std::string& n : names) all += (all.empty() ? "" : " or ") + n;
  return all.empty() ? "?" : all;
}

#define ALGORITHM(text, ...)                                                                        \
  fmt::print("| `{}` | {} |\n", text, weakest([]<class M>(std::type_identity<M>) {                   \
    using vert = typename verts_of<M>::type;                                                        \
    using poly = typename polys_of<M>::type;                                                        \
    return requires(const M& m, vert v, poly p, double (*length)(vert, vert)) { __VA_ARGS__; };     \
  }))

void print_algorithms() {
  fmt::print("| algorithm | needs |\n|---|---|\n");
  ALGORITHM("bfs(m, vert)", cn::bfs(m, v));
  ALGORITHM("bfs(m, poly)", cn::bfs(m, p));
  ALGORITHM("dijkstra(m, vert, length)", cn::dijkstra(m, v, length));
  ALGORITHM("dijkstra(m, vert)", cn::dijkstra(m, v));
  ALGORITHM("dijkstra(m, poly)", cn::dijkstra(m, p));
  ALGORITHM("shortest_path(m, vert, vert)", cn::shortest_path(m, v, v));
  ALGORITHM("connected_components(m)", cn::connected_components(m));
  ALGORITHM("connected_components(dual(m))", cn::connected_components(cn::dual(m)));
  ALGORITHM("spanning_tree(m)", cn::spanning_tree(m));
  ALGORITHM("boundary_loops(m)", cn::boundary_loops(m));
  ALGORITHM("homology_generators(m)", cn::homology_generators(m));
  ALGORITHM("measure(m, poly)", cn::measure(m, p));
  ALGORITHM("total_measure(m)", cn::total_measure(m));
  ALGORITHM("centroid(m, poly)", cn::centroid(m, p));
  ALGORITHM("quality(m, metric)", cn::quality(m, cn::metric::mean_ratio));
  ALGORITHM("laplacian(m)", cn::laplacian(m));
  ALGORITHM("laplacian(m, uniform)", cn::laplacian(m, cn::uniform));
  ALGORITHM("mass_matrix(m)", cn::mass_matrix(m));
  ALGORITHM("harmonic_map(m, {{vert, 0.0}, {vert, 1.0}})", cn::harmonic_map(m, {{v, 0.0}, {v, 1.0}}));
  ALGORITHM("harmonic_map(m, {{vert, 0.0}, {vert, 1.0}}, uniform)", cn::harmonic_map(m, {{v, 0.0}, {v, 1.0}}, cn::uniform));
  ALGORITHM("check_laws(m)", cn::check_laws(m));
  ALGORITHM("validate(m)", cn::validate(m));
  ALGORITHM("convert<To>(m)", requires(requires { cn::convert<cn::polygonmesh>(m); } || requires { cn::convert<cn::polyhedralmesh>(m); }));
}

// The figure: concepts above what they refine, meshes above what they model.

template<class M>
void print_mesh(const char* name) {
  const std::pair<const char*, bool> models[] = {{"TriMesh", cn::TriMesh<M>}, {"QuadMesh", cn::QuadMesh<M>}, {"TetMesh", cn::TetMesh<M>}, {"HexMesh", cn::HexMesh<M>}};
  const char* above = cn::SurfaceMesh<M> ? "SurfaceMesh" : "VolumeMesh";
  for (const auto& [concept_name, is] : models)
    if (is) above = concept_name;
  fmt::print("  {} [style=filled, fillcolor=\"#ffe9a8\"];\n  {} -> {};\n", name, above, name);
  if (cn::MutablePoints<M>) fmt::print("  MutablePoints -> {} [color=\"#999999\"];\n", name);
}

void print_lattice() {
  const auto all = all_concepts();
  fmt::print("digraph concepts {{\n  rankdir = TB;\n  node [shape=box, fontname=\"Helvetica\", style=filled, fillcolor=\"#e4e4e4\"];\n  edge [dir=none];\n");
  for (const concept_row& c : all)
    for (const concept_row* d : refined(all, c)) fmt::print("  {} -> {};\n", d->name, c.name);
  fmt::print("  SurfaceMesh -> TriMesh;\n  SurfaceMesh -> QuadMesh;\n  VolumeMesh -> TetMesh;\n  VolumeMesh -> HexMesh;\n");
  print_mesh<cn::trimesh>("trimesh");
  print_mesh<cn::quadmesh>("quadmesh");
  print_mesh<cn::polygonmesh>("polygonmesh");
  print_mesh<cn::tetmesh>("tetmesh");
  print_mesh<cn::hexmesh>("hexmesh");
  print_mesh<cn::polyhedralmesh>("polyhedralmesh");
  fmt::print("  \"your mesh\" [style=\"filled,dashed\", fillcolor=white];\n  SurfaceMesh -> \"your mesh\" [style=dashed];\n  VolumeMesh -> \"your mesh\" [style=dashed];\n}}\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "verbs") print_verbs();
  else if (what == "algorithms") print_algorithms();
  else if (what == "lattice") print_lattice();
  else if (what == "metrics") metrics::print_metrics();
  else if (what.starts_with("convergence ")) return convergence::print_table(what.substr(12)) ? 0 : 1;
  else return 1;
}
