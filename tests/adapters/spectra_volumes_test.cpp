// Eigenfunctions of volumes of every kind.
#include <concino/adapters/spectra.hpp>

#include <support/eigenfunctions.hpp>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr auto by_spectra = [](const auto& m, std::size_t count) { return eigenfunctions(m, count); };

}  // namespace

TEST_CASE_TEMPLATE("eigenfunctions: are right on the cube, balls and two cubes, and scale exactly", M, CONCINO_VOLUME_KINDS) {
  const double coarse = error_on_square_or_cube<M>(3, by_spectra), fine = error_on_square_or_cube<M>(6, by_spectra);
  CHECK(fine < 0.4 * coarse);
  CHECK(fine < 0.08);
  const M ball = make_sphere<M>({.cells = 4});
  check_sphere(ball, {4.333, 11.17}, 0.12, by_spectra);  // squares of the zeros of derivatives of spherical Bessel functions
  check_components<M>(3, by_spectra);
  check_scaling<M>(3, by_spectra);
}
