// Compares bounding_tree, dual_mesh, agglomerate, subdivisions, swept surfaces, boundary surfaces, unions, simplices and what is to be filled with tets.
#pragma once

#include <agreement/matched.hpp>

#include <concino/generate/agglomerate.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/extrude.hpp>
#include <concino/generate/limit_points.hpp>
#include <concino/generate/offset_shell.hpp>
#include <concino/generate/quads_from_triangles.hpp>
#include <concino/generate/revolve.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/subdivide_midpoint.hpp>
#include <concino/generate/tetrahedralize.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/generate/to_triangles.hpp>
#include <concino/generate/unite.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>

#include <optional>

namespace concino::agreement {

struct trees {
  static constexpr const char* name = "bounding_tree";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto here = bounding_tree(both.native);
    const auto there = bounding_tree(both.other);
    const box whole = bounding_box(both.native);
    const double extent = whole.diagonal();
    const auto at = [&](double x, double y, double z) {
      return vec3{whole.min.x + x * (whole.max.x - whole.min.x), whole.min.y + y * (whole.max.y - whole.min.y), whole.min.z + z * (whole.max.z - whole.min.z)};
    };
    if (both.polys.empty()) {
      expect(!here.closest({}) && !there.closest({}), "nothing is near where there is nothing");
      return true;
    }
    for (const vec3& x : {at(0.31, 0.42, 0.53), at(0.77, 0.61, 0.13), at(-0.4, 1.7, 0.5), at(0.13, 0.07, 2.1)}) {
      const auto a = here.closest(x);
      const auto b = there.closest(x);
      expect(bool(a) == bool(b), "something is near");
      expect_close(a.distance, b.distance, extent, "the distance to the nearest point");
      expect(here.locate(x).has_value() == there.locate(x).has_value(), "some poly holds the point");
      const auto c = here.ray(x, {0.3, -0.2, -1});
      const auto d = there.ray(x, {0.3, -0.2, -1});
      expect(bool(c) == bool(d), "the ray meets something");
      if (c) expect_close(c.parameter, d.parameter, extent, "where the ray meets the first poly");
    }
    for (const auto p : both.polys.all)
      if (const vec3 c = centroid(both.native, p); is_finite(c)) expect(there.closest(c).distance <= here.closest(c).distance + 1e-12 * extent, "near each poly");
    const box part{at(0.2, 0.1, -1), at(0.6, 0.8, 0.7)};
    expect(sorted(raw_numbers(here.in_box(part))) == sorted(native_numbers(both.polys, there.in_box(part))), "the polys in a box");
    return true;
  }
};

/// A mesh, or nothing if it is refused.
template<class Make>
auto try_to(const Make& make) {
  try {
    return std::optional(make());
  } catch (const invalid_mesh&) {
    return std::optional<decltype(make())>();
  } catch (const invalid_argument&) {
    return std::optional<decltype(make())>();
  } catch (const unsupported&) {
    return std::optional<decltype(make())>();
  }
}

/// Checks that both fail, or return meshes with the same polys in the same order.
template<class A, class B>
bool expect_same_polys(const A& make_native, const B& make_other) {
  const auto a = try_to(make_native);
  const auto b = try_to(make_other);
  expect(a.has_value() == b.has_value(), "both meshes are refused or neither");
  if (!a) return false;
  expect(num_verts(*a) == num_verts(*b) && num_edges(*a) == num_edges(*b) && num_polys(*a) == num_polys(*b), "as many elements");
  const double largest = largest_of(polys(*a), [&](const auto p) { return measure(*a, p); }), extent = bounding_box(*a).diagonal();
  const auto others = polys(*b);
  auto next = others.begin();
  for (const auto p : polys(*a)) {
    const auto q = *next;
    ++next;
    expect_close(measure(*a, p), measure(*b, q), largest, "the measure of a poly");
    const vec3 x = centroid(*a, p), y = centroid(*b, q);
    for (std::size_t k = 0; k < 3; ++k) expect(std::abs(x[k] - y[k]) <= 1e-9 * extent, "the centroid of a poly");
  }
  return true;
}

