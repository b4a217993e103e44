// Convert between mesh types and keep attributes. A block of hexes becomes a polyhedral mesh, and its boundary becomes a surface in a mesh type of your own.
// Temperatures and names are transferred, and the correspondence between elements is known.
#include <concino/convert.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/boundary.hpp>

#include <fmt/core.h>

#include <array>

namespace cn = concino;

/// A user's mesh type. It stores lists of verts, and can add a vert and a poly. convert() needs no more.
struct drawing {
  cn::polygonmesh inner;
};
template<> struct concino::mesh_traits<drawing> : concino::indexed_surface<drawing> {
  static const auto& tables(const drawing& m) { return m.inner.tables(); }
  static const vec3& point(const drawing& m, vert_id v) { return concino::point(m.inner, v); }
  static vert_id add_vert(drawing& m, const vec3& x) { return concino::add_vert(m.inner, x); }
  static poly_id add_poly(drawing& m, std::span<const vert_id> corners) { return concino::add_poly(m.inner, corners); }
};

cn::hexmesh block(unsigned nx, unsigned ny, unsigned nz) {
  std::vector<cn::vec3> points;
  std::vector<std::array<unsigned, 8>> hexes;
  const auto at = [&](unsigned x, unsigned y, unsigned z) { return (z * (ny + 1) + y) * (nx + 1) + x; };
  for (unsigned z = 0; z <= nz; ++z)
    for (unsigned y = 0; y <= ny; ++y)
      for (unsigned x = 0; x <= nx; ++x) points.push_back({double(x), double(y), double(z)});
  for (unsigned z = 0; z < nz; ++z)
    for (unsigned y = 0; y < ny; ++y)
      for (unsigned x = 0; x < nx; ++x)
        hexes.push_back({at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z), at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)});
  return cn::hexmesh(points, hexes);
}

int main() {
  cn::hexmesh hexes = block(3, 2, 2);
  auto heat = cn::vert_property<double>(hexes, "heat");
  for (const auto v : cn::verts(hexes)) heat[v] = 20 + 10 * cn::point(hexes, v).x;
  auto material = cn::poly_property<std::string>(hexes, "material");
  for (const auto p : cn::polys(hexes)) material[p] = p.raw() % 3 == 0 ? "steel" : "glass";

  const auto general = cn::convert_with_correspondence<cn::polyhedralmesh>(hexes);
  const cn::poly_id last{11};
  fmt::print("{} hexes became {} polyhedra with {} faces; the last one is {}\n", cn::num_polys(hexes), cn::num_polys(general.mesh), cn::num_faces(general.mesh),
             cn::find_poly_property<std::string>(general.mesh, "material")[general.poly_of(last)]);
  fmt::print("and back: {} hexes\n", cn::num_polys(cn::convert<cn::hexmesh>(general.mesh)));

  // A view is a mesh too, with the properties of the volume that it refers to. transfer() copies the values of any map to the new mesh.
  const auto skin = cn::convert_with_correspondence<drawing>(cn::boundary(hexes));
  auto warm = cn::make_vert_map<double>(skin.mesh);
  skin.transfer(heat, warm);
  double hottest = 0;
  for (const auto v : cn::verts(skin.mesh)) hottest = std::max(hottest, warm[v]);
  fmt::print("the boundary has {} quads and {} verts, the hottest at {} degrees\n", cn::num_polys(skin.mesh), cn::num_verts(skin.mesh), hottest);

  try {
    cn::convert<cn::tetmesh>(hexes);
  } catch (const cn::unsupported& refused) {
    fmt::print("{}\n", refused.what());
  }
}
