// check_laws, validate and conformance pass on their own std::bad_alloc: it is not reported as a broken law, and no incomplete table is read.
#include <concino/testing/conformance.hpp>
#include <concino/validate.hpp>

#include <support/failing_allocations.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::for_each_failing_allocation;

namespace {

std::vector<std::string> texts(const std::vector<cn::broken_law>& laws) {
  std::vector<std::string> all;
  for (const cn::broken_law& b : laws) all.push_back(b.law + b.what + b.witness);
  return all;
}

/// Checks that f() throws std::bad_alloc or returns the same as without failing allocations.
template<class F>
std::size_t gives_the_same_or_throws(const F& f) {
  const std::vector<std::string> expected = f();
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    std::vector<std::string> found;
    if (!attempt([&] { found = f(); })) CHECK(found == expected);
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
  return result.allocations;
}

/// A mesh whose adj_v2v lacks the first neighbour of every third vert, so that laws are broken and messages are allocated.
struct forgetful {
  cn::trimesh mesh;
};

}  // namespace

template<>
struct concino::mesh_traits<forgetful> : concino::indexed_surface<forgetful> {
  static const auto& tables(const forgetful& m) { return m.mesh.tables(); }
  static auto adj_v2v(const forgetful& m, vert_id v) {
    const auto ring = m.mesh.tables().adj_v2v(v);
    return concino::id_span<vert_id>(ring.begin() + (v.raw() % 3 == 0), ring.end());
  }
};

TEST_CASE_TEMPLATE("check_laws: its own std::bad_alloc reaches the caller", M, cn::trimesh, cn::polygonmesh, cn::tetmesh, cn::polyhedralmesh) {
  const M m = cn::testing::grid<M>(1);
  gives_the_same_or_throws([&] { return texts(cn::check_laws(m)); });
}

TEST_CASE("check_laws: its own std::bad_alloc reaches the caller, also for a broken mesh") {
  const forgetful m{cn::testing::grid<cn::trimesh>(2)};
  CHECK(cn::check_laws(m).size() > 4);
  gives_the_same_or_throws([&] { return texts(cn::check_laws(m)); });
}

TEST_CASE_TEMPLATE("validate: its own std::bad_alloc reaches the caller", M, cn::polygonmesh, cn::tetmesh) {
  M m = cn::testing::grid<M>(1);
  cn::traits<M>::set_point(m, cn::vert_id{0}, cn::point(m, cn::vert_id{1}));
  gives_the_same_or_throws([&] {
    std::vector<std::string> all;
    for (const auto& d : cn::validate(m)) all.push_back(d.what);
    return all;
  });
}

TEST_CASE("conformance: its own std::bad_alloc reaches the caller") {
  using M = cn::trimesh;
  const auto f = [] { return cn::conformance([] { return cn::testing::grid<M>(1); }, {.algorithms = false}).text(); };
  const std::string expected = f();
  bool reached = true;
  for (std::size_t n = 1; reached; n += 1 + n / 4) {  // some of its many allocations
    cn::testing::failing_attempt attempt(n, false);
    std::string found;
    if (!attempt([&] { found = f(); })) CHECK(found == expected);
    reached = attempt.asked() >= n;
  }
}