struct duals {
  static constexpr const char* name = "dual_mesh";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    const dual_mesh_options all[] = {{}, {.crease_angle_deg = 40}, {.boundary = dual_boundary::closed}, {.boundary = dual_boundary::discarded}};
    for (const dual_mesh_options& o : all)
      any = expect_same_polys([&] { return dual_mesh(both.native, o); }, [&] { return dual_mesh(both.other, o); }) || any;
    return any;
  }
};

/// Checks that each poly of two models is divided into the same hexes, in any order.
template<class B>
bool expect_same_hexes(const B& both) {
  correspondence of_native, of_other;
  const auto a = try_to([&] { return subdivide_midpoint(both.native, {.correspondence = &of_native}); });
  const auto b = try_to([&] { return subdivide_midpoint(both.other, {.correspondence = &of_other}); });
  expect(a.has_value() == b.has_value(), "both meshes are refused or neither");
  if (!a) return false;
  expect(num_verts(*a) == num_verts(*b) && num_edges(*a) == num_edges(*b) && num_polys(*a) == num_polys(*b), "as many elements");
  const double largest = largest_of(polys(*a), [&](const auto p) { return measure(*a, p); }), extent = bounding_box(*a).diagonal();
  const auto n = static_cast<unsigned>(num_polys(*a));
  for (unsigned first = 0, last = 0; first < n; first = last) {
    while (last < n && of_native.polys.only(last) == of_native.polys.only(first)) ++last;
    for (unsigned i = first; i < last; ++i) {
      expect(of_other.polys.only(i) == of_other.polys.only(first), "the poly that was divided");
      const vec3 x = centroid(*a, poly_id{i});
      unsigned k = first;
      while (k < last && !(norm(centroid(*b, poly_id{k}) - x) <= 1e-9 * extent)) ++k;
      if (!is_finite(x)) continue;
      expect(k < last, "the centroid of a hex");
      expect_close(measure(*a, poly_id{i}), measure(*b, poly_id{k}), largest, "the measure of a hex");
    }
  }
  return true;
}

struct subdivisions {
  static constexpr const char* name = "subdivide";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if constexpr (VolumeMesh<decltype(both.native)>) {
      return expect_same_hexes(both);
    } else {
      const bool any = expect_same_polys([&] { return subdivide_midpoint(both.native); }, [&] { return subdivide_midpoint(both.other); });
      expect_same_polys([&] { return subdivide_catmull_clark(both.native); }, [&] { return subdivide_catmull_clark(both.other); });
      const double extent = bounding_box(both.native).diagonal();
      const auto here = catmull_clark_limit(both.native);
      const auto there = catmull_clark_limit(both.other);
      for (const auto v : both.verts.all) expect(!(norm(here.points[v] - there.points[both.verts.to(v)]) > 1e-9 * extent), "where a vert goes");
      return any;
    }
  }
};

/// A back end of tetrahedralize that keeps what it is to fill, and fails.
struct input_recorder {
  tetrahedralize_input* input;
  tetrahedralize_output tetrahedralize(const tetrahedralize_input& in, const tetrahedralize_options&) const {
    *input = in;
    throw unsupported("recorded");
  }
  static const char* name() { return "the recorder"; }
};

