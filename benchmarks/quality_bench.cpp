// Measures quality metrics of all polys against loops over flat arrays that compute one metric of one shape.
#include "floor/quality.hpp"
#include "support/kinds.hpp"

#include <concino/quality.hpp>

#include <cmath>
#include <stdexcept>

namespace {

namespace floors = bench::floors;

template<class Kind, class Arrays, class Floor>
void quality(const bench::program& p, const std::string& name, Kind kind, const Arrays& arrays, concino::metric what, Floor floor_of) {
  const std::string work = "quality." + std::string(concino::name_of(what)) + "." + name;
  if (!p.wants(work)) return;
  const auto flat = kind.flat(arrays);
  const typename Kind::mesh m(arrays);
  const auto floor = [&] { return floor_of(flat.points, flat.p2v); };
  const auto ours = [&] { return concino::quality(m, what); };
  const auto expected = floor();
  const auto found = ours();
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!(std::abs(found.values()[i] - expected[i]) < 1e-12)) throw std::runtime_error(work + ": the floor's values and the library's differ");
  const auto timed = [](auto f) { return [f] { return bench::seconds_of(f); }; };
  p.print(bench::compare(work, p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    using concino::metric;
    const bench::surface_kind<3, concino::trimesh> triangles;
    const bench::cell_kind<floors::tet_shape, concino::tetmesh> tets;
    const bench::cell_kind<floors::hex_shape, concino::hexmesh> hexes;
    const auto of_triangles = [](auto metric_at) {
      return [=](const auto& points, const auto& p2v) { return floors::quality_of_each<3>(p2v, [m = metric_at(points)](const bench::u32* v) { return m.triangle(v); }); };
    };
    const auto of_tets = [](auto metric_at) {
      return [=](const auto& points, const auto& p2v) { return floors::quality_of_each<4>(p2v, [m = metric_at(points)](const bench::u32* v) { return m.tet(v); }); };
    };
    const auto jacobian = [](const auto& points) { return floors::scaled_jacobian{points}; };
    const auto ratio = [](const auto& points) { return floors::mean_ratio{points}; };
    quality(p, "bunny16", triangles, p.data.bunny16(), metric::scaled_jacobian, of_triangles(jacobian));
    quality(p, "bunny16", triangles, p.data.bunny16(), metric::mean_ratio, of_triangles(ratio));
    quality(p, "tet200k", tets, p.data.tet200k(), metric::scaled_jacobian, of_tets(jacobian));
    quality(p, "tet200k", tets, p.data.tet200k(), metric::mean_ratio, of_tets(ratio));
    quality(p, "hex1m", hexes, p.data.hex1m(), metric::scaled_jacobian,
            [](const auto& points, const auto& p2v) { return floors::quality_of_each<8>(p2v, [m = floors::scaled_jacobian{points}](const bench::u32* v) { return m.hex(v); }); });
  });
}
