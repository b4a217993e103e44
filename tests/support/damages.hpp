// Random damages of the meshes of the corpus, and checks that repair mends them: validate says of the mended mesh what it said of the undamaged one.
#pragma once

#include <concino/repair/repair.hpp>

#include <concino/geometry/bounding_box.hpp>
#include <concino/mesh/support/arrays_of.hpp>
#include <concino/repair/detail/point_clusters.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace concino::testing {

/// Whether the same is said of two meshes: kinds and numbers of defects, and facts.
template<class M>
void check_same_report(const M& m, const M& whole) {
  const auto a = validate(m, {.max_per_kind = 1}), b = validate(whole, {.max_per_kind = 0});
  for (std::size_t k = 0; k < num_defect_kinds; ++k) {
    const auto kind = static_cast<defect_kind>(k);
    if (kind == defect_kind::non_planar || kind == defect_kind::self_touching) continue;  // of triangles that fill holes
    INFO(defect_name(kind));
    CHECK(a.count(kind) == b.count(kind));
  }
  const mesh_facts &f = a.facts, &g = b.facts;
  CHECK(f.manifold == g.manifold);
  CHECK(f.orientable == g.orientable);
  CHECK(f.closed == g.closed);
  CHECK(f.components == g.components);
  CHECK(f.boundary_loops == g.boundary_loops);
  CHECK(f.euler_characteristic == g.euler_characteristic);
  CHECK(f.genus == g.genus);
}

template<class M>
void check_points(const M& m, const M& whole, const repair_result& fix, double tolerance) {
  for (const auto v : verts(m))
    if (tolerance > 0 || fix.from.verts[v.raw()].size() == 1)  // else it is in the middle of a fan
      for (const origin x : fix.from.verts[v.raw()])
        if (x.index < num_verts(whole)) CHECK(distance(point(m, v), point(whole, vert_id{x.index})) <= tolerance);
}

/// A mesh, as lists of verts of its polys; not of general polyhedra.
template<class M>
class damaged_lists {
  const M& whole_;
  std::mt19937& random_;

 public:
  std::vector<vec3> points;
  std::vector<std::vector<vert_id>> polys;

  damaged_lists(const M& whole, std::mt19937& random) : whole_(whole), random_(random) {
    for (const auto v : verts(whole)) points.push_back(point(whole, v));
    for (const auto p : concino::polys(whole)) {
      polys.emplace_back();
      for (const auto v : adj_p2v(whole, p)) polys.back().push_back(v);
    }
  }
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  /// Up to n polys, fewer than a third of all.
  std::set<std::size_t> some_polys(std::size_t n) {
    std::set<std::size_t> some;
    for (std::size_t i = 0; i < std::min(n, (polys.size() - 1) / 3); ++i) some.insert(below(polys.size()));
    return some;
  }
  vec3 noise(double size) {
    std::uniform_real_distribution<double> at(-size / 2, size / 2);
    return {at(random_), at(random_), at(random_)};
  }
  void turn(std::size_t p) {
    if constexpr (dimension_v<M> == 2) {
      std::reverse(polys[p].begin(), polys[p].end());
    } else {
      const standard_cell& cell = standard_cell_of(arity_v<M> == 4 ? cell_shape::tet : cell_shape::hex);
      const std::vector<vert_id> was = polys[p];
      for (std::size_t k = 0; k < was.size(); ++k) polys[p][k] = was[cell.mirrored[k]];
    }
  }
  /// Gives corners of their own verts, at their points but for noise.
  void tear(const std::set<std::size_t>& which, double size) {
    for (const std::size_t p : which)
      for (vert_id& v : polys[p]) {
        points.push_back(points[v.raw()] + noise(size));
        v = vert_id{points.size() - 1};
      }
  }
  M mesh() const {
    if constexpr (dimension_v<M> == 2) {
      surface_arrays a{points, {}, {}, static_cast<std::uint32_t>(arity_v<M>)};
      if (a.arity == 0) a.offsets.push_back(0);
      for (const auto& p : polys) {
        a.verts.insert(a.verts.end(), p.begin(), p.end());
        if (a.arity == 0) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      }
      return M(std::move(a));
    } else {
      cell_arrays a{points, {}, static_cast<std::uint32_t>(arity_v<M>)};
      for (const auto& p : polys) a.verts.insert(a.verts.end(), p.begin(), p.end());
      return M(std::move(a));
    }
  }
};

/// Whether no two verts are so close that merging would change the mesh.
template<class M>
bool has_verts_apart(const M& m, double tolerance) {
  const auto c = concino::detail::find_clusters(core::copy_points(m), 3 * tolerance);
  for (std::uint32_t i = 0; i < c.first.size(); ++i)
    if (c.first[i] != i) return false;
  return true;
}

