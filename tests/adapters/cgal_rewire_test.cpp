// rewire on CGAL::Surface_mesh: it does what the laws say, or refuses what half-edges cannot represent, and changes nothing then.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/cgal.hpp>
#include <support/foreign_operators.hpp>
#include <support/foreign_paths.hpp>
#include <support/kinds.hpp>

#include <CGAL/Simple_cartesian.h>

using namespace concino;
namespace ct = concino::testing;
using kernel_point = CGAL::Simple_cartesian<double>::Point_3;

static_assert(EditableSurfaceMesh<CGAL::Surface_mesh<kernel_point>> && EditableSurfaceMesh<CGAL::Surface_mesh<vec3>> && !EditableSurfaceMesh<CGAL::Surface_mesh<int>>);

TEST_CASE_TEMPLATE("CGAL: random cavities", P, CONCINO_FIRST_OF(kernel_point, vec3)) {
  std::mt19937 random(11);
  unsigned done = 0, refused = 0;
  for (unsigned round = 0; round < 8; ++round) {
    auto m = ct::cgal_surface<P>(round % 2 ? ct::triangle_grid(3) : ct::polygon_grid(4));
    for (unsigned i = 0; i < 40; ++i) {
      (ct::rewires_by_the_laws(m, ct::random_foreign_cavity(m, random)) ? done : refused) += 1;
      CHECK(m.is_valid(false));
    }
    ct::foreign_laws_hold(m);
  }
  CHECK(done > 40);
  CHECK(refused > 40);
}

TEST_CASE_TEMPLATE("CGAL: transactions leave no trace, and can be undone and done again", P, CONCINO_FIRST_OF(kernel_point, vec3)) {
  std::mt19937 random(13);
  for (unsigned round = 0; round < 5; ++round) {
    auto m = ct::cgal_surface<P>(ct::triangle_grid(2));
    ct::transactions_leave_no_trace(m, random, [](const auto& x) { CHECK(x.is_valid(false)); });
  }
}

TEST_CASE("CGAL: properties follow their elements") {
  std::mt19937 random(14);
  auto m = ct::cgal_surface<kernel_point>(ct::triangle_grid(3));
  using mesh = decltype(m);
  const auto v = m.add_property_map<mesh::Vertex_index, int>("v:number").first;
  const auto e = m.add_property_map<mesh::Edge_index, int>("e:number").first;
  const auto f = m.add_property_map<mesh::Face_index, int>("f:number").first;
  ct::values_follow(m, random, v, e, f);
  CHECK(m.does_recycle_garbage());
}

TEST_CASE("CGAL: a copy of a mesh is not part of its transaction") {
  std::mt19937 random(15);
  auto m = ct::cgal_surface<kernel_point>(ct::triangle_grid(2));
  transaction t(m);
  ct::edit_some_times(m, random, 5);
  auto copy = m;
  remove_poly(copy, *polys(copy).begin());
  const auto changed = ct::foreign_state(copy);
  t.roll_back();
  CHECK(ct::foreign_state(copy) == changed);
}

TEST_CASE("CGAL: transactions of classes that derive from Surface_mesh") {
  struct own : CGAL::Surface_mesh<kernel_point> {
    explicit own(const CGAL::Surface_mesh<kernel_point>& m) : CGAL::Surface_mesh<kernel_point>(m) {}
  };
  own m(ct::cgal_surface<kernel_point>(ct::triangle_grid(2)));
  const auto before = ct::foreign_state(m);
  {
    transaction t(m);
    CHECK(edge_split(m, *edges(m).begin()));
    CGAL::Surface_mesh<kernel_point>& base = m;
    CHECK(edge_split(base, *edges(base).begin()));  // is part of it
  }
  CHECK(ct::foreign_state(m) == before);
}

