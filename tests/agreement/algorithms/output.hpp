// Compares save, in every format that can hold the mesh, make_drawable and make_arrows.
// Compares save, in every format that can hold the mesh, make_drawable, and the polys and facets that criteria select.
#pragma once

#include <agreement/copies.hpp>
#include <agreement/matched.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/render/arrows.hpp>
#include <concino/render/make_drawable.hpp>
#include <concino/render/slicing.hpp>

#include <support/formats.hpp>

#include <set>
#include <tuple>

namespace concino::agreement {

struct saving {
  static constexpr const char* name = "save";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using N = typename B::native_mesh;
    bool any = false;
    for (const format_id format : testing::formats_with_reader(standard_formats)) {
      if (format == file_format::stl) continue;  // its readers number verts by the first corners of polys, which may differ
      std::string here, there;
      const auto can = [&](const auto& m, std::string& text) {
        try {
          text = save_text(m, format);
          return true;
        } catch (const unsupported&) {
          return false;
        }
      };
      const bool possible = can(both.native, here);
      expect(possible == can(both.other, there), "the same formats can hold the mesh");
      if (!possible) continue;
      any = true;
      expect(same(load_text<N>(here, format), load_text<N>(there, format)), "what is saved is read alike");
    }
    return any;
  }

 private:
  /// Whether two meshes have the same points and the same polys, up to the first vert or face of each.
  static bool same(const polygonmesh& a, const polygonmesh& b) {
    const surface_arrays x = surface_arrays_of(a), y = surface_arrays_of(b);
    if (x.points != y.points || x.offsets != y.offsets) return false;
    for (const auto p : polys(a))
      if (rotated(raw_numbers(adj_p2v(a, p))) != rotated(raw_numbers(adj_p2v(b, p)))) return false;
    return true;
  }
  static bool same(const polyhedralmesh& a, const polyhedralmesh& b) {
    if (polyhedra_arrays_of(a).points != polyhedra_arrays_of(b).points || num_polys(a) != num_polys(b)) return false;
    const auto rings = [](const polyhedralmesh& m, poly_id p) {
      std::multiset<numbers> r;
      for (const auto f : adj_p2f(m, p)) {
        const numbers ring = raw_numbers(adj_f2v(m, f));
        r.insert(rotated(face_is_outward(m, p, f) ? ring : reversed(ring)));
      }
      return r;
    };
    for (const auto p : polys(a))
      if (rings(a, p) != rings(b, p)) return false;
    return true;
  }
};

