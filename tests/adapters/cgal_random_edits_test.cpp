// Random edits of CGAL::Surface_mesh by every operator: numbers of elements, areas and values of properties as the laws say, and refused edits change nothing.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/cgal.hpp>
#include <support/random_edits.hpp>
#include <support/random_poly_edits.hpp>

#include <CGAL/Simple_cartesian.h>

#include <random>
#include <tuple>

using namespace concino;
namespace ct = concino::testing;
using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST_CASE("CGAL: random edits by every operator") {
  std::mt19937 random(12);
  mesh m = ct::cgal_surface<mesh::Point>(ct::triangle_grid(3));
  const auto maps_of = [](mesh& x) {
    return std::tuple(x.add_property_map<mesh::Vertex_index, int>("v:number").first, x.add_property_map<mesh::Edge_index, int>("e:number").first,
                      x.add_property_map<mesh::Face_index, int>("f:number").first);
  };
  ct::edits_of_all_kinds(m, random, ct::kept_values<decltype(maps_of)>{maps_of});
}

TEST_CASE("CGAL: random edits of polygons") {
  std::mt19937 random(13);
  const mesh m = ct::cgal_surface<mesh::Point>(ct::polygon_grid(3));
  const auto count = ct::edit_polys_at_random(m, random, ct::long_run() ? 1000000 : 10000);
  for (unsigned what = 0; what <= ct::p_collapse; ++what) CHECK_MESSAGE(count.done[what] > 0, "operator " << what);
}
