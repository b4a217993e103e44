// Measures the matrices of a triangle and a tet mesh against their floors and against Eigen's triplets.
#include "floor/operators.hpp"
#include "support/element_triplets.hpp"
#include "support/kinds.hpp"

#include <concino/fields.hpp>
#include <concino/operators.hpp>

namespace {

using bench::u32;
namespace floors = bench::floors;
using sparse = Eigen::SparseMatrix<double>;

void expect_equal(const std::string& work, const floors::matrix& f, const sparse& ours) {
  bool same = f.rows.size() == static_cast<std::size_t>(ours.nonZeros());
  double largest = 0;
  for (const double x : f.values) largest = std::max(largest, std::abs(x));
  for (std::size_t i = 0; same && i < f.begin.size(); ++i) same = f.begin[i] == ours.outerIndexPtr()[i];
  for (std::size_t k = 0; same && k < f.rows.size(); ++k)
    same = f.rows[k] == ours.innerIndexPtr()[k] && std::abs(f.values[k] - ours.valuePtr()[k]) <= 1e-12 * largest;
  if (!same) throw std::runtime_error(work + ": the floor's matrix and the library's differ");
}

/// The same matrix built by Eigen from a list of triplets, as most programs do.
template<class F>
sparse by_triplets(const F& f) {
  const auto w = floors::cotangents(f);
  std::vector<Eigen::Triplet<double>> t;
  t.reserve(4 * w.size());
  for (u32 e = 0; e < w.size(); ++e) {
    const int a = static_cast<int>(f.e2v[2 * e]), b = static_cast<int>(f.e2v[2 * e + 1]);
    t.emplace_back(a, b, w[e]);
    t.emplace_back(b, a, w[e]);
    t.emplace_back(a, a, -w[e]);
    t.emplace_back(b, b, -w[e]);
  }
  const auto n = static_cast<Eigen::Index>(f.num_verts());
  sparse a(n, n);
  a.setFromTriplets(t.begin(), t.end());
  return a;
}

template<class F>
sparse gradient_by_triplets(const F& f) {
  const u32 np = f.num_polys(), n = static_cast<u32>(f.p2v.size()) / np;
  std::vector<Eigen::Triplet<double>> t;
  t.reserve(3 * f.p2v.size());
  for (u32 p = 0; p < np; ++p) {
    floors::vector3 g[4];
    floors::hat_gradients(f, p, g);
    const int row = 3 * static_cast<int>(p);
    for (u32 i = 0; i < n; ++i) {
      const int column = static_cast<int>(f.p2v[n * p + i]);
      t.emplace_back(row, column, g[i].x);
      t.emplace_back(row + 1, column, g[i].y);
      t.emplace_back(row + 2, column, g[i].z);
    }
  }
  sparse a(3 * static_cast<Eigen::Index>(np), static_cast<Eigen::Index>(f.num_verts()));
  a.setFromTriplets(t.begin(), t.end());
  return a;
}

template<class F, class M>
void matrices(const bench::program& p, const std::string& name, const F& f, const M& m) {
  using concino::cotangent, concino::uniform;
  const auto timed = [](auto work) { return [work] { return bench::seconds_of(work); }; };
  if (const std::string work = "laplacian.uniform." + name; p.wants(work)) {
    const auto floor = [&] { return floors::uniform_laplacian(f); };
    const auto ours = [&] { return concino::laplacian(m, uniform); };
    expect_equal(work, floor(), ours());
    p.print(bench::compare(work, p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
  }
  if (const std::string work = "laplacian.cotangent." + name; p.wants(work)) {
    const auto floor = [&] { return floors::cotangent_laplacian(f); };
    const auto ours = [&] { return concino::laplacian(m, cotangent); };
    expect_equal(work, floor(), ours());
    p.print(bench::compare(work, p.rounds,
                           {{"floor", timed(floor)}, {"concino", timed(ours)}, {"eigen-triplets", timed([&] { return by_triplets(f); }), 4}}));
  }
  if (const std::string work = "gradient." + name; p.wants(work)) {
    const auto floor = [&] { return floors::gradient(f); };
    const auto ours = [&] { return concino::gradient_matrix(m); };
    expect_equal(work, floor(), ours());
    p.print(bench::compare(work, p.rounds,
                           {{"floor", timed(floor)}, {"concino", timed(ours)}, {"eigen-triplets", timed([&] { return gradient_by_triplets(f); }), 4}}));
  }
  if (const std::string work = "divergence." + name; p.wants(work)) {
    const auto floor = [&] { return floors::divergence(f); };
    const auto ours = [&] { return concino::divergence_matrix(m); };
    expect_equal(work, floor(), ours());
    p.print(bench::compare(work, p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
  }
  if (const std::string work = "mass." + name; p.wants(work)) {
    const auto floor = [&] { return floors::diagonal(floors::masses(f)); };
    const auto ours = [&] { return concino::mass_matrix(m); };
    expect_equal(work, floor(), ours());
    p.print(bench::compare(work, p.rounds,
                           {{"floor", timed(floor)}, {"concino", timed(ours)}, {"face-normals", timed([&] { return floors::face_normals(f); })}}));
  }
}

/// The Laplacian of polys of any shape against Eigen's list of triplets. There is no floor for these.
template<class M>
void standard(const bench::program& p, const std::string& work, const M& m) {
  const auto list = [&] { return bench::standard_laplacian_by_triplets(m); };
  const auto ours = [&] { return concino::laplacian(m); };
  const sparse expected = list(), found = ours();
  if (!((expected - found).norm() <= 1e-12 * expected.norm())) throw std::runtime_error(work + ": the library's matrix and that of the triplets differ");
  const auto timed = [](auto w) { return [w] { return bench::seconds_of(w); }; };
  p.print(bench::compare(work, p.rounds, {{"eigen-triplets", timed(list)}, {"concino", timed(ours)}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto wants_any = [&](const std::string& name) {
      for (const char* work : {"laplacian.uniform.", "laplacian.cotangent.", "gradient.", "divergence.", "mass."})
        if (p.wants(work + name)) return true;
      return false;
    };
    if (wants_any("tri1m")) {
      const auto a = p.data.tri1m();
      matrices(p, "tri1m", bench::built<3>(a), concino::trimesh(a));
    }
    if (wants_any("tet1m")) {
      const auto a = p.data.tet1m();
      matrices(p, "tet1m", bench::built<floors::tet_shape>(a), concino::tetmesh(a));
    }
    if (p.wants("laplacian.standard.quad343k")) standard(p, "laplacian.standard.quad343k", concino::quadmesh(p.data.quad343k()));
    if (p.wants("laplacian.standard.poly228k")) standard(p, "laplacian.standard.poly228k", concino::polygonmesh(p.data.poly228k()));
    if (p.wants("laplacian.standard.hex216k")) standard(p, "laplacian.standard.hex216k", concino::polyhedralmesh(p.data.hex216k()));
    if (p.wants("laplacian.standard.dual200k")) standard(p, "laplacian.standard.dual200k", concino::polyhedralmesh(p.data.dual200k()));
  });
}
