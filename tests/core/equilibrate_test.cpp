#include <concino/core/equilibrate.hpp>

#include <support/systems.hpp>

#include <algorithm>

using namespace concino;
using namespace systems;

namespace {

/// A grid matrix with different units of rows and columns.
sparse in_units(int n, int row_unit, int column_unit) {
  sparse a = grid(n, 0.5, 0.2);
  for (int c = 0; c < a.cols(); ++c)
    for (sparse::InnerIterator it(a, c); it; ++it)
      it.valueRef() = std::ldexp(it.value(), row_unit * (static_cast<int>(it.row()) % 4) + column_unit * (c % 3));
  return a;
}

/// Checks that the largest entries of rows and columns are within a factor of 4, and that the result is the input, scaled.
void check_equilibrated(const sparse& given) {
  sparse a = given;
  const auto scale = core::equilibrate(a);
  std::vector<double> row(static_cast<std::size_t>(a.rows())), column(static_cast<std::size_t>(a.cols()));
  for (int c = 0; c < a.cols(); ++c)
    for (sparse::InnerIterator it(a, c), old(given, c); it; ++it, ++old) {
      const auto i = static_cast<std::size_t>(it.row()), j = static_cast<std::size_t>(c);
      CHECK(it.value() == old.value() * scale.rows[i] * scale.columns[j]);
      row[i] = std::max(row[i], std::abs(it.value()));
      column[j] = std::max(column[j], std::abs(it.value()));
    }
  for (const auto* largest : {&row, &column})
    for (const double x : *largest) CHECK((x >= 0.5 && x < 4));
}

}  // namespace

TEST_CASE("scale_columns: the largest entry of each column is in [1, 2) afterwards") {
  sparse a = from(3, 4, {{0, 0, -0.1}, {1, 0, 0.01}, {2, 1, 5.0}, {0, 1, -7.0}, {1, 2, 0.0}});
  CHECK(core::scale_columns(a) == std::vector<double>{16, 0.25, 1, 1});
  CHECK(a.coeff(0, 0) == -1.6);
  CHECK(a.coeff(1, 0) == 0.16);
  CHECK(a.coeff(2, 1) == 1.25);
}

TEST_CASE("equilibrate: the result does not depend on the units of rows and columns") {
  for (const int unit : {0, 1, 2, 3, 7, 30, -30, 150, -150}) {
    check_equilibrated(in_units(5, unit, 0));
    check_equilibrated(in_units(5, 0, unit));
    check_equilibrated(in_units(5, unit, -unit));
  }
  for (const double x : {1.0, 3.0, 5.0, 1e-3, 1e300}) check_equilibrated(from(1, 1, {{0, 0, x}}));
  check_equilibrated(from(3, 3, {{0, 0, 1e-3}, {1, 1, 1.0}, {2, 2, 1e-7}}));
  check_equilibrated(from(2, 2, {{0, 0, 0x1p-430}, {1, 1, 0x1p600}}));  // nearly as far apart as doubles can be
}

TEST_CASE("equilibrate: multiples of a matrix have the same result") {
  for (const int size : {1, 3})
    for (int at = 0; at < size; ++at)
      for (const double factor : {0x1p41, 0x1p40, 0x1p-40, 0x1p-41}) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i == at ? -1000.0 : 1.0 + i);
        sparse a = from(size, size, entries);
        sparse b = a * factor;
        const auto scale_a = core::equilibrate(a), scale_b = core::equilibrate(b);
        CHECK((a - b).norm() == 0);
        CHECK(scale_a.columns == scale_b.columns);
        for (std::size_t i = 0; i < scale_a.rows.size(); ++i) CHECK(scale_a.rows[i] == scale_b.rows[i] * factor);
      }
}

TEST_CASE("equilibrate: rows and columns without entries keep their scale, and symmetric matrices stay symmetric") {
  sparse a = from(3, 3, {{0, 0, 64.0}, {0, 2, 1.0}, {2, 0, 1.0}, {2, 2, 64.0}});
  const auto scale = core::equilibrate(a);
  CHECK(scale.rows[1] == 1.0 / 64);
  CHECK(scale.columns[1] == 1);
  CHECK(a.coeff(0, 2) == a.coeff(2, 0));
}
