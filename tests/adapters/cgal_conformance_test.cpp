// CGAL's polyhedra, directly by their ids and through indexed(m), and its triangulations pass the conformance kit.
#include <concino/adapters/cgal_polyhedron.hpp>
#include <concino/adapters/cgal_triangulation.hpp>
#include <concino/adapters/doctest.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <random>

namespace cn = concino;

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using point = kernel::Point_3;

template<class P>
P house() {  // a tetrahedron without one of its facets, and a closed one
  P m;
  m.make_tetrahedron(point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1));
  m.make_tetrahedron(point(5, 0, 0), point(6, 0, 0), point(5, 1, 0), point(5, 0, 1));
  m.make_hole(m.facets_begin()->halfedge());
  return m;
}

}  // namespace

TEST_CASE("CGAL: a polyhedron whose items carry ids conforms as it is") {
  using with_id = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3>;
  cn::check_conformance([] {
    auto m = house<with_id>();
    CGAL::set_halfedgeds_items_id(m);
    return m;
  });
}

TEST_CASE("CGAL: any polyhedron conforms through indexed()") {
  const auto m = house<CGAL::Polyhedron_3<kernel>>();
  cn::check_conformance([&] { return cn::indexed(m); });
}

TEST_CASE("CGAL: a Delaunay triangulation conforms") {
  CGAL::Delaunay_triangulation_3<kernel> t;
  std::mt19937 random(2);
  for (int i = 0; i < 60; ++i) {
    const double x = static_cast<double>(random() % 1000), y = static_cast<double>(random() % 1000), z = static_cast<double>(random() % 1000);
    t.insert(point(x, y, z));
  }
  cn::check_conformance([&] { return cn::indexed(t); });
}
