// Measures normals against loops over flat arrays: those of polys and verts together on surfaces, those of faces on volumes.
#include "floor/normals.hpp"
#include "support/kinds.hpp"

#include <concino/geometry/normals.hpp>

namespace {

namespace floors = bench::floors;

template<class Map>
void expect_equal(const std::string& work, const floors::buffer<floors::vector3>& f, const Map& ours) {
  bool same = f.size() == ours.values().size();
  for (std::size_t i = 0; same && i < f.size(); ++i) {
    const auto& n = ours.values()[i];
    same = floors::norm(f[i] - floors::vector3{n.x, n.y, n.z}) < 1e-12;
  }
  if (!same) throw std::runtime_error(work + ": the floor's normals and the library's differ");
}

template<class Kind, class Make>
void normals(const bench::program& p, const std::string& name, Kind kind, const Make& make) {
  const std::string work = "normals." + name;
  if (!p.wants(work)) return;
  const auto arrays = make(p.data);
  auto flat = kind.flat(arrays);
  build(flat);
  const typename Kind::mesh m(arrays);
  const auto floor = [&] { return floors::normals(flat); };
  const auto ours = [&] {
    if constexpr (concino::SurfaceMesh<typename Kind::mesh>) return concino::surface_normals(m);
    else return concino::face_normals(m);
  };
  if constexpr (concino::SurfaceMesh<typename Kind::mesh>) {
    const auto f = floor();
    const auto n = ours();
    expect_equal(work, f.polys, n.polys);
    expect_equal(work, f.verts, n.verts);
  } else {
    expect_equal(work, floor(), ours());
  }
  const auto timed = [](auto f) { return [f] { return bench::seconds_of(f); }; };
  p.print(bench::compare(work, p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    normals(p, "tri1m", bench::surface_kind<3, concino::trimesh>{}, [](const auto& d) { return d.tri1m(); });
    normals(p, "quad343k", bench::surface_kind<4, concino::quadmesh>{}, [](const auto& d) { return d.quad343k(); });
    normals(p, "poly228k", bench::surface_kind<0, concino::polygonmesh>{}, [](const auto& d) { return d.poly228k(); });
    normals(p, "tet1m", bench::cell_kind<floors::tet_shape, concino::tetmesh>{}, [](const auto& d) { return d.tet1m(); });
    normals(p, "hex1m", bench::cell_kind<floors::hex_shape, concino::hexmesh>{}, [](const auto& d) { return d.hex1m(); });
  });
}
