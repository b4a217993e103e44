#include <concino/level_sets/detail/requested_cells.hpp>

#include <concino/edit/elements.hpp>

#include <doctest/doctest.h>

#include <support/kinds.hpp>

#include <span>
#include <vector>

namespace cn = concino;

namespace {

/// Whether each of the first n polys is read once, in order, and reading ends behind the poly with this number.
template<class M>
bool are_read_once(const M& m, std::size_t n, std::size_t last) {
  std::vector<cn::poly_id> all, read;
  for (const cn::poly_id p : cn::polys(m))
    if (all.size() < n) all.push_back(p);
  cn::detail::read_requested(m, std::span<const cn::poly_id>(all), [&](cn::poly_id p) {
    read.push_back(p);
    return read.size() <= last;
  });
  if (last + 1 < all.size()) all.resize(last + 1);
  return all == read;
}

template<class M>
void check(const M& m) {
  for (const std::size_t n : {0u, 1u, 15u, 16u, 17u, 31u, 32u, 33u, 48u, 60u}) {
    CHECK(are_read_once(m, n, n));
    for (const std::size_t last : {0u, 15u, 16u, 40u}) CHECK(are_read_once(m, n, last));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("requested_cells: each cell is read once, in order, until reading ends", M, CONCINO_VOLUME_KINDS) {
  M m = cn::testing::grid<M>(4);
  check(m);
  for (const unsigned p : {3u, 20u}) cn::remove_poly(m, cn::poly_id{p});  // lists are no longer packed
  check(m);
}