struct drawing {
  static constexpr const char* name = "make_drawable";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    struct through {  // a value per vert that is the same on both meshes
      const B& both;
      double operator[](const vert_t<typename B::other_mesh>& v) const { return both.verts.back(v).raw(); }
    };
    struct number_itself {
      double operator[](vert_t<typename B::native_mesh> v) const { return v.raw(); }
    };
    const drawable a = make_drawable(both.native, {.field = number_itself{}, .inspect = true}),
                   b = make_drawable(both.other, {.field = through{both}, .inspect = true});
    compare_picked(both, *a.inspected, *b.inspected);
    expect(a.triangles.size() == b.triangles.size() && a.points.size() == b.points.size(), "as many triangles and points");
    std::vector<unsigned> native_poly(poly_index_bound(both.other));
    for (const auto p : both.polys.all) native_poly[index_of(both.other, both.polys.to(p))] = p.raw();
    const auto x = corners_of(a, [](unsigned i) { return i; }), y = corners_of(b, [&](unsigned i) { return native_poly[i]; });
    expect(x.size() == y.size(), "as many corners");
    for (std::size_t i = 0; i < x.size(); ++i) {
      expect(x[i].poly == y[i].poly && x[i].value == y[i].value && x[i].at == y[i].at, "the same corners");
      for (std::size_t k = 0; k < 3; ++k) expect(std::abs(x[i].normal[k] - y[i].normal[k]) < 1e-5f, "the same normals");
    }
    struct vectors {
      vec3 operator[](const poly_t<typename B::other_mesh>&) const { return {0, 1, 1}; }
      vec3 operator[](const poly_t<typename B::native_mesh>&) const
        requires(!std::same_as<poly_t<typename B::other_mesh>, poly_t<typename B::native_mesh>>)
      {
        return {0, 1, 1};
      }
    };
    const drawable here = make_arrows(both.native, vectors{}, {.corners = 3}), there = make_arrows(both.other, vectors{}, {.corners = 3});
    const double size = largest_of(here.points, [](const vec3& p) { return norm(p); });
    expect(here.points.size() == there.points.size() && here.triangles == there.triangles, "as many arrows");
    for (std::size_t i = 0; i < here.points.size(); ++i) expect(distance(here.points[i], there.points[i]) <= 1e-12 * size, "the same arrows");
    compare_slices(both);
    return true;
  }

 private:
  /// What a page keeps of the elements: all that is shown when one is picked.
  template<class B>
  static void compare_picked(const B& both, const inspected_mesh& here, const inspected_mesh& there) {
    numbers vert_of(there.points.size());
    for (const auto v : both.verts.all) {
      const std::size_t i = index_of(both.native, v), j = index_of(both.other, both.verts.to(v));
      expect(here.points[i] == there.points[j] && here.values[0].numbers[i] == there.values[0].numbers[j], "the same points and values");
      vert_of[j] = static_cast<unsigned>(i);
    }
    const auto itself = [](std::uint32_t v) { return v; };
    const auto native = [&vert_of](std::uint32_t v) { return v < vert_of.size() ? vert_of[v] : ~0u; };
    expect(edges_of(here, itself) == edges_of(there, native), "the same edges");
    for (const auto p : both.polys.all) {
      const std::size_t i = index_of(both.native, p), j = index_of(both.other, both.polys.to(p));
      expect(polygons_of(here, i, itself) == polygons_of(there, j, native), "the same corners of polys");
      expect(distance(here.centroids[i], there.centroids[j]) <= 1e-12 * (1 + norm(here.centroids[i])), "the same centroids");
    }
  }

  /// The ends of all edges, sorted.
  template<class F>
  static std::multiset<numbers> edges_of(const inspected_mesh& m, const F& number) {
    std::multiset<numbers> all;
    for (std::size_t e = 0; e + 1 < m.edge_verts.size(); e += 2)
      if (m.edge_verts[e] != m.edge_verts[e + 1]) all.insert(sorted({number(m.edge_verts[e]), number(m.edge_verts[e + 1])}));
    return all;
  }
  /// The polygons of a poly, which begin anywhere: itself, or its faces seen from outside.
  template<class F>
  static std::multiset<numbers> polygons_of(const inspected_mesh& m, std::size_t poly, const F& number) {
    const auto ring = [&](std::size_t polygon) {
      numbers r;
      for (std::size_t c = m.polygon_offsets[polygon]; c < m.polygon_offsets[polygon + 1]; ++c) r.push_back(number(m.polygon_verts[c]));
      return r;
    };
    if (!m.is_volume) return {rotated(ring(poly))};
    std::multiset<numbers> all;
    for (std::size_t k = m.poly_offsets[poly]; k < m.poly_offsets[poly + 1]; ++k) {
      const std::uint32_t face = m.poly_faces[k];
      all.insert(rotated(face % 2 ? reversed(ring(face / 2)) : ring(face / 2)));
    }
    return all;
  }

  template<class B>
  static void compare_slices(const B& both) {
    const auto number = [](const auto& p) { return p.raw() % 4 > 0; };
    const auto through = [&both](const poly_t<typename B::other_mesh>& p) { return both.polys.back(p).raw() % 4 > 0; };
    const auto here = below_fraction('x', 0.4567) || where(number) || peeled(1);
    const auto there = below_fraction('x', 0.4567) || where(through) || peeled(1);
    const auto a = visible_polys(both.native, here);
    const auto b = visible_polys(both.other, there);
    for (const auto p : both.polys.all) expect(a[p] == b[both.polys.to(p)], "the same polys meet a criterion");
    expect(exposed_facets(both.native, here).size() == exposed_facets(both.other, there).size(), "as many facets are laid bare");
  }

  struct corner {
    unsigned poly;
    double value;
    double polygon;  // the sum of its values, to distinguish several polygons of a poly
    vec3 at;
    std::array<float, 3> normal;
  };
  /// Sorted by poly, polygon and value, as polygons come in any order and begin anywhere.
  template<class F>
  static std::vector<corner> corners_of(const drawable& d, const F& poly) {
    std::vector<corner> r;
    for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p) {
      double sum = 0;
      for (auto c = d.offsets[p]; c < d.offsets[p + 1]; ++c) sum += std::sqrt(d.values[d.corners[c]] + 1);
      for (auto c = d.offsets[p]; c < d.offsets[p + 1]; ++c)
        r.push_back({poly(d.polys[p]), d.values[d.corners[c]], std::round(sum * 1e6), d.points[d.corners[c]], d.normals[c]});
    }
    std::sort(r.begin(), r.end(), [](const corner& a, const corner& b) { return std::tuple(a.poly, a.polygon, a.value) < std::tuple(b.poly, b.polygon, b.value); });
    return r;
  }
};

}  // namespace concino::agreement
