#include <concino/adapters/span.hpp>

#include <support/input_arrays.hpp>
#include <support/models.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class P, class F> concept makes_tri = requires(P&& p, F&& f) { view_tri(static_cast<P&&>(p), static_cast<F&&>(f)); };
using doubles = std::vector<double>;
using ints = std::vector<int>;
template<class T> using span = std::span<T>;
template<class P, class F> using tri_of = decltype(view_tri(std::declval<P>(), std::declval<F>()));

/// The flat array as rows of N values.
template<std::size_t N, class T>
std::vector<std::array<T, N>> in_rows(const std::vector<T>& flat) {
  std::vector<std::array<T, N>> r(flat.size() / N);
  for (std::size_t i = 0; i < flat.size(); ++i) r[i / N][i % N] = flat[i];
  return r;
}

template<class Case> std::string message(Case&& f) {
  try {
    f();
  } catch (const invalid_mesh& e) {
    return e.what();
  }
  return "none";
}

/// A user's point type.
struct single_point {
  float at[3];
  float& operator[](int i) { return at[i]; }
  float operator[](int i) const { return at[i]; }
};

}  // namespace

static_assert(models_in_all_forms<tri_of<span<double>, span<const int>>>(surface | embedded | mutable_points | fixed_arity));
static_assert(models_in_all_forms<tri_of<span<const double>, span<const int>>>(surface | embedded | fixed_arity));
static_assert(models_in_all_forms<tri_of<doubles&, ints&>>(surface | embedded | mutable_points | fixed_arity));
static_assert(models_in_all_forms<tri_of<const doubles&, ints&>>(surface | embedded | fixed_arity) && is_view_v<tri_of<doubles&, ints&>>);

// Temporary spans are accepted, temporary containers are not. Arrays of other types and rows of another length are rejected too.
static_assert(makes_tri<span<double>, span<int>> && makes_tri<const std::span<float, 12>, span<const std::int64_t>> && makes_tri<span<vec3>, ints&>);
static_assert(!makes_tri<doubles, ints&> && !makes_tri<doubles&, ints> && !makes_tri<const doubles, ints&> && !makes_tri<std::array<double, 9>, ints&>);
static_assert(makes_tri<std::array<double, 9>&, int (&)[3]> && makes_tri<std::vector<single_point>&, std::vector<std::array<unsigned char, 3>>&>);
static_assert(!makes_tri<ints&, ints&> && !makes_tri<doubles&, doubles&> && !makes_tri<doubles&, span<bool>> && !makes_tri<doubles&, std::vector<bool>&>);
static_assert(!makes_tri<doubles&, span<std::array<int, 4>>> && !makes_tri<span<std::array<double, 4>>, ints&> && !makes_tri<span<std::string>, ints&>);
static_assert(!makes_tri<std::vector<doubles>&, std::vector<ints>&>);  // each row has memory of its own

TEST_CASE("span: views of flat arrays and of arrays of rows equal the native meshes") {
  const auto compare = [](auto kind, auto arity, const auto& view) {
    using M = decltype(kind);
    for (const auto& arrays : {grid_arrays<M>(2), two_grids_arrays<M>(1), decltype(grid_arrays<M>(1)){}}) {
      auto a = arrays;
      a.arity = static_cast<std::uint32_t>(arity());
      const M native(a);
      const auto xyz = coordinates<double>(a.points);
      const auto flat = raws<std::uint64_t>(a.verts);
      check_same_mesh(view(span<const double>(xyz), span<const std::uint64_t>(flat)), native);
      const auto points = in_rows<3>(coordinates<float>(a.points));
      const auto lists = in_rows<static_cast<std::size_t>(arity())>(raws<short>(a.verts));
      check_same_mesh(view(points, lists), native);
    }
  };
  compare(trimesh(), std::integral_constant<int, 3>(), [](auto&& p, auto&& f) { return view_tri(p, f); });
  compare(quadmesh(), std::integral_constant<int, 4>(), [](auto&& p, auto&& f) { return view_quad(p, f); });
  compare(tetmesh(), std::integral_constant<int, 4>(), [](auto&& p, auto&& f) { return view_tet(p, f); });
  compare(hexmesh(), std::integral_constant<int, 8>(), [](auto&& p, auto&& f) { return view_hex(p, f); });
}

TEST_CASE("span: views of polygons and polyhedra equal the native meshes") {
  const auto a = two_grids_arrays<polygonmesh>(2);
  const auto indices = raws<unsigned>(a.verts);
  check_same_mesh(view_polygons(a.points, a.offsets, indices), polygonmesh(a));
  const auto b = two_grids_arrays<polyhedralmesh>(2);
  const auto face_offsets = numbers<std::size_t>(b.face_offsets), poly_offsets = numbers<std::size_t>(b.poly_offsets);
  const auto face_verts = raws<int>(b.face_verts);
  auto poly_faces = raws<int>(b.poly_faces);
  check_same_mesh(view_polyhedra(b.points, face_offsets, face_verts, poly_offsets, poly_faces, b.outward), polyhedralmesh(b));
  for (std::size_t k = 0; k < poly_faces.size(); ++k)
    if (!b.outward[k]) poly_faces[k] = ~poly_faces[k];
  check_same_mesh(view_polyhedra(b.points, face_offsets, face_verts, poly_offsets, poly_faces), polyhedralmesh(b));
}

TEST_CASE("span: views refer to the user's coordinates") {
  doubles xyz{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const int triangle[] = {0, 1, 2};
  auto m = view_tri(xyz, triangle);
  const vert_id v{1};
  xyz[5] = 4;
  CHECK(point(m, v) == vec3{1, 0, 4});
  set_point(m, v, vec3{5, 6, 7});
  CHECK(xyz == doubles{0, 0, 0, 5, 6, 7, 0, 1, 0});
  xyz = doubles(9, 2.0);  // other memory
  CHECK(point(m, v) == vec3{2, 2, 2});

  std::vector<single_point> corners{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  auto n = view_tri(span<single_point>(corners), std::span(triangle));
  set_point(n, v, std::array<double, 3>{5, 6, 7.5});
  CHECK(corners[1][2] == 7.5f);
  CHECK(point(n, v) == vec3{5, 6, 7.5});
  const std::array<std::array<double, 2>, 3> flat{{{0, 0}, {1, 0}, {0, 1}}};
  CHECK(point(view_tri(flat, triangle), v) == vec3{1, 0, 0});
}

TEST_CASE("span: errors name the poly, the index and the bound") {
  const doubles xyz(12, 0.0);
  ints corners{0, 1, 2, 0, 2, 3};
  const auto view = [&] { view_tri(xyz, corners); };
  CHECK(message(view) == "none");
  corners[5] = 4;
  CHECK(message(view) == "view_tri: poly 1 names point 4, but there are 4 points, numbered from 0");
  corners[5] = -1;
  CHECK(message(view) == "view_tri: poly 1 names point -1, but there are 4 points, numbered from 0");
  corners[5] = 2;
  CHECK(message(view) == "surface_tables: poly 1 has vert 2 twice; its verts must differ");
  corners.pop_back();
  CHECK(message(view) == "view_tri: the array of polys has 5 numbers; it needs 3 for each");
  const doubles odd(11, 0.0);
  CHECK(message([&] { view_tri(odd, corners); }) == "view_tri: the array of points has 11 numbers; it needs 3 for each");
}
