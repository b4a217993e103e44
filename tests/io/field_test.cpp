#include <concino/io/field.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/dual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/obj.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// Doubles of all magnitudes, infinities and NaN included.
double any_double(std::mt19937_64& random) {
  const double special[] = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), -0.0,
                            std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), std::nan("")};
  if (random() % 8 == 0) return special[random() % 6];
  const auto x = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
  return std::isnan(x) ? 0.1 : x;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b)); }

template<class U> concept savable = requires(const U& u, const trimesh& m) { save_field(u, m, std::string()); };
static_assert(savable<vert_map<trimesh, double>> && savable<poly_map<trimesh, vec3>> && savable<vert_map<trimesh, int>>);
static_assert(!savable<edge_map<trimesh, double>> && !savable<vert_map<trimesh, std::string>>);
struct both_elements {
  double operator[](vert_id) const { return 1; }
  double operator[](poly_id) const { return 2; }
};
static_assert(!savable<both_elements>);
template<class T> concept field_loadable = requires(const trimesh& m) { load_vert_field<T>(m, std::string()); load_poly_field<T>(m, std::string()); };
static_assert(field_loadable<double> && field_loadable<float> && field_loadable<int> && field_loadable<std::int64_t> && field_loadable<std::uint8_t> &&
              field_loadable<vec3> && field_loadable<std::array<float, 3>>);
static_assert(!field_loadable<bool> && !field_loadable<std::uint64_t> && !field_loadable<std::string> && !field_loadable<long double>);

const trimesh& one_triangle() {
  static const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  return m;
}

/// The error of reading a text as a field at the verts of a triangle.
template<class T>
std::string field_error(const std::string& text) {
  const temporary_folder folder;
  write_file(folder / "u.txt", text);
  try {
    load_vert_field<T>(one_triangle(), folder / "u.txt");
  } catch (const parse_error& e) {
    return std::to_string(e.line) + ": " + e.expected + " | " + e.found;
  }
  return "none";
}

}  // namespace

TEST_CASE_TEMPLATE("fields: reading gives the same values to the last bit, at verts and polys", M, CONCINO_KINDS) {
  const temporary_folder folder;
  const M m = two_grids<M>(2);
  std::mt19937_64 random(6);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = any_double(random);
  save_field(u, m, folder / "u.txt");
  const auto back = load_vert_field<double>(m, folder / "u.txt");
  for (const auto v : verts(m)) CHECK(same_bits(u[v], back[v]));
  save_field(back, m, folder / "w.txt");
  CHECK(read_file(folder / "w.txt") == read_file(folder / "u.txt"));

  auto f = make_poly_map<float>(m);
  for (const auto p : polys(m)) f[p] = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  save_field(f, m, folder / "f.txt");
  const auto float_back = load_poly_field<float>(m, folder / "f.txt");
  for (const auto p : polys(m)) CHECK(same_bits(double{f[p]}, double{float_back[p]}));

  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) g[p] = {any_double(random), any_double(random), any_double(random)};
  save_field(g, m, folder / "g.txt");
  const auto vec_back = load_poly_field<vec3>(m, folder / "g.txt");
  for (const auto p : polys(m))
    for (std::size_t i = 0; i < 3; ++i) CHECK(same_bits(g[p][i], vec_back[p][i]));

  auto h = make_vert_map<std::array<float, 3>>(m);
  for (const auto v : verts(m)) h[v] = {0.1f, static_cast<float>(random()), -0.0f};
  save_field(h, m, folder / "h.txt");
  const auto array_back = load_vert_field<std::array<float, 3>>(m, folder / "h.txt");
  for (const auto v : verts(m)) CHECK(array_back[v] == h[v]);

  auto n = make_vert_map<std::int64_t>(m);
  for (const auto v : verts(m)) n[v] = static_cast<std::int64_t>(random());
  n[*verts(m).begin()] = std::numeric_limits<std::int64_t>::min();
  save_field(n, m, folder / "n.txt");
  const auto integer_back = load_vert_field<std::int64_t>(m, folder / "n.txt");
  for (const auto v : verts(m)) CHECK(integer_back[v] == n[v]);
  CHECK(folder.num_files() == 6);
}

TEST_CASE("fields: the text has the documented form, also for graphs with verts or polys only") {
  const temporary_folder folder;
  const trimesh& m = one_triangle();
  const auto g = only_primal_graph(m);
  auto u = make_vert_map<signed char>(g, 4);
  u[g.vert(vert_id{1})] = -7;
  save_field(u, g, folder / "u.txt");
  CHECK(read_file(folder / "u.txt") == "SCALAR_FIELD 3\n4\n-7\n4\n");
  CHECK(load_vert_field<signed char>(g, folder / "u.txt")[g.vert(vert_id{1})] == -7);
  CHECK(load_vert_field<float>(m, folder / "u.txt")[vert_id{1}] == -7);
  write_file(folder / "one_line.txt", "  SCALAR_FIELD 3 1.5 +2 3e1");
  CHECK(load_vert_field<double>(m, folder / "one_line.txt")[vert_id{2}] == 30);
  write_file(folder / "bare.txt", "inf\r\n-nan 3");
  CHECK(load_vert_field<double>(m, folder / "bare.txt")[vert_id{0}] == std::numeric_limits<double>::infinity());
  const auto d = dual(m);
  save_field(make_poly_map<vec3>(d, {1, 2.5, -3}), d, folder / "p.txt");
  CHECK(read_file(folder / "p.txt") == "VECTOR_FIELD 1\n1 2.5 -3\n");
  CHECK(load_poly_field<vec3>(d, folder / "p.txt")[poly_id{0}] == vec3{1, 2.5, -3});
  save_field(make_vert_map<std::uint64_t>(m, ~std::uint64_t{0}), m, folder / "large.txt");
  CHECK(read_file(folder / "large.txt") == "SCALAR_FIELD 3\n18446744073709551615\n18446744073709551615\n18446744073709551615\n");
}

