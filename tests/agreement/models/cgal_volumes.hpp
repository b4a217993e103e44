// Models: CGAL's volumes through indexed(): triangulations, complexes of their cells, linear cell complexes. CGAL constructs the mesh, so the
// native reference is a copy of it.
#pragma once

#include <concino/adapters/cgal_lcc.hpp>
#include <concino/adapters/cgal_triangulation.hpp>

#include <agreement/run.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <random>

namespace concino::agreement {

using cgal_volume_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct cgal_delaunay {
  using kind = tetmesh;
  static constexpr const char* column = "CGAL volumes";
  static constexpr const char* name = "a Delaunay triangulation";
  static constexpr bool own_inputs = true;

  template<class F>
  static void each(F&& f) {
    CGAL::Delaunay_triangulation_3<cgal_volume_kernel> t;
    std::mt19937 random(8);
    for (int i = 0; i < 40; ++i) {
      const auto place = [&] { return static_cast<double>(random() % 4096) / 4096; };
      const double x = place(), y = place(), z = place();
      t.insert(cgal_volume_kernel::Point_3(x, y, z));
    }
    const auto m = indexed(t);
    f(input<cell_arrays>{"Delaunay", {}}, general_copy(m), m);
  }
};

struct cgal_complex {
  using kind = tetmesh;
  static constexpr const char* column = "CGAL volumes";
  static constexpr const char* name = "a complex in a triangulation";
  static constexpr bool own_inputs = true;

  template<class F>
  static void each(F&& f) {
    using triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<cgal_volume_kernel>;
    CGAL::Mesh_complex_3_in_triangulation_3<triangulation> c;
    for (int k = 0; k <= 2; ++k)
      for (int j = 0; j <= 2; ++j)
        for (int i = 0; i <= 3; ++i) c.triangulation().insert(cgal_volume_kernel::Point_3(i + 0.0625 * j, j + 0.125 * k, k + 0.03125 * i));
    for (const triangulation::Cell_handle cell : c.triangulation().finite_cell_handles())
      if (CGAL::centroid(c.triangulation().tetrahedron(cell)).x() < 2) c.add_to_complex(cell, 1);
    const auto m = indexed(c);
    f(input<cell_arrays>{"complex", {}}, general_copy(m), m);
  }
};

struct cgal_cell_complex {
  using kind = polyhedralmesh;
  static constexpr const char* column = "CGAL volumes";
  static constexpr const char* name = "a linear cell complex";
  static constexpr bool own_inputs = true;

  template<class F>
  static void each(F&& f) {
    using complex = CGAL::Linear_cell_complex_for_combinatorial_map<3>;
    using point = complex::Point;
    complex c;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        const auto at = [&](int x, int y, int z) { return point(i + x, j + y + 0.125 * z, z + 0.0625 * (i + x)); };
        c.make_hexahedron(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1));
      }
    c.sew3_same_facets();
    const auto m = indexed(c);
    f(input<polyhedra_arrays>{"boxes", {}}, general_copy(m), m);
  }
};

using cgal_volumes = models<cgal_delaunay, cgal_complex, cgal_cell_complex>;

}  // namespace concino::agreement
