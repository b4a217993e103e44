// Measures how fast lines follow a field: seconds for a million polys crossed, along 400 lines of up to a thousand each.
#include "support/kinds.hpp"

#include <concino/geometry/centroid.hpp>
#include <concino/lines/integral_line.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

namespace floors = bench::floors;
namespace cn = concino;

/// Round the z axis, with a small part towards z that differs from poly to poly.
template<class M>
auto winding_field(const M& m, const cn::vec3& centre) {
  auto g = cn::make_poly_map<cn::vec3>(m);
  for (const auto p : cn::polys(m)) {
    const cn::vec3 x = cn::vert_mean(m, p) - centre;
    g[p] = {-x.y, x.x, 0.1 * std::sin(1e4 * (x.x + 1.3 * x.y + 1.7 * x.z)) * cn::norm(x)};
  }
  return g;
}

template<class M>
void follow(const bench::program& p, const std::string& name, const M& m) {
  const std::string work = "lines." + name;
  cn::vec3 sum;
  for (const auto v : cn::verts(m)) sum += cn::to_vec3(cn::point(m, v));
  const auto g = winding_field(m, sum / static_cast<double>(cn::num_verts(m)));
  std::vector<cn::poly_t<M>> starts;
  const std::size_t every = std::max<std::size_t>(1, cn::num_polys(m) / 400);
  std::size_t i = 0;
  for (const auto x : cn::polys(m))
    if (i++ % every == 0) starts.push_back(x);
  const auto follow = [&] {
    std::size_t crossed = 0;
    for (const auto& line : cn::integral_lines(m, g, starts, {.max_steps = 1000})) crossed += line.polys.size();
    return crossed;
  };
  const double millions = static_cast<double>(follow()) / 1e6;
  p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(follow) / millions; }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("lines.tri1m")) follow(p, "tri1m", cn::trimesh(p.data.tri1m()));
    if (p.wants("lines.tet1m")) follow(p, "tet1m", cn::tetmesh(p.data.tet1m()));
    if (p.wants("lines.hex1m")) follow(p, "hex1m", cn::hexmesh(p.data.hex1m()));
    if (p.wants("lines.poly228k")) follow(p, "poly228k", cn::polygonmesh(p.data.poly228k()));
    if (p.wants("lines.dual200k")) follow(p, "dual200k", cn::polyhedralmesh(p.data.dual200k()));
  });
}
