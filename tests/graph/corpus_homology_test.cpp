// Generators of the first homology of real surfaces, of several genera.
#include <concino/mesh/boundary.hpp>

#include <support/corpus_meshes.hpp>
#include <support/generators.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace concino;
using namespace concino::testing;

TEST_CASE("homology_generators: are right on all closed surfaces of the corpus, of several genera") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::set<int> genera;
  for (const auto& row : rows) {
    const auto is = [&](const char* column, const char* value) { return row.column.at(column) == value; };
    if (is("boundary_loops", "n/a")) continue;  // a volume
    INFO(row.name);
    const auto m = load<polygonmesh>(row.file.string());
    if (!is("manifold", "yes") || !is("boundary_loops", "0")) {
      CHECK_THROWS_AS(homology_generators(m), invalid_mesh);
      continue;
    }
    const int genus = std::stoi(row.column.at("genus"));
    genera.insert(genus);
    check_generators(m, 2 * static_cast<std::size_t>(genus));
  }
  CHECK(genera.size() > 2);
  CONCINO_CORPUS_OR_SKIP(file, "polyhedral/eight_voronoi.hedra");
  CHECK(genera == std::set{0, 1, 3, 7, 8});
  const auto cells = load<polyhedralmesh>(file.string());
  check_generators(boundary(cells), 6);
}
