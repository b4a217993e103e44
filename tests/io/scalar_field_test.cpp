#include <concino/io/scalar_field.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("scalar fields: reading gives the same values to the last bit", M, CONCINO_KINDS) {
  const temporary_folder folder;
  const M m = two_grids<M>(2);
  auto u = make_vert_map<double>(m);
  double x = 1;
  for (const auto v : verts(m)) u[v] = x = std::fmod(x * 16807.1, 1.0) * std::pow(10, std::fmod(x * 4242, 30) - 15);
  u[vert_id{0}] = std::numeric_limits<double>::infinity();
  u[vert_id{1}] = -0.0;
  u[vert_id{2}] = std::numeric_limits<double>::denorm_min();
  u[vert_id{3}] = std::nan("");
  save_field(m, u, folder / "u.txt");
  const auto back = load_field(m, folder / "u.txt");
  for (const auto v : verts(m)) CHECK((back[v] == u[v] || (std::isnan(back[v]) && std::isnan(u[v]))));
  CHECK(std::signbit(back[vert_id{1}]));
  CHECK(folder.num_files() == 1);
}

TEST_CASE("scalar fields: the text has the documented form, also for a graph with only verts") {
  const temporary_folder folder;
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto g = only_primal_graph(m);
  auto u = make_vert_map<int>(g, 4);
  u[g.vert(vert_id{1})] = -7;
  save_field(g, u, folder / "u.txt");
  CHECK(read_file(folder / "u.txt") == "SCALAR_FIELD 3\n4\n-7\n4\n");
  CHECK(load_field(g, folder / "u.txt")[g.vert(vert_id{1})] == -7);
  write_file(folder / "one_line.txt", "  SCALAR_FIELD 3 1.5 +2 3e1");
  CHECK(load_field(m, folder / "one_line.txt")[vert_id{2}] == 30);
}

TEST_CASE("scalar fields: errors name the line") {
  const temporary_folder folder;
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto line_of = [&](const char* text) {
    write_file(folder / "u.txt", text);
    try {
      load_field(m, folder / "u.txt");
    } catch (const parse_error& e) {
      return e.line;
    }
    return std::size_t{0};
  };
  CHECK(line_of("SCALAR_FIELD 3\n1\n2\n3\n") == 0);
  CHECK(line_of("VECTOR_FIELD 3\n1\n2\n3\n") == 1);
  CHECK(line_of("SCALAR_FIELD 4\n1\n2\n3\n4\n") == 1);
  CHECK(line_of("SCALAR_FIELD -1\n") == 1);
  CHECK(line_of("SCALAR_FIELD 3\n1\n2\n") == 3);
  CHECK(line_of("SCALAR_FIELD 3\n1\ntwo\n3\n") == 3);
  CHECK(line_of("SCALAR_FIELD 3\n1\n2x\n3\n") == 3);
  CHECK(line_of("SCALAR_FIELD 3\n1\n2\n3\n\n4\n") == 6);
  CHECK(line_of("") == 1);
  CHECK_THROWS_AS(load_field(m, folder / "absent.txt"), io_error);
  CHECK_THROWS_AS(save_field(m, make_vert_map<double>(m), folder / "no_folder/u.txt"), io_error);
}