TEST_CASE("CGAL: a transaction on an empty mesh") {
  CGAL::Surface_mesh<vec3> m;
  {
    transaction t(m);
    for (int i = 0; i < 3; ++i) add_vert(m, {i, i * i, 0});
    add_poly(m, {CGAL::SM_Vertex_index(0), CGAL::SM_Vertex_index(1), CGAL::SM_Vertex_index(2)});
    CHECK(num_polys(m) == 1);
  }
  CHECK(num_verts(m) + num_edges(m) + num_polys(m) == 0);
  CHECK(m.is_valid(false));
}

TEST_CASE("CGAL: a poly that cannot be linked is refused in a transaction as without one") {
  auto m = ct::cgal_surface<kernel_point>(ct::triangle_grid(1));
  std::vector<CGAL::SM_Vertex_index> corners;
  for (const auto v : adj_p2v(m, *polys(m).begin())) corners.push_back(v);
  const auto add = [&] { add_poly(m, std::span<const CGAL::SM_Vertex_index>(corners)); };
  CHECK_THROWS_WITH_AS(add(), doctest::Contains("add_poly: poly 2 cannot be linked"), invalid_mesh);
  transaction t(m);
  CHECK_THROWS_WITH_AS(add(), doctest::Contains("add_poly: poly 2 cannot be linked"), invalid_mesh);
}

TEST_CASE_TEMPLATE("CGAL: a poly that would close one of two fans at a vert is refused", P, CONCINO_FIRST_OF(kernel_point, vec3)) {
  CGAL::Surface_mesh<P> m;
  for (unsigned i = 0; i < 6; ++i) add_vert(m, {i * 1.0, i * i * 1.0, 0});
  const auto add = [&](std::initializer_list<unsigned> list) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (const unsigned i : list) corners.emplace_back(i);
    add_poly(m, std::span<const CGAL::SM_Vertex_index>(corners));
  };
  add({0, 1, 2}), add({0, 3, 4});
  const auto before = ct::foreign_state(m);
  CHECK_THROWS_WITH_AS(add({3, 0, 4, 5}), doctest::Contains("a closed fan is the only one at its vert"), invalid_mesh);
  CHECK(ct::foreign_state(m) == before);
  remove_poly(m, CGAL::SM_Face_index(0));
  add({3, 0, 4, 5});
  ct::foreign_laws_hold(m);
}

TEST_CASE("CGAL: what cannot be linked is refused with the reason") {
  auto m = ct::cgal_surface<kernel_point>(ct::triangle_grid(6));
  const auto before = ct::foreign_state(m);
  for (const auto p : polys(m))
    CHECK_THROWS_WITH_AS(flip_winding(m, p), doctest::Contains("cannot be linked: in CGAL::Surface_mesh at most two polys share an edge, in opposite directions"), unsupported);
  const auto refused = merge_verts(m, CGAL::SM_Vertex_index(24), {CGAL::SM_Vertex_index(0)});
  CHECK(refused.reason == refusal::unsupported);
  CHECK(refused.why == "in CGAL::Surface_mesh a closed fan of polys is the only one at its vert");
  CHECK(ct::foreign_state(m) == before);
  flip_winding(m);
  ct::foreign_laws_hold(m);
}

TEST_CASE_TEMPLATE("CGAL: a path becomes edges", P, CONCINO_FIRST_OF(kernel_point, vec3)) {
  ct::embeds_a_path(ct::cgal_surface<P>(ct::triangle_grid(4)));
}

TEST_CASE_TEMPLATE("CGAL: a level set of a property map or of a map becomes edges", P, CONCINO_FIRST_OF(kernel_point, vec3)) {
  auto m = ct::cgal_surface<P>(ct::triangle_grid(4)), n = m;
  using mesh = decltype(m);
  ct::embeds_a_level_set(m, m.template add_property_map<typename mesh::Vertex_index, double>("u").first);
  ct::embeds_a_level_set(n, make_vert_map<double>(n));
  CHECK(ct::foreign_state(m) == ct::foreign_state(n));
}
