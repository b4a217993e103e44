// Compares isolines, isosurface, layers, split, and the embedding of level sets in copies of meshes that can be edited.
#pragma once

#include <agreement/matched.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/level_sets/clip.hpp>
#include <concino/level_sets/embed.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/print/heights.hpp>
#include <concino/print/planar_regions.hpp>
#include <concino/print/slice_mesh.hpp>
#include <concino/validate/check_laws.hpp>

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

/// The contours of a layer, and the native numbers of the polys that they pass.
template<class M, class Back>
std::pair<double, std::multiset<numbers>> layer_of(const mesh_slices<M>& s, std::size_t layer, const Back& back) {
  std::pair<double, std::multiset<numbers>> result{0, {}};
  for (const auto kind : {slice_lines_kind::outer, slice_lines_kind::inner, slice_lines_kind::open}) {
    const slice_lines& lines = kind == slice_lines_kind::outer ? s.layers[layer].outer : kind == slice_lines_kind::inner ? s.layers[layer].inner : s.layers[layer].open;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (kind != slice_lines_kind::open) result.first += contour_area(lines[i]);
      numbers passed;
      for (const poly_t<M>& p : s.polys_of(layer, kind, i)) passed.push_back(back(p));
      result.second.insert(sorted(passed));
    }
  }
  return result;
}

/// Compares the layers of slice_mesh.
template<class B>
void compare_layers(const B& both) {
  const box b = bounding_box(both.native);
  if (!(b.max.z > b.min.z)) return;
  const double thickness = (b.max.z - b.min.z) / 3;
  expect(heights(both.native, thickness) == heights(both.other, thickness), "the same heights");
  const slice_mesh_options any{.accept_open = true, .accept_intersections = true};
  const auto expected = unless_refused([&] { return slice_mesh(both.native, heights(both.native, thickness), any); });
  const auto found = unless_refused([&] { return slice_mesh(both.other, heights(both.native, thickness), any); });
  expect(expected.has_value() == found.has_value(), "both meshes are refused or neither");
  if (!found) return;
  for (std::size_t i = 0; i < expected->layers.size(); ++i) {
    const auto here = layer_of(*expected, i, [](const auto& p) { return p.raw(); });
    const auto there = layer_of(*found, i, [&](const auto& p) { return both.polys.back(p).raw(); });
    expect_close(here.first, there.first, b.diagonal() * b.diagonal(), "the areas of layers");
    expect(here.second == there.second, "contours pass the same polys");
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
    compare_layers(both);
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
    compare_layers(both);
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

struct embeds {
  static constexpr const char* name = "embed";
  template<class M> static constexpr bool is_editable = EditableSurfaceMesh<M> || EditableVolumeMesh<M>;
  template<class M> static constexpr bool runs_on = is_editable<M> && EmbeddedMesh<M> && std::is_copy_constructible_v<M> && requirement::has_room_for_parts<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    auto here = both.native;
    M there = both.other;
    auto here_u = make_vert_map<double>(here);
    auto there_u = make_vert_map<double>(there);
    const auto [u, w] = levels_of(both);
    for (const auto v : both.verts.all) {
      here_u[v] = u[v];
      there_u[both.verts.to(v)] = w[both.verts.to(v)];
    }
    const auto expected = unless_refused([&] { return embed(here, here_u); });
    const auto found = unless_refused([&] { return embed(there, there_u); });
    if (!found) {  // the library of M may have no room for the result; then nothing has changed
      expect(num_polys(there) == num_polys(both.other) && num_verts(there) == num_verts(both.other), "a refused mesh stays as it was");
      return false;
    }
    expect(expected.has_value(), "what the native mesh refuses is refused");
    expect(expected->verts.size() == found->verts.size() && expected->moved_verts.size() == found->moved_verts.size(), "as many new and moved verts");
    for (const auto& v : found->verts)
      if (arity_v<M> > 0 || dimension_v<M> == 2) expect(there_u[v] == 1.0, "the new verts have the value");  // polyhedra get verts in the middle of faces, too
    using number = std::remove_cvref_t<decltype(point(there, *verts(there).begin())[0])>;
    expect(outlines<number>(here, expected->verts) == outlines<number>(there, found->verts), "the same points of new verts");
    if constexpr (arity_v<M> == 0) expect(outlines<number>(here, polys(here)) == outlines<number>(there, polys(there)), "the same polys");
    if constexpr (arity_v<M> == 0 || dimension_v<M> == 2)
      expect(outlines<number>(here, cut_of(*expected)) == outlines<number>(there, cut_of(*found)), "the same edges or faces on the level set");
    else expect_close(area_of(here, cut_of(*expected)), area_of(there, cut_of(*found)), area_of(here, cut_of(*expected)), "the area of the level set");
    expect(check_laws(there).empty(), "the laws hold");
    return true;
  }

 private:
  using coordinates = std::array<double, 3>;

  template<class M, class U>
  static auto embed(M& m, U& u) {
    if constexpr (dimension_v<M> == 3) return embed_isosurface(m, u, 1.0);
    else return embed_isolines(m, u, 1.0);
  }
  template<class R>
  static const auto& cut_of(const R& r) {
    if constexpr (requires { r.faces; }) return r.faces;
    else return r.edges;
  }

  template<class M, class R>
  static double area_of(const M& m, const R& faces) {
    double sum = 0;
    for (const auto f : faces) sum += area(m, f);
    return sum;
  }

  /// The points of each element, with the accuracy of Number, in an order that does not depend on the mesh.
  template<class Number, class M, class R>
  static std::vector<std::vector<coordinates>> outlines(const M& m, const R& elements) {
    std::vector<std::vector<coordinates>> all;
    for (const auto x : elements) {
      std::vector<coordinates>& corners = all.emplace_back();
      const auto add = [&](const auto& v) {
        const vec3 p = to_vec3(point(m, v));
        corners.push_back({double(Number(p.x)), double(Number(p.y)), double(Number(p.z))});
      };
      using element = std::remove_cvref_t<decltype(x)>;
      if constexpr (std::is_same_v<element, vert_t<M>>) {
        add(x);
      } else if constexpr (std::is_same_v<element, poly_t<M>>) {
        for (const auto v : adj_p2v(m, x)) add(v);
      } else if constexpr (dimension_v<M> == 3) {
        for (const auto v : adj_f2v(m, x)) add(v);
      } else {
        for (const auto v : adj_e2v(m, x)) add(v);
      }
      const auto first = std::min_element(corners.begin(), corners.end());
      if (dimension_v<M> == 2 && corners.size() > 2) std::rotate(corners.begin(), first, corners.end());  // polys of surfaces have an orientation
      else std::sort(corners.begin(), corners.end());
    }
    std::sort(all.begin(), all.end());
    return all;
  }
};

}  // namespace concino::agreement
