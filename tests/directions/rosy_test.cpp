// .rosy files: round trips, every parse error with its line, bad input.
#include <concino/directions/rosy.hpp>

#include <concino/generate/icosphere.hpp>
#include <concino/io/file_text.hpp>

#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;

TEST_CASE("rosy: saved and loaded") {
  const temporary_folder folder;
  const std::string path = folder / "field.rosy";
  const rosy r{6, {{1, 0, 0}, {0.1, -1e-300, 3}, {0, 0, 0}}};
  save_rosy(r, path);
  CHECK(file_text(path).text() == "3 6\n1 0 0\n0.1 -1e-300 3\n0 0 0\n");
  const rosy again = load_rosy(path);
  CHECK(again.symmetry == 6);
  CHECK(again.vectors == r.vectors);
  save_rosy(rosy{1, {}}, path);
  CHECK(load_rosy(path).vectors.empty());
}

TEST_CASE("rosy: fields") {
  const temporary_folder folder;
  const std::string path = folder / "field.rosy";
  const auto m = icosphere(1);
  const auto f = direction_field(m, {.symmetry = 2});
  save_rosy(f, path);
  const rosy r = load_rosy(path);
  CHECK(r.symmetry == 2);
  REQUIRE(r.vectors.size() == num_verts(m));
  direction_field_options<trimesh> options{.symmetry = r.symmetry};
  for (const auto v : verts(m)) {
    CHECK(r.vectors[v.raw()] == f.direction(v));
    options.hard.push_back({v, r.vectors[v.raw()]});
  }
  const auto same = direction_field(m, options);
  for (const auto v : verts(m)) CHECK(norm(same.direction(v) - f.direction(v)) < 1e-9);
  const auto w = trivial_connection(m, {{vert_id{0}, 8}}, {.symmetry = 4});
  save_rosy(w, path);
  CHECK(load_rosy(path).vectors.size() == num_polys(m));
  CHECK(load_rosy(path).vectors[5] == w.direction(poly_id{5}));
}

TEST_CASE("rosy: parse errors have the line") {
  const auto line = [](const std::string& text) {
    try {
      (void)load_rosy_text(text);
    } catch (const parse_error& e) {
      return e.line;
    }
    return std::size_t{0};
  };
  CHECK(line("1 4\n1 2 3\n") == 0);
  CHECK(line(" 1\t4 1 2\r\n 3") == 0);
  CHECK(line("") == 1);
  CHECK(line("x 4\n") == 1);
  CHECK(line("-1 4\n") == 1);
  CHECK(line("1\n") == 1);
  CHECK(line("1 0\n1 2 3\n") == 1);
  CHECK(line("1 17\n1 2 3\n") == 1);
  CHECK(line("1 4.5\n1 2 3\n") == 1);
  CHECK(line("2 4\n1 2 3\n1 2 y\n") == 3);
  CHECK(line("2 4\n1 2 3\n1 nan 3\n") == 3);
  CHECK(line("2 4\n1 2 3\n1 2") == 3);
  CHECK(line("2 4\n1 2 3\n") == 2);
  CHECK(line("1 4\n1 2 3\n4 5 6\n") == 3);
  CHECK(line("4000000000 4\n1 2 3\n") == 2);
}

TEST_CASE("rosy: bad input") {
  const temporary_folder folder;
  const std::string path = folder / "field.rosy";
  CHECK_THROWS_AS(save_rosy(rosy{0, {}}, path), invalid_argument);
  CHECK_THROWS_AS(save_rosy(rosy{4, {{1, std::numeric_limits<double>::infinity(), 0}}}, path), invalid_argument);
  CHECK_THROWS_AS((void)load_rosy("no/such/file.rosy"), io_error);
  CHECK_THROWS_AS(save_rosy(rosy{4, {}}, "no/such/folder/field.rosy"), io_error);
}
