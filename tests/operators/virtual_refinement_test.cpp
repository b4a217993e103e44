#include <concino/operators/virtual_refinement.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>
#include <support/stiffness.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> Eigen::MatrixXd refined(const M& m) { return stiffness<concino::detail::virtual_refinement_element<M>>(m); }

/// A grid whose interior verts are moved, within the plane or in space.
template<class M> M pushed_grid(unsigned n) {
  auto arrays = grid_arrays<M>(n);
  const auto moved = jittered(arrays, 0.06 / n, dimension_v<M> == 3);
  const auto inside = [](double x) { return x > 0 && x < 1; };
  for (std::size_t i = 0; i < arrays.points.size(); ++i) {
    const vec3 x = arrays.points[i];
    if (inside(x.x) && inside(x.y) && (dimension_v<M> == 2 || inside(x.z))) arrays.points[i] = moved.points[i];
  }
  return M(arrays);
}

/// A C of 8 verts, which is not star-shaped: from no point both arms are visible.
surface_arrays letter_c() {
  surface_arrays s{{{0, 0, 0}, {6, 0, 0}, {6, 1, 0}, {1, 1, 0}, {1, 5, 0}, {6, 5, 0}, {6, 6, 0}, {0, 6, 0}}, {0, 8}, {}, 0};
  for (unsigned i = 0; i < 8; ++i) s.verts.push_back(vert_id{i});
  return s;
}

void add_face(polyhedra_arrays& a, std::initializer_list<unsigned> corners) {
  for (const unsigned v : corners) a.face_verts.push_back(vert_id{v});
  a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  a.poly_faces.push_back(face_id{static_cast<unsigned>(a.poly_faces.size())});
  a.outward.push_back(1);
}

/// The stiffness matrix of a polyhedron with these triangles as faces. With has_square it also has the quad 0 1 2 3, with a virtual vert in its middle.
Eigen::MatrixXd by_definition(std::vector<vec3> x, bool has_square, const std::vector<std::array<unsigned, 3>>& triangles) {
  const auto column = [](const vec3& a) { return Eigen::Vector3d(a.x, a.y, a.z); };
  const auto n = static_cast<unsigned>(x.size()), last = has_square ? n + 1 : n;
  if (has_square) x.push_back((x[0] + x[1] + x[2] + x[3]) / 4);
  Eigen::Matrix3d volumes = Eigen::Matrix3d::Zero(), scatter = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d d = column(cross(x[b] - x[a], x[c] - x[a]));
    volumes += d * d.transpose();
    right += d * d.dot(column(x[a]));
  }
  for (unsigned i = 0; i < n; ++i) mean += column(x[i]) / n;
  for (unsigned i = 0; i < n; ++i) scatter += (column(x[i]) - mean) * (column(x[i]) - mean).transpose();
  const Eigen::Vector3d within = volumes.inverse() * right, slope = scatter.inverse() * (within - mean);
  Eigen::MatrixXd values = Eigen::MatrixXd::Identity(last + 1, n), cotangents = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (unsigned i = 0; i < n; ++i) {
    if (has_square) values(n, i) = i < 4 ? 0.25 : 0;
    values(last, i) = 1.0 / n + slope.dot(column(x[i]) - mean);
  }
  for (const auto& [a, b, c] : triangles) {
    const concino::detail::simplex_weights<3> weight({vec3{within[0], within[1], within[2]}, x[a], x[b], x[c]});
    const unsigned corner[] = {last, a, b, c};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) cotangents(corner[i], corner[j]) -= weight(i, j);
  }
  return values.transpose() * cotangents * values;
}