/// From surfaces to volumes, and back; and two meshes as one.
struct shells {
  static constexpr const char* name = "between_kinds";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    expect_same_polys([&] { return unite(both.native, both.native); }, [&] { return unite(both.other, both.native); });
    if constexpr (VolumeMesh<decltype(both.native)>) {
      const auto a = boundary_surface(both.native);
      const auto b = boundary_surface(both.other);
      expect(num_verts(a) == num_verts(b) && num_edges(a) == num_edges(b) && num_polys(a) == num_polys(b), "as many elements");
      expect_close(total_measure(a), total_measure(b), total_measure(a), "the area of the boundary");
      return num_polys(a) > 0;
    } else {
      const double size = bounding_box(both.native).diagonal(), thickness = 0.01 * size;
      if (!(size > 0)) return false;
      std::vector<poly_id> of_native, of_other;
      const bool any = expect_same_polys([&] { return offset_shell(both.native, thickness, 2, {.inverted = &of_native}); },
                                         [&] { return offset_shell(both.other, thickness, 2, {.inverted = &of_other}); });
      expect(of_native == of_other, "the inverted polys");
      const vec3 up{0.1 * size, -0.2 * size, size}, far = bounding_box(both.native).max + vec3{size, 0, 0};
      expect_same_polys([&] { return extrude(both.native, up, 2); }, [&] { return extrude(both.other, up, 2); });
      expect_same_polys([&] { return revolve(both.native, far, {0, 1, 0}, 5); }, [&] { return revolve(both.other, far, {0, 1, 0}, 5); });
      check_filling(both);
      return any;
    }
  }

 private:
  template<class B>
  static void check_filling(const B& both) {
    tetrahedralize_input here, there;
    try_to([&] { return tetrahedralize(both.native, input_recorder{&here}).mesh; });
    try_to([&] { return tetrahedralize(both.other, input_recorder{&there}).mesh; });
    expect(here.points.size() == there.points.size() && here.triangles.size() == there.triangles.size(), "as many triangles to be filled with tets");
    expect_close(here.diagonal, there.diagonal, here.diagonal, "the size of what is to be filled with tets");
  }
};

/// Triangles and tets of any polys, and quads of triangles.
struct simplices {
  static constexpr const char* name = "simplices";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if constexpr (VolumeMesh<decltype(both.native)>) {
      const auto a = try_to([&] { return to_tets(both.native); });
      const auto b = try_to([&] { return to_tets(both.other); });
      expect(a.has_value() == b.has_value(), "both meshes are refused or neither");
      if (!a) return false;
      expect(num_verts(*a) == num_verts(*b) && num_edges(*a) == num_edges(*b) && num_polys(*a) == num_polys(*b), "as many elements");
      expect_close(total_measure(*a), total_measure(*b), std::abs(total_measure(both.native)), "the volume");
      return num_polys(*a) > 0;
    } else {
      const auto a = try_to([&] { return to_triangles(both.native); });
      const auto b = try_to([&] { return to_triangles(both.other); });
      expect(a.has_value() == b.has_value(), "both meshes are refused or neither");
      if (!a) return false;
      expect(num_verts(*a) == num_verts(*b) && num_polys(*a) == num_polys(*b), "as many elements");
      const auto c = try_to([&] { return quads_from_triangles(both.native); });
      const auto d = try_to([&] { return quads_from_triangles(both.other); });
      expect(c.has_value() == d.has_value(), "both meshes are refused or neither");
      if (c) expect(num_polys(*c) == num_polys(*d), "as many quads");
      return num_polys(*a) > 0;
    }
  }
};

/// Labels that group consecutive polys, in the numbering of the first mesh. They can be read by polys of either mesh.
template<class P>
struct labels_of_pair {
  const P* pairs;
  unsigned size;
  int operator[](const typename P::descriptor& p) const { return static_cast<int>(pairs->back(p).raw() / size); }
};
struct labels_of_numbers {
  unsigned size;
  int operator[](poly_id p) const { return static_cast<int>(p.raw() / size); }
};

struct agglomerates {
  static constexpr const char* name = "agglomerate";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    for (const unsigned size : {1u, 2u, 6u}) {
      const labels_of_numbers ours{size};
      const labels_of_pair<std::remove_cvref_t<decltype(both.polys)>> theirs{&both.polys, size};
      any = expect_same_polys([&] { return agglomerate(both.native, ours); }, [&] { return agglomerate(both.other, theirs); }) || any;
    }
    return any;
  }
};

}  // namespace concino::agreement
