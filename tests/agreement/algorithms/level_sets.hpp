// Compares isolines, isosurface and split.
#pragma once

#include <agreement/matched.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/level_sets/clip.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>

#include <array>
#include <optional>
#include <set>
#include <tuple>
#include <variant>

namespace concino::agreement {

/// A function of the native verts with values 0, 1, 2 and some between, and the same of the verts of the other mesh.
template<class B>
auto levels_of(const B& both) {
  auto a = make_vert_map<double>(both.native);
  auto b = make_vert_map<double>(both.other);
  for (const auto v : both.verts.all) {
    const unsigned n = v.raw() * 2654435761u >> 16;
    a[v] = b[both.verts.to(v)] = n % 4 == 3 ? 0.01 * (n % 200) : n % 4;
  }
  return std::pair(std::move(a), std::move(b));
}

/// A point of a level set: the number of the native element, and the coordinates, to the bit.
using level_point = std::tuple<int, unsigned, double, double, double>;

/// number(x): the number of an element of M.
template<class M, class Number>
level_point point_of(const mesh_point<M>& x, const Number& number) {
  const unsigned element = std::visit([&](const auto& y) { return number(y); }, x.element);
  return {static_cast<int>(x.element.index()), element, x.position.x, x.position.y, x.position.z};
}
template<class B>
level_point native_point(const B&, const mesh_point<typename B::native_mesh>& x) {
  return point_of(x, [](const auto& y) -> unsigned {
    if constexpr (requires { y.edge; }) return y.edge.raw();
    else return y.raw();
  });
}
template<class B>
level_point other_point(const B& both, const mesh_point<typename B::other_mesh>& x) {
  using M = typename B::other_mesh;
  const unsigned kind = static_cast<unsigned>(x.element.index());
  unsigned element = 0;
  if (const auto* v = std::get_if<0>(&x.element)) element = both.verts.back(*v).raw();
  else if (const auto* e = std::get_if<1>(&x.element)) element = both.edges.back(e->edge).raw();
  else if constexpr (VolumeMesh<M>) {
    if (const auto* f = std::get_if<2>(&x.element)) element = both.faces.back(*f).raw();
    else element = both.polys.back(std::get<3>(x.element)).raw();
  } else {
    element = both.polys.back(std::get<2>(x.element)).raw();
  }
  return {static_cast<int>(kind), element, x.position.x, x.position.y, x.position.z};
}

/// What make() returns; nothing if it refuses the mesh.
template<class F>
auto unless_refused(const F& make) -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const unsupported&) {
    return {};
  }
}

struct level_lines_of {
  static constexpr const char* name = "isolines";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto [u, w] = levels_of(both);
    const auto expected = isolines(both.native, u, {0.5, 1.0});
    const auto found = isolines(both.other, w, {0.5, 1.0});
    expect(expected.size() == found.size(), "as many lines");
    std::multiset<level_point> a, b;
    std::size_t closed = 0, closed_there = 0;
    for (const auto& line : expected) {
      closed += line.closed;
      for (const auto& x : line.places) a.insert(native_point(both, x));
    }
    for (const auto& line : found) {
      closed_there += line.closed;
      for (const auto& x : line.places) b.insert(other_point(both, x));
    }
    expect(closed == closed_there, "as many closed lines");
    expect(a == b, "the same points");
    return true;
  }
};

struct level_surfaces_of {
  static constexpr const char* name = "isosurface";
  template<class M> static constexpr bool runs_on = VolumeMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto [u, w] = levels_of(both);
    const auto expected = unless_refused([&, &values = u] { return isosurface(both.native, values, {0.5, 1.0}); });
    const auto found = unless_refused([&, &values = w] { return isosurface(both.other, values, {0.5, 1.0}); });
    expect(expected.has_value() == found.has_value(), "both meshes are refused or neither");
    if (!found) return false;
    std::multiset<level_point> a, b;
    for (const auto& x : expected->places) a.insert(native_point(both, x));
    for (const auto& x : found->places) b.insert(other_point(both, x));
    expect(a == b, "the same points");
    expect(sorted(raw_numbers(expected->polys)) == sorted(native_numbers(both.polys, found->polys)), "in the same polys");
    const double area = total_measure(expected->mesh);
    expect_close(area, total_measure(found->mesh), area, "the area");
    return true;
  }
};

struct clips {
  static constexpr const char* name = "split";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto [u, w] = levels_of(both);
    const auto expected = unless_refused([&, &values = u] { return split(both.native, values, 1.0); });
    const auto found = unless_refused([&, &values = w] { return split(both.other, values, 1.0); });
    expect(expected.has_value() == found.has_value(), "both meshes are refused or neither");
    if (!found) return false;
    const auto& a = expected->mesh;
    const auto& b = found->mesh;
    expect(num_verts(a) == num_verts(b) && num_edges(a) == num_edges(b) && num_polys(a) == num_polys(b), "as many elements");
    expect(expected->report.moved_verts.size() == found->report.moved_verts.size(), "as many moved verts");
    std::vector<unsigned> number(poly_index_bound(both.native)), number_there(poly_index_bound(both.other));
    for (const auto p : both.polys.all) {
      number[p.raw()] = p.raw();
      number_there[index_of(both.other, both.polys.to(p))] = p.raw();
    }
    const auto here = parts_of(*expected, number), there = parts_of(*found, number_there);
    const double largest = largest_of(polys(a), [&](const auto p) { return measure(a, p); });
    for (std::size_t i = 0; i < here.size(); ++i) {
      expect(here[i].poly == there[i].poly && here[i].above == there[i].above, "parts of the same polys in order");
      expect_close(here[i].size, there[i].size, largest, "the measure of a part");
    }
    return true;
  }

  struct part {
    unsigned poly, above;
    double size;
  };
  /// The parts of the polys in order, those of one poly below before above, and by size.
  template<class C>
  static std::vector<part> parts_of(const C& c, const std::vector<unsigned>& number) {
    std::vector<part> parts;
    for (const auto p : polys(c.mesh)) parts.push_back({number[(*c.from.polys[p.raw()].begin()).index], c.above[p.raw()], measure(c.mesh, p)});
    std::sort(parts.begin(), parts.end(), [](const part& a, const part& b) { return std::tie(a.poly, a.above, a.size) < std::tie(b.poly, b.above, b.size); });
    return parts;
  }
};

}  // namespace concino::agreement