template<class M> std::string message_for(const M& m) {
  try {
    refined(m);
  } catch (const unsupported& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("virtual refinement: a sum of squares has its minimum where expected") {
  const auto turned = [](const vec3& a, std::size_t by) { return vec3{a[by], a[(by + 1) % 3], a[(by + 2) % 3]}; };
  CHECK(concino::detail::sum_of_squares{}.minimum() == vec3{});
  for (const double scale : {1.0, 0x1p-60, 0x1p60})
    for (std::size_t by = 0; by < 3; ++by) {
      const vec3 c = turned({0.3, -0.7, 1.1}, by);
      concino::detail::sum_of_squares all = {}, one = {}, two = {};
      for (const vec3& d : {vec3{1, 0.5, 0.2}, vec3{-0.3, 2, 0.7}, vec3{0.4, -0.1, 3}, vec3{1, 1, 1}}) all.add(scale * turned(d, by), c);
      CHECK(distance(all.minimum(), c) < 1e-14);
      const vec3 axis = turned({1, 0, 0}, by), other = turned({0, 1, 0}, by);
      one.add(scale * axis, c);
      CHECK(distance(one.minimum(), dot(c, axis) * axis) < 1e-15);
      two.add(scale * (axis + other), c);
      two.add(scale * (axis - 2 * other), c);
      CHECK(distance(two.minimum(), dot(c, axis) * axis + dot(c, other) * other) < 1e-15);
    }
  for (int i = 1; i < 40; ++i) {  // rounding errors do not grow
    const vec3 d{0.01 * i, 0.3 / i, 1 + 0.1 * i}, c{1.5, -0.5, 0.75};
    concino::detail::sum_of_squares s = {};
    for (const double factor : {0.7, 1.1, 1.3, 0.9}) s.add(factor * d, c);
    CHECK(distance(s.minimum(), {0, 0, dot(d, c) / d.z}) < 1e-13);
  }
}

TEST_CASE_TEMPLATE("virtual refinement: equals the cotangent Laplacian on simplices", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(3), 0.05));
  const Eigen::MatrixXd expected = laplacian(m, cotangent);
  CHECK((refined(m) + expected).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("virtual refinement: equals the cotangent Laplacian on triangles among polygons") {
  const trimesh m(jittered(triangle_grid(3), 0.05));
  const polygonmesh same(with_offsets(jittered(triangle_grid(3), 0.05)));
  CHECK((refined(m) - refined(same)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE_TEMPLATE("virtual refinement: is semidefinite with constants as kernel, and linear functions are harmonic", M, CONCINO_KINDS) {
  const M m = pushed_grid<M>(3);
  const Eigen::MatrixXd k = refined(m);
  CHECK(k.rowwise().sum().cwiseAbs().maxCoeff() < 1e-13);
  CHECK(residual_of_coordinates(m, k) < 1e-13);
  const auto values = spectrum(k);
  CHECK(std::abs(values[0]) < 1e-13);
  CHECK(values[1] > 1e-3);
  // the energy of a coordinate is the area or volume
  Eigen::VectorXd x(k.rows());
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = to_vec3(point(m, v)).y;
  CHECK(x.dot(k * x) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("virtual refinement: scales exactly, is invariant to translation, the same on the archetype", M, CONCINO_KINDS) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03);
  const M m(arrays);
  const Eigen::MatrixXd k = refined(m);
  const auto stripped = only_embedded_mesh(m);
  const Eigen::MatrixXd same = refined(stripped);
  const auto at = [&](const auto& v) { return static_cast<Eigen::Index>(index_of(stripped, v)); };
  const auto base = [&](const auto& v) { return static_cast<Eigen::Index>(index_of(m, stripped.base(v))); };
  for (const auto v : verts(stripped))
    for (const auto w : verts(stripped)) CHECK(same(at(v), at(w)) == doctest::Approx(k(base(v), base(w))).epsilon(1e-12));
  for (vec3& x : arrays.points) x *= 1048576;
  CHECK(refined(M(arrays)) == k * std::pow(1048576.0, dimension_v<M> - 2));
  auto small = arrays;
  for (vec3& x : small.points) x *= 0x1p-80;
  CHECK(refined(M(small)) == k * std::pow(0x1p-60, dimension_v<M> - 2));
  for (vec3& x : arrays.points) x = x / 1048576 + vec3{1024, -512, 2048};
  CHECK((refined(M(arrays)) - k).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("virtual refinement: is right for the unit square and the unit cube") {
  const Eigen::MatrixXd square = refined(grid<quadmesh>(1));
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j) CHECK(square(i, j) == doctest::Approx(i == j ? 0.75 : -0.25));
  Eigen::VectorXd alternating(8), product(8);
  const hexmesh cube = grid<hexmesh>(1);
  for (const auto v : verts(cube)) {
    const vec3 x = point(cube, v);
    alternating[static_cast<Eigen::Index>(index_of(cube, v))] = (x.x == x.y) == (x.z == 1) ? 1 : -1;
  }
  // the virtual verts have value 0, and each of the 24 tets the gradient 2
  CHECK(alternating.dot(refined(cube) * alternating) == doctest::Approx(4));
}

TEST_CASE("virtual refinement: agrees with its definition on a bipyramid and a pyramid") {
  polyhedra_arrays bipyramid{{{1, 0, 0.1}, {-0.6, 0.9, 0}, {-0.4, -0.8, 0.2}, {0.1, 0.2, 1.3}, {0.2, 0.1, -0.7}}, {0}, {}, {0}, {}, {}};
  add_face(bipyramid, {0, 1, 3}), add_face(bipyramid, {1, 2, 3}), add_face(bipyramid, {2, 0, 3});
  add_face(bipyramid, {1, 0, 4}), add_face(bipyramid, {2, 1, 4}), add_face(bipyramid, {0, 2, 4});
  bipyramid.poly_offsets.push_back(6);
  const Eigen::MatrixXd two = by_definition(bipyramid.points, false, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
  CHECK((refined(polyhedralmesh(bipyramid)) - two).cwiseAbs().maxCoeff() < 1e-13);

  polyhedra_arrays pyramid{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.7, 0.4, 1.3}, {0.5, -0.4, 0.4}}, {0}, {}, {0}, {}, {}};  // with an additional tip
  add_face(pyramid, {3, 2, 1, 0}), add_face(pyramid, {0, 1, 5}), add_face(pyramid, {1, 4, 5}), add_face(pyramid, {4, 0, 5});
  add_face(pyramid, {1, 2, 4}), add_face(pyramid, {2, 3, 4}), add_face(pyramid, {3, 0, 4});
  pyramid.poly_offsets.push_back(7);
  const Eigen::MatrixXd one = by_definition(
      pyramid.points, true, {{1, 0, 6}, {2, 1, 6}, {3, 2, 6}, {0, 3, 6}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  CHECK((refined(polyhedralmesh(pyramid)) - one).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("virtual refinement: works on a user's mesh, and on a polyhedron with many verts") {
  const auto volume = user_mesh::volume_example();
  const Eigen::MatrixXd k = refined(volume);
  CHECK(k.row(9).cwiseAbs().maxCoeff() == 0);
  CHECK(std::abs(spectrum(k)[1]) < 1e-13);  // constants on the mesh, and on the isolated vert
  CHECK(spectrum(k)[2] > 1e-3);
  surface_arrays disk{{}, {0, 20}, {}, 0};
  for (unsigned i = 0; i < 20; ++i) {
    disk.points.push_back({std::cos(0.1 * 3.14159265358979 * i), std::sin(0.1 * 3.14159265358979 * i), 0});
    disk.verts.push_back(vert_id{i});
  }
  for (const unsigned layers : {1u, 2u}) {
    const polyhedralmesh prisms(extrude(disk, layers));
    const Eigen::MatrixXd p = refined(prisms);
    Eigen::VectorXd z(p.rows());
    for (const auto v : verts(prisms)) z[static_cast<Eigen::Index>(index_of(prisms, v))] = point(prisms, v).z;
    CHECK(z.dot(p * z) == doctest::Approx(total_measure(prisms)));
    CHECK(p.rowwise().sum().cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("virtual refinement: the error names polys that are not star-shaped") {
  const polygonmesh c(letter_c());
  CHECK(message_for(c).find("poly 0 is not star-shaped") != std::string::npos);
  CHECK(message_for(c).find("virtual_elements") != std::string::npos);
  CHECK(message_for(polyhedralmesh(extrude(letter_c(), 1))).find("poly 0 is not star-shaped") != std::string::npos);
  // star-shaped polys do not throw, even if they are concave
  CHECK(message_for(grid<polygonmesh>(2)).empty());
  CHECK(message_for(grid<polyhedralmesh>(2)).empty());
}

TEST_CASE_TEMPLATE("virtual refinement: throws for polys without measure and points that are not finite", M, CONCINO_KINDS) {
  auto arrays = grid_arrays<M>(2);
  arrays.points[1].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(refined(M(arrays)), invalid_mesh);
  for (vec3& x : arrays.points) x = {x.y, x.y, x.y};
  CHECK_THROWS_AS(refined(M(arrays)), invalid_mesh);
}

TEST_CASE("virtual refinement: throws if an area is not a finite number") {
  CHECK_THROWS_AS(refined(polygonmesh({{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}, {{0, 1, 2}})), invalid_mesh);
}

TEST_CASE_TEMPLATE("virtual refinement: an inverted volume gives the same result", M, CONCINO_VOLUME_KINDS) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03);
  const Eigen::MatrixXd k = refined(M(arrays));
  for (vec3& x : arrays.points) x.x = -x.x;
  CHECK((refined(M(arrays)) - k).cwiseAbs().maxCoeff() < 1e-13);
}