template<class M>
M repaired_and_checked(M m, const M& whole, const repair_options& options, double tolerance) {
  const repair_result fix = repair(m, options);
  for (const std::string& s : fix.done) CHECK(!s.empty());
  check_same_report(m, whole);
  check_points(m, whole, fix, tolerance);
  return m;
}

/// A number of random damages of one mesh.      Result: how many.
template<class M>
std::size_t damage_polys(const M& whole, std::mt19937& random) {
  std::size_t done = 0;
  const auto report = validate(whole, {.max_per_kind = 0});
  const double tolerance = 1e-9 * bounding_box(whole).diagonal();
  const bool is_apart = has_verts_apart(whole, tolerance);
  const bool is_clean = report.count(defect_kind::isolated_vert) == 0 && report.count(defect_kind::duplicated_element) == 0;
  if (!is_clean) return 0;
  if (report.facts.orientable && report.count(defect_kind::inverted_cell) == 0) {  // turned polys
    damaged_lists<M> d(whole, random);
    for (const std::size_t p : d.some_polys(10)) d.turn(p);
    repaired_and_checked(d.mesh(), whole, {.orient = true}, 0), ++done;
  }
  {  // doubled polys, some of them the other way round
    damaged_lists<M> d(whole, random);
    for (const std::size_t p : d.some_polys(10)) {
      d.polys.push_back(std::vector<vert_id>(d.polys[p]));
      if (d.below(2)) d.turn(d.polys.size() - 1);
    }
    const auto mended = record_of(repaired_and_checked(d.mesh(), whole, {}, 0)), before = record_of(whole);
    CHECK(mended.points == before.points);
    CHECK(mended.elements == before.elements);
    ++done;
  }
  if (is_apart) {  // torn off, with noise below the tolerance, and all separate
    damaged_lists<M> d(whole, random);
    d.tear(d.some_polys(10), tolerance / 2);
    repaired_and_checked(d.mesh(), whole, {.merge_within = tolerance}, tolerance), ++done;
    damaged_lists<M> soup(whole, random);
    std::set<std::size_t> all;
    for (std::size_t p = 0; p < soup.polys.size(); ++p) all.insert(p);
    soup.tear(all, 0);
    const M m = repaired_and_checked(soup.mesh(), whole, {.merge_within = 0.0}, 0);
    CHECK(num_edges(m) == num_edges(whole));
    ++done;
  }
  if constexpr (dimension_v<M> == 2) {
    if (report.facts.manifold) {  // pinched: two verts far from each other become one
      damaged_lists<M> d(whole, random);
      std::size_t a = 0, b = 0;
      for (int tries = 0; tries < 50 && a == b; ++tries) {
        a = d.below(d.points.size()), b = d.below(d.points.size());
        std::set<vert_id> near;
        for (const auto p : adj_v2p(whole, vert_id{a}))
          for (const auto v : adj_p2v(whole, p)) near.insert(v);
        for (const auto p : adj_v2p(whole, vert_id{b}))
          for (const auto v : adj_p2v(whole, p))
            if (near.contains(v)) a = b;
      }
      if (a != b) {
        for (auto& p : d.polys)
          for (vert_id& v : p)
            if (v == vert_id{b}) v = vert_id{a};
        M m = d.mesh();
        REQUIRE(validate(m).count(defect_kind::non_manifold_vert) == 1);
        const auto fix = repair(m, {.split_non_manifold = true});
        CHECK(fix.count(repair_kind::split_verts) == 1);
        CHECK(fix.count(repair_kind::removed_verts) == 1);
        const auto f = validate(m, {.max_per_kind = 0}).facts;
        CHECK(f.manifold);
        CHECK(f.components == report.facts.components);
        CHECK(f.euler_characteristic == report.facts.euler_characteristic);
        ++done;
      }
    }
    if (report.facts.manifold && report.facts.closed && num_polys(whole) > 8) {  // holes
      for (const auto how : {hole_filling::minimal_area, hole_filling::fan}) {
        damaged_lists<M> d(whole, random);
        const auto p = poly_id{d.below(d.polys.size())};
        std::vector<std::size_t> removed{p.raw()};
        if (arity_v<M> == 3)
          for (const auto q : adj_p2p(whole, p)) removed.push_back(q.raw());
        std::sort(removed.rbegin(), removed.rend());
        for (const std::size_t q : removed) d.polys.erase(d.polys.begin() + static_cast<std::ptrdiff_t>(q));
        const M m = d.mesh();
        if (!validate(m).facts.manifold) continue;  // of neighbours that meet elsewhere too
        repaired_and_checked(m, whole, {.fill_holes = 12, .filling = how}, 0), ++done;
      }
    }
  }
  return done;
}

