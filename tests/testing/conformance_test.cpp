// Native meshes in every state, their views, and graphs that are not meshes pass the conformance kit.
#include <concino/adapters/doctest.hpp>
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/testing/conformance.hpp>

#include <support/soups.hpp>
#include <support/user_mesh.hpp>

namespace cn = concino;

TEST_CASE_TEMPLATE("conformance: grids and soups of every kind pass", M, CONCINO_KINDS) {
  cn::check_conformance([] { return cn::testing::grid<M>(3); });
  cn::check_conformance([] {
    std::mt19937 random(11);
    return cn::testing::random_soup<M>(random, 20, 14).mesh();
  }, {.turned_polys = true});
  cn::check_conformance([] { return M(); });
}

TEST_CASE("conformance: users' meshes and archetypes pass") {
  cn::check_conformance([] { return user_mesh::surface_example(); });
  cn::check_conformance([] { return user_mesh::volume_example(); });
  const auto volume = user_mesh::volume_example();
  const auto report = cn::conformance([&] { return cn::only_primal_graph(volume); });
  CHECK_MESSAGE(report.ok(), report.text());
  CHECK(report.models == std::vector<std::string>{"PrimalGraph"});
  CHECK(report.states == std::vector<std::string>{"as constructed"});
}

TEST_CASE_TEMPLATE("conformance: views of meshes pass", M, CONCINO_KINDS) {
  const M m = cn::testing::grid<M>(3);
  cn::check_conformance([&] { return cn::submesh(m, [](cn::poly_id p) { return p.raw() % 3 != 1; }); });
  auto elsewhere = cn::make_vert_map<cn::vec3>(m);
  for (const auto v : cn::verts(m)) elsewhere[v] = 2 * cn::point(m, v);
  cn::check_conformance([&] { return cn::with_points(m, elsewhere); });
  if constexpr (cn::VolumeMesh<M>) cn::check_conformance([&] { return cn::boundary(m); });
  const auto verts_only = cn::conformance([&] { return cn::primal(m); });
  CHECK_MESSAGE(verts_only.ok(), verts_only.text());
  const auto polys_only = cn::conformance([&] { return cn::dual(m); });
  CHECK_MESSAGE(polys_only.ok(), polys_only.text());
}

TEST_CASE("conformance: additional states of the caller are checked") {
  const auto report = cn::conformance([] { return cn::testing::grid<cn::trimesh>(2); },
                                      {.states = {{"after all was removed", [](cn::trimesh& m) {
                                                     while (cn::num_polys(m) > 0) cn::remove_poly(m, *cn::polys(m).begin());
                                                   }},
                                                  {"after a mistake", [](cn::trimesh&) { throw cn::invalid_mesh("that went wrong"); }}},
                                       .algorithms = false});
  CHECK(report.states.back() == "after a mistake");
  REQUIRE(report.findings.size() == 1);
  CHECK(report.findings[0].state == "after a mistake");
  CHECK(report.text().find("KIT6, after a mistake: editing throws: that went wrong") != std::string::npos);
}
