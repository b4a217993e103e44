// Laws of the operators on every mesh with points, native or adapted, real or generated.
#pragma once

#include <concino/convert.hpp>
#include <concino/generate.hpp>
#include <concino/operators.hpp>

#include <support/corpus_meshes.hpp>
#include <support/fields.hpp>

namespace concino::testing {

template<class M>
void check_operator_laws(const M& m) {
  CHECK(linear_error(m, gradient_matrix(m)) < 1);
  double sizes = 0;
  for (const auto p : polys(m)) sizes += std::abs(measure(m, p));
  CHECK(mass_matrix(m).sum() == doctest::Approx(sizes).epsilon(1e-12));
  CHECK(mass_matrix(m, {.lumped = false}).sum() == doctest::Approx(sizes).epsilon(1e-12));
  const auto l = laplacian(m);
  CHECK(same_entries(l, Eigen::SparseMatrix<double>(l.transpose())));
}

/// Checks the laws, and that matrices scale exactly. scaled(s) returns the mesh scaled by s.
template<class Scaled>
void check_operators_scale(const Scaled& scaled) {
  const auto original = scaled(1.0);
  check_operator_laws(original);
  const auto g = gradient_matrix(original), l = laplacian(original), w = mass_matrix(original);
  constexpr int d = dimension_v<decltype(original)>;
  for (const double s : {0x1p20, 0x1p-20}) {
    const auto m = scaled(s);
    CHECK(same_entries(gradient_matrix(m), g, 1 / s));
    CHECK(same_entries(laplacian(m), l, std::pow(s, d - 2)));
    CHECK(same_entries(mass_matrix(m), w, std::pow(s, d)));
  }
}

/// Calls f(native mesh) for the small meshes of the corpus in which each poly has a measure.
template<class F>
void each_small_corpus_mesh(const F& f) {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    if (std::filesystem::file_size(row.file) > 60'000) continue;
    INFO(row.name);
    std::visit(
        [&](const auto& m) {
          for (const auto p : polys(m))
            if (!(std::abs(measure(m, p)) > 0)) return;
          f(m);
        },
        load_any(row.file.string()));
  }
}

/// Checks the laws on real and generated surfaces as meshes of type F, for those that an F can hold.
template<class F>
void operators_of_foreign_surfaces() {
  std::size_t held = 0;
  each_small_corpus_mesh([&](const auto& m) {
    if constexpr (SurfaceMesh<decltype(m)>) {
      F foreign;
      try {
        foreign = convert<F>(m);
      } catch (const unsupported&) {
        return;  // F cannot hold it: not manifold, or not of triangles
      }
      ++held;
      check_operators_scale([&](double s) {
        F copy = foreign;
        for (const auto v : verts(copy)) set_point(copy, v, s * to_vec3(point(foreign, v)));
        return copy;
      });
    }
  });
  CHECK((held > 2 || corpus_dir().empty()));
  F grid = make_grid<F>({.cells = {6, 5}});
  jitter(grid, 0.2);
  check_operator_laws(grid);
  grade(grid, {2, 2, 2});
  check_operator_laws(grid);
  check_operator_laws(make_sphere<F>({.cells = 3}));
}

}  // namespace concino::testing