/// The same for polyhedra: doubled faces and verts, turned cells, open cells, faces of no cell.
inline std::size_t damage_polys(const polyhedralmesh& whole, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const double tolerance = 1e-9 * bounding_box(whole).diagonal();
  const auto report = validate(whole, {.max_per_kind = 0});
  if (num_polys(whole) < 4 || !has_verts_apart(whole, tolerance) || report.count(defect_kind::isolated_vert) > 0) return 0;
  const auto arrays = [&] {
    return core::polyhedra_of(whole, core::numbered(whole, verts(whole), num_verts(whole)), core::numbered(whole, faces(whole), num_faces(whole)));
  };
  std::size_t done = 0;
  {  // turned cells, turned faces of a cell, a face of no cell
    polyhedra_arrays a = arrays();
    for (int i = 0; i < 3; ++i) {
      const std::size_t p = below(a.num_polys()), f = below(a.outward.size());
      for (std::size_t k = a.poly_offsets[p]; k < a.poly_offsets[p + 1]; ++k) a.outward[k] ^= 1;
      a.outward[f] ^= 1;
    }
    a.face_verts.insert(a.face_verts.end(), {vert_id{0}, vert_id{1}, vert_id{2}});
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
    repaired_and_checked(polyhedralmesh(a), whole, {}, 0), ++done;
  }
  {  // each cell has faces of its own, and then verts of its own too
    for (const bool verts_too : {false, true}) {
      const polyhedra_arrays from = arrays();
      polyhedra_arrays a{from.points, {0}, {}, from.poly_offsets, {}, from.outward};
      for (std::size_t p = 0; p < from.num_polys(); ++p) {
        std::vector<std::uint32_t> number(from.points.size(), ~0u);
        for (std::size_t k = from.poly_offsets[p]; k < from.poly_offsets[p + 1]; ++k) {
          const std::size_t f = from.poly_faces[k].raw();
          a.poly_faces.push_back(face_id{a.face_offsets.size() - 1});
          for (std::size_t i = from.face_offsets[f]; i < from.face_offsets[f + 1]; ++i) {
            const vert_id v = from.face_verts[i];
            if (verts_too && number[v.raw()] == ~0u) {
              number[v.raw()] = static_cast<std::uint32_t>(a.points.size());
              a.points.push_back(a.points[v.raw()] + vec3{0, tolerance / 4, 0});
            }
            a.face_verts.push_back(verts_too ? vert_id{number[v.raw()]} : v);
          }
          a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
        }
      }
      const auto m = repaired_and_checked(polyhedralmesh(a), whole, {.merge_within = tolerance}, tolerance);
      CHECK(num_faces(m) == num_faces(whole));
      ++done;
    }
  }
  {  // an open cell: the result says which loop is missing
    polyhedra_arrays a = arrays();
    const std::size_t p = below(a.num_polys()), k = a.poly_offsets[p] + below(a.poly_offsets[p + 1] - a.poly_offsets[p]);
    const std::size_t f = a.poly_faces[k].raw(), n = a.face_offsets[f + 1] - a.face_offsets[f];
    a.poly_faces.erase(a.poly_faces.begin() + static_cast<std::ptrdiff_t>(k)), a.outward.erase(a.outward.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t q = p + 1; q < a.poly_offsets.size(); ++q) --a.poly_offsets[q];
    polyhedralmesh m(a);
    const auto fix = repair(m);
    REQUIRE(fix.count(repair_kind::open_cell) == 1);
    for (const auto& r : fix.records)
      if (r.kind == repair_kind::open_cell) {
        CHECK(r.elements[0] == p);
        CHECK(static_cast<std::size_t>(std::count(r.what.begin() + static_cast<std::ptrdiff_t>(r.what.find("verts")), r.what.end(), ' ')) == n);
      }
    ++done;
  }
  return done;
}

/// Damages each mesh of the corpus that has at most max_polys polys in several ways.      Result: how many damages.
inline std::size_t damage_corpus(std::size_t max_polys, unsigned seed) {
  std::size_t done = 0;
  for (const auto& row : corpus_meshes()) {
    INFO(row.name);
    std::visit(
        [&]<class M>(const M& m) {
          if (num_polys(m) > max_polys || num_polys(m) < 2) return;
          M same = m;
          if (validate(m).is_clean() && has_verts_apart(m, 0)) {
            CHECK(repair(same, {}).done.empty());
            CHECK(repair(same, {.merge_within = 0.0}).done.empty());
            CHECK(record_of(same) == record_of(m));
          }
          std::mt19937 random(seed);
          done += damage_polys(m, random);
        },
        load_any(row.file.string()));
  }
  return done;
}

}  // namespace concino::testing
