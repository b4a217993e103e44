// Edits of CGAL::Surface_mesh, their transactions and garbage_collect change nothing if memory runs out.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/cgal.hpp>
#include <support/failing_allocations.hpp>
#include <support/foreign_operators.hpp>
#include <support/foreign_poly_edits.hpp>
#include <support/ignored_leaks.hpp>
#include <support/kinds.hpp>

#include <CGAL/Simple_cartesian.h>

#include <string>

using namespace concino;
using kernel_point = CGAL::Simple_cartesian<double>::Point_3;

namespace {

/// A mesh with gaps, and with values that say which element they belong to.
template<class Value, class F>
CGAL::Surface_mesh<kernel_point> with_gaps(const F& value_of) {
  auto m = testing::cgal_surface<kernel_point>(testing::two_grids_arrays<trimesh>(2));
  using mesh = decltype(m);
  const auto of_verts = m.template add_property_map<typename mesh::Vertex_index, Value>("v:value").first;
  const auto of_polys = m.template add_property_map<typename mesh::Face_index, Value>("f:value").first;
  for (const auto v : m.vertices()) of_verts[v] = value_of(v.idx());
  for (const auto p : m.faces()) of_polys[p] = value_of(p.idx());
  for (const unsigned p : {1u, 3u, 4u}) remove_poly(m, CGAL::SM_Face_index(p));
  remove_vert(m, CGAL::SM_Vertex_index(0));
  return m;
}

template<class Value, class F>
void collects_or_changes_nothing(const F& value_of) {
  const auto start = with_gaps<Value>(value_of);
  const auto before = testing::foreign_state(start);
  auto expected = start;
  garbage_collect(expected);
  const testing::ignored_leaks of_cgal;  // properties that it cannot add or copy
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    auto m = start;
    const auto check_values = [&](const auto& map) {
      const auto of_verts = m.template property_map<CGAL::SM_Vertex_index, Value>("v:value").first;
      const auto of_polys = m.template property_map<CGAL::SM_Face_index, Value>("f:value").first;
      bool all_equal = true;
      for (const auto v : verts(start))
        if (const auto now = map(v)) all_equal = all_equal && of_verts[*now] == value_of(v.idx()) && m.point(*now) == start.point(v);
      for (const auto p : polys(start))
        if (const auto now = map(p)) all_equal = all_equal && of_polys[*now] == value_of(p.idx());
      CHECK(all_equal);
    };
    if (attempt([&] { garbage_collect(m); })) {
      CHECK(testing::foreign_state(m) == before);
      CHECK(m.number_of_removed_vertices() == start.number_of_removed_vertices());
      CHECK(m.template properties<CGAL::SM_Vertex_index>() == start.template properties<CGAL::SM_Vertex_index>());
      check_values([](auto x) { return std::optional(x); });
      const auto map = garbage_collect(m);
      CHECK_FALSE(m.has_garbage());
      check_values([&](auto x) { return map[x]; });
    }
    CHECK(testing::foreign_state(m) == testing::foreign_state(expected));
    CHECK(m.num_vertices() == num_verts(m));
    CHECK(m.num_edges() == num_edges(m));
    CHECK(m.num_faces() == num_polys(m));
    CHECK(m.is_valid(false));
    const auto v = add_vert(m, {1, 2, 3});  // the list of removed elements is empty
    CHECK(v.idx() + 1 == m.num_vertices());
    CHECK(edge_split(m, *edges(m).begin()));
    testing::foreign_laws_hold(m);
  });
  CHECK(result.failed > 20);
}

}  // namespace

TEST_CASE("CGAL: edits that run out of memory change nothing") {
  const auto m = testing::cgal_surface<kernel_point>(testing::triangle_grid(2));
  testing::edits_are_all_or_nothing(m, 3, [](const auto& f) { return testing::for_each_failing_allocation(f); });
}

TEST_CASE("CGAL: edits of polygons and chords that run out of memory change nothing") {
  const auto m = testing::cgal_surface<kernel_point>(testing::quad_grid(3));
  testing::poly_edits_are_all_or_nothing(m, [](const auto& f) { return testing::for_each_failing_allocation(f); });
}

TEST_CASE("CGAL: garbage_collect that runs out of memory changes nothing") {
  collects_or_changes_nothing<int>([](unsigned i) { return static_cast<int>(i); });
}

TEST_CASE("CGAL: garbage_collect that runs out of memory while it copies strings changes nothing") {
  collects_or_changes_nothing<std::string>([](unsigned i) { return "a long name of the element " + std::to_string(i); });
}

TEST_CASE("CGAL: property maps remain valid if memory runs out in garbage_collect, and indices are used again as before") {
  const auto start = with_gaps<int>([](unsigned i) { return static_cast<int>(i); });
  const testing::ignored_leaks of_cgal;
  testing::for_each_failing_allocation([&](const auto& attempt) {
    auto m = start;
    m.set_recycle_garbage(false);
    const auto values = m.property_map<CGAL::SM_Vertex_index, int>("v:value").first;
    const auto count = num_verts(m);
    std::size_t sum = 0, sum_after = 0;
    for (const auto v : verts(m)) sum += static_cast<std::size_t>(values[v]);
    attempt([&] { garbage_collect(m); });
    for (const auto v : verts(m)) sum_after += static_cast<std::size_t>(values[v]);
    CHECK(num_verts(m) == count);
    CHECK(sum_after == sum);
    CHECK_FALSE(m.does_recycle_garbage());
  });
}
