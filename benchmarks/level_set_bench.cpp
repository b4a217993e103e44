// Measures the level sets of the squared distance from a point: lines on triangles and polygons across tets against loops over flat arrays, polygons across
// other cells, and clipping against building the result alone. The native meshes build their adjacencies when they are constructed, so this part of
// isosurface is measured again on the same arrays and subtracted; rows of its own say what it takes.
#include "floor/level_sets.hpp"
#include "support/arrays_of.hpp"
#include "support/kinds.hpp"
#include "support/level_set_values.hpp"

#include <concino/convert/convert.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets.hpp>

#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace {

using bench::expect;
using bench::sphere;
using bench::u32;
namespace floors = bench::floors;
namespace cn = concino;

const auto timed = [](auto work) { return [work] { return bench::seconds_of(work); }; };

bool close(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

/// The area of a surface, and the volume inside, which is negative if it is turned over.
struct size_of_surface { double area = 0, volume = 0; };

size_of_surface size_of(const cn::polygonmesh& m) {
  size_of_surface s;
  for (const auto p : cn::polys(m)) {
    const cn::vec3 a = cn::area_vector(m, p);
    s.area += cn::norm(a);
    s.volume += cn::dot(a, cn::point(m, *cn::adj_p2v(m, p).begin())) / 3;
  }
  return s;
}

size_of_surface size_of(const floors::surface<0>& m) {
  size_of_surface s;
  for (u32 p = 0; p < m.num_polys(); ++p) {
    const u32* const v = m.p2v.data() + m.first(p);
    const floors::vector3 a = floors::doubled_area(m.points, m.last(p) - m.first(p), [&](u32 i) { return v[i]; });
    s.area += floors::norm(a) / 2;
    s.volume += floors::dot(a, floors::at(m.points, v[0])) / 6;
  }
  return s;
}

void isolines(const bench::program& p) {
  const std::string work = "isolines.tri1m";
  if (!p.wants(work)) return;
  const auto arrays = p.data.tri1m();
  const auto flat = bench::flat_surface<3>(arrays);
  const cn::trimesh m(arrays);
  const bench::middle_level s(m);
  const auto floor = [&] { return floors::level_segments(flat.points, flat.p2v, s.values, s.level); };
  const auto ours = [&] { return cn::isolines(m, s.u, s.level); };

  const auto ends = floor();
  double floor_length = 0, length = 0;
  for (std::size_t i = 0; i < ends.size(); i += 2) floor_length += floors::norm(ends[i + 1] - ends[i]);
  std::size_t segments = 0;
  for (const auto& line : ours()) {
    const std::size_t n = line.points.size(), of_line = line.closed ? n : n - 1;
    for (std::size_t i = 0; i < of_line; ++i) length += cn::norm(line.points[(i + 1) % n] - line.points[i]);
    segments += of_line;
  }
  expect(segments > 0 && 2 * segments == ends.size() && close(length, floor_length), work, "the floor's lines and the library's differ");
  p.print(bench::compare(work, p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
}

/// Prints the rows of isosurface on m, and of the adjacencies of its result. `floor` may be null: there is no floor for this shape.
template<class M, class Floor>
void isosurface(const bench::program& p, const std::string& name, const M& m, const sphere<M>& s, Floor floor) {
  constexpr bool has_floor = !std::is_null_pointer_v<Floor>;
  const std::string work = "isosurface." + name, apart = "isosurface.adjacency." + name;
  if (!p.wants(work) && !p.wants(apart)) return;
  const auto ours = [&] { return cn::isosurface(m, s.u, s.level); };
  cn::surface_arrays arrays;
  {
    const auto found = ours();
    const auto& surface = found.mesh;
    const std::size_t nv = cn::num_verts(surface), np = cn::num_polys(surface);
    expect(nv == s.cut_edges && np >= s.cut && nv + np == cn::num_edges(surface) + 2, work,
           "the surface is no sphere with a vert on each edge that is cut");
    arrays = bench::arrays_of(surface);
    if constexpr (has_floor) {
      const auto expected = floor();
      const size_of_surface a = size_of(surface), b = size_of(expected);
      expect(cn::num_verts(surface) == expected.num_verts() && cn::num_polys(surface) == expected.num_polys() &&
                 arrays.verts.size() == expected.p2v.size() && close(a.area, b.area) && close(a.volume, b.volume),
             work, "the floor's surface and the library's differ");
    }
  }
  const auto adjacency = [&] {
    cn::surface_arrays copy = arrays;
    return bench::seconds_of([&] { return cn::polygonmesh(std::move(copy)); });
  };
  const auto alone = [&] {
    const double whole = bench::seconds_of(ours);
    return whole - adjacency();
  };
  if (p.wants(work)) {
    std::vector<bench::contender> them{{"concino", alone}};
    if constexpr (has_floor) them.insert(them.begin(), {"floor", timed(floor)});
    p.print(bench::compare(work, p.rounds, them));
  }
  if (p.wants(apart))
    p.print(bench::compare(apart, p.rounds, {{"floor", [&] {
                                                auto flat = bench::flat_surface<0>(arrays);
                                                return bench::seconds_of([&] { build(flat); return std::move(flat); });
                                              }},
                                             {"concino", adjacency}}));
}

template<class M>
void clip(const bench::program& p, const std::string& name, const M& m, const sphere<M>& s) {
  const std::string work = "clip." + name;
  if (!p.wants(work)) return;
  const auto ours = [&] { return cn::clip(m, s.u, s.level, {.properties = false}); };
  cn::polyhedra_arrays arrays;
  {
    const auto found = ours();
    const std::size_t n = cn::num_polys(found.mesh), caps = cn::num_polys(cn::isosurface(m, s.u, s.level).mesh);
    expect(s.outside + s.cut <= n && n <= s.outside + caps, work, "polys are missing");  // a poly with two caps may have two parts outside
    expect(found.report.cut_polys == s.cut && found.report.inverted_parts == 0 && found.cut_faces.size() == caps, work,
           "the cut is not the surface of isosurface");
    arrays = bench::arrays_of(found.mesh);
  }
  p.print(bench::compare(work, p.rounds, {{"concino", timed(ours)}, {"build", [&] {
                                                                       cn::polyhedra_arrays copy = arrays;
                                                                       return bench::seconds_of([&] { return cn::polyhedralmesh(std::move(copy)); });
                                                                     }}}));
}

/// Cuts a copy of m along the sphere.
template<class M>
void embed(const bench::program& p, const std::string& name, const M& m, const sphere<M>& s) {
  const std::string work = "embed." + name;
  if (!p.wants(work)) return;
  const auto with_values = [&] {
    M copy = m;
    const auto u = cn::vert_property<double>(copy, "u");
    for (const auto v : cn::verts(copy)) u[v] = s.u[v];
    return copy;
  };
  {
    M copy = with_values();
    const auto cut = cn::embed_isosurface(copy, "u", s.level);
    double area = 0;
    for (const auto f : cut.faces) area += cn::area(copy, f);
    expect(cut.verts.size() == s.cut_edges && close(area, size_of(cn::isosurface(m, s.u, s.level).mesh).area), work, "the faces are not the surface of isosurface");
  }
  p.print(bench::compare(work, p.rounds, {{"concino", [&] {
                                            M copy = with_values();
                                            return bench::seconds_of([&] { return cn::embed_isosurface(copy, "u", s.level); });
                                          }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto any = [&](const std::string& name) {
      for (const char* work : {"isosurface.", "isosurface.adjacency.", "clip.", "embed."})
        if (p.wants(work + name)) return true;
      return false;
    };
    isolines(p);
    if (any("tet1m")) {
      const auto arrays = p.data.tet1m();
      const cn::tetmesh m(arrays);
      const sphere s(p, "isosurface.tet1m", m, 0.34);
      const auto flat = bench::built<floors::tet_shape>(arrays);
      isosurface(p, "tet1m", m, s, [&] { return floors::level_polygons(flat, s.values, s.level); });
      embed(p, "tet1m", m, s);
    }
    if (any("hex1m")) {
      const cn::hexmesh m(p.data.hex1m());
      isosurface(p, "hex1m", m, sphere(p, "isosurface.hex1m", m, 0.4), nullptr);
    }
    if (any("poly1m")) {
      const auto m = cn::convert<cn::polyhedralmesh>(cn::hexmesh(p.data.hex1m()));
      const sphere s(p, "isosurface.poly1m", m, 0.4);
      isosurface(p, "poly1m", m, s, nullptr);
      clip(p, "poly1m", m, s);
    }
  });
}