TEST_CASE("fields: errors name the line, and both numbers of values") {
  const std::string wanted = "a value for each of the 3 verts of the mesh | ";
  CHECK(field_error<double>("SCALAR_FIELD 3\n1\n2\n3\n") == "none");
  CHECK(field_error<double>("VECTOR_FIELD 3\n1\n2\n3\n") == "1: SCALAR_FIELD, or just the values | 'VECTOR_FIELD'");
  CHECK(field_error<vec3>("SCALAR_FIELD 3\n1\n2\n3\n") == "1: VECTOR_FIELD, or just the values | 'SCALAR_FIELD'");
  CHECK(field_error<double>("SCALAR_FIELD 4\n1\n2\n3\n4\n") == "1: " + wanted + "4 values");
  CHECK(field_error<double>("SCALAR_FIELD 1000000000\n1\n") == "1: " + wanted + "1000000000 values");
  CHECK(field_error<double>("SCALAR_FIELD -1\n") == "1: the number of values | '-1'");
  CHECK(field_error<double>("SCALAR_FIELD 3\n1\n2\n") == "3: " + wanted + "2 values");
  CHECK(field_error<double>("1\n2\n") == "2: " + wanted + "2 values");
  CHECK(field_error<double>("1\n2\n3\n4\n5\n") == "4: " + wanted + "5 values");
  CHECK(field_error<double>("SCALAR_FIELD 3\n1\ntwo\n3\n") == "3: a number | 'two'");
  CHECK(field_error<double>("SCALAR_FIELD 3\n1\n2x\n3\n") == "3: a number | '2x'");
  CHECK(field_error<double>("SCALAR_FIELD 3\n1\n2\n3\n\n4\n") == "6: " + wanted + "4 values");
  CHECK(field_error<double>("") == "1: " + wanted + "0 values");
  CHECK(field_error<float>("1 2 1e39") == "1: a number in the range of floats | '1e39'");
  CHECK(field_error<std::array<float, 3>>("1 2 3\n4 5 -1e39\n7 8 9") == "2: a number in the range of floats | '-1e39'");
  CHECK(field_error<vec3>("1 2 3\n4 5 6\n7 8") == "3: " + wanted + "2 values");
  CHECK(field_error<vec3>("1 2 3\n4 5 6\n7 8 9\n1") == "4: the end of the file after 3 values | '1'");
  CHECK(field_error<int>("1 2.5 3") == "1: an integer from -2147483648 to 2147483647 | '2.5'");
  CHECK(field_error<int>("1\n2147483648 3") == "2: an integer from -2147483648 to 2147483647 | '2147483648'");
  CHECK(field_error<int>("1\n2147483647 +3") == "none");
  CHECK(field_error<std::uint8_t>("1\n-1 3") == "2: an integer from 0 to 255 | '-1'");
  CHECK_THROWS_AS(load_vert_field<double>(one_triangle(), "no_folder/absent.txt"), io_error);
  CHECK_THROWS_AS(save_field(make_vert_map<double>(one_triangle()), one_triangle(), "no_folder/u.txt"), io_error);
}

TEST_CASE("fields: the field of the corpus has the sum of its description") {
  CONCINO_CORPUS_OR_SKIP(mesh, "tri/sphere.obj");
  CONCINO_CORPUS_OR_SKIP(field, "fields/sphere_greatcircle_from_v0.txt");
  const temporary_folder folder;
  const trimesh m = load_obj<trimesh>(mesh);
  const auto u = load_vert_field<double>(m, field);
  double sum = 0;
  for (const vert_id v : verts(m)) sum += u[v];
  CHECK(sum == doctest::Approx(6642.48893888).epsilon(1e-11));
  CHECK(u[vert_id{1000}] == doctest::Approx(0.782648272638).epsilon(1e-11));
  save_field(u, m, folder / "u.txt");
  const auto back = load_vert_field<double>(m, folder / "u.txt");
  for (const vert_id v : verts(m)) CHECK(back[v] == u[v]);
  CHECK_THROWS_AS(load_poly_field<double>(m, field), parse_error);
}

TEST_CASE("fields: truncated and changed files are read or are errors") {
  std::mt19937 random(2);
  for (const std::string text : {"SCALAR_FIELD 3\n1\n-2.5e-3\n3\n", "VECTOR_FIELD 3\n1 2 3\n4 5e1 6\n7 inf -nan\n", "1 2 33"})
    for (int i = 0; i < (long_run() ? 1000 : 200); ++i) {
      std::string changed = text;
      if (i % 4 == 0) changed.resize(random() % text.size());
      else changed[random() % text.size()] = static_cast<char>(random());
      for (const std::string& error : {field_error<double>(changed), field_error<vec3>(changed), field_error<int>(changed)}) CHECK(!error.empty());
    }
}
