// Measures plain arrays and Eigen's matrices as meshes, against loops over the same arrays and over adjacencies in flat arrays, which such loops need too.
#include "by_hand.hpp"

#include <concino/adapters/eigen.hpp>
#include <concino/adapters/span.hpp>

namespace {

using bench::u32;

/// point(v) and corner(p, k) read the user's arrays. The adjacencies come from the floor.
template<class At, class Corner>
struct arrays {
  using vert = concino::vert_id;
  using poly = concino::poly_id;
  const bench::floors::surface<3>& f;
  At point;
  Corner corner;

  std::size_t num_verts() const { return f.num_verts(); }
  std::size_t num_polys() const { return f.num_polys(); }
  std::size_t num_edges() const { return f.num_edges(); }
  vert vert_at(std::size_t i) const { return vert(i); }
  poly poly_at(std::size_t i) const { return poly(i); }
  template<class Id>
  std::size_t index(Id x) const { return x.raw(); }
  concino::vec3 at(vert v) const { return point(v.raw()); }

  template<class F>
  void around(vert v, F&& visit) const {
    for (u32 k = f.v_off[v.raw()]; k != f.v_off[v.raw() + 1]; ++k) visit(vert(f.v2v[k]));
  }
  template<class F>
  void around(poly p, F&& visit) const {
    for (u32 k = 3 * p.raw(); k != 3 * p.raw() + 3; ++k)
      if (f.p2p[k] != bench::floors::none) visit(poly(f.p2p[k]));
  }
  template<class F>
  void corners(poly p, F&& visit) const {
    for (u32 k = 0; k != 3; ++k) visit(vert(corner(p.raw(), k)));
  }
  template<class F>
  void sides(poly p, F&& visit) const {
    for (u32 k = 3 * p.raw(); k != 3 * p.raw() + 3; ++k) visit(f.p2e[k]);
  }
  template<class F>
  void edges_at(vert v, F&& visit) const {
    for (u32 k = f.v_off[v.raw()]; k != f.v_off[v.raw() + 1]; ++k) visit(f.v2e[k], vert(f.v2v[k]));
  }
};

template<class Measure>
void spans(const bench::surface_arrays& a, const Measure& measure) {
  const auto f = bench::built<3>(a);
  std::vector<double> points;
  std::vector<int> corners;
  for (const auto& x : a.points) points.insert(points.end(), {x.x, x.y, x.z});
  for (const auto v : a.verts) corners.push_back(static_cast<int>(v.raw()));
  const auto view = concino::view_tri(points, corners);
  const auto at = [&](u32 v) { return concino::vec3(points[3 * v], points[3 * v + 1], points[3 * v + 2]); };
  const auto corner = [&](u32 p, u32 k) { return corners[3 * p + k]; };
  measure("span", arrays<decltype(at), decltype(corner)>{f, at, corner}, view);
}

template<class Measure>
void matrices(const bench::surface_arrays& a, const Measure& measure) {
  const auto f = bench::built<3>(a);
  Eigen::MatrixXd points(static_cast<Eigen::Index>(a.points.size()), 3);
  Eigen::MatrixXi corners(static_cast<Eigen::Index>(a.num_polys()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k) points(i, k) = a.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  for (Eigen::Index i = 0; i < corners.rows(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k) corners(i, k) = static_cast<int>(a.verts[static_cast<std::size_t>(3 * i + k)].raw());
  const auto view = concino::view_tri(points, corners);
  const auto at = [&](u32 v) { return concino::vec3(points(v, 0), points(v, 1), points(v, 2)); };
  const auto corner = [&](u32 p, u32 k) { return corners(p, k); };
  measure("eigen", arrays<decltype(at), decltype(corner)>{f, at, corner}, view);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto all = [&](const char* name, const auto& l, const auto& m) { bench::by_hand::compare_all(p, name, l, m); };
    const auto harmonic = [&](const char* name, const auto& l, const auto& m) { bench::by_hand::compare_harmonic(p, name, l, m); };
    {
      const auto a = p.data.tri1m();
      spans(a, all);
      matrices(a, all);
    }
    const auto a = p.data.bunny();
    spans(a, harmonic);
    matrices(a, harmonic);
  });
}
