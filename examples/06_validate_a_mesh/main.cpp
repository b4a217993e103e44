// Find the defects of a mesh: validate describes each one in a sentence for the user and in a record for the program.
#include <concino/mesh.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

namespace cn = concino;

template<class M>
void tell(const char* title, const M& m) {
  const auto report = cn::validate(m);
  fmt::print("{}: {} defects\n", title, report.count());
  for (auto& defect : report) fmt::print("  {}: {}\n", cn::defect_name(defect.kind), defect.what);
  const cn::mesh_facts& f = report.facts;
  fmt::print("  {}, {}, {}; components {}, boundary loops {}, Euler characteristic {}, genus {}\n", f.manifold ? "manifold" : "not manifold",
             f.orientable ? "orientable" : "not orientable", f.closed ? "closed" : "open", f.components, f.boundary_loops, f.euler_characteristic,
             f.genus ? fmt::format("{}", *f.genus) : "undefined");
}

int main() {
  // A tent of four triangles over a square, with three mistakes: one triangle has the wrong orientation, a fifth triangle is at an edge that already
  // has two, and a vert is unused.
  const cn::trimesh tent({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}, {1, 0, 2}, {9, 9, 9}},
                         {{0, 1, 4}, {1, 2, 4}, {3, 2, 4}, {3, 0, 4}, {0, 4, 5}});
  tell("tent", tent);

  // A quad that crosses itself like a bow tie, and a square with one corner lifted.
  tell("quads", cn::quadmesh({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 1}, {3, 1, 0}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}));

  // Vert 4 lies on the wrong side of the face that the two tets share, so the second tet is inside out.
  cn::tetmesh tets({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
  tell("tets", tets);

  // A record has the descriptor of its element; options select what is checked. This repairs the inverted tet.
  for (auto& defect : cn::validate(tets, {.kinds = {cn::defect_kind::inverted_cell}})) {
    const auto p = std::get<cn::poly_id>(defect.element);
    for (auto v : cn::adj_p2v(tets, p))
      if (v == cn::vert_id{4}) cn::set_point(tets, v, cn::vec3{1, 1, 1});
  }
  tell("tets, repaired", tets);
}
