// Random edits of polygons and polyhedra, of any library: after each, the Euler characteristic and the signed area or volume are as before; at intervals laws and
// validation; refused edits, undone ones and conditions that throw leave equal meshes.
#pragma once

#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/foreign_edits.hpp>
#include <support/random_edits.hpp>
#include <support/some_element.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

namespace concino::testing {

enum poly_operator : unsigned { p_edge_split, p_edge_merge, p_poly_cut, p_merge_polys, p_collapse, p_face_cut, p_face_merge, num_poly_operators };

/// All that callers see.
template<class M>
std::vector<double> state_of(const M& m) {
  if constexpr (HasProperties<M>) return whole(m);
  else return foreign_state(m);
}

/// The signed area of polygons in the plane z = 0, or the volume: independent of where verts inside are.
template<class M>
double signed_size(const M& m) {
  if constexpr (VolumeMesh<M>) return total_measure(m);
  else {
    double sum = 0;
    for (const auto p : polys(m)) {
      std::vector<vec3> x;
      for (const auto v : adj_p2v(m, p)) x.push_back(to_vec3(point(m, v)));
      for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * cross(x[i], x[(i + 1) % x.size()]).z;
    }
    return sum;
  }
}

template<class M>
class random_poly_editor {
  std::mt19937& random_;
  bool throws_ = false;

  edit_options options() const {
    if (!throws_) return {};
    return {.keep = {[](const proposed_edit&) -> permission { throw condition_failed("a condition of the caller"); }}};
  }
  template<class R>
  auto one_of(const R& range) {
    std::vector<std::remove_cvref_t<decltype(*range.begin())>> all;
    for (const auto x : range) all.push_back(x);
    return all[random_() % all.size()];
  }
  /// A loop of edges around some faces of p.
  std::vector<edge_t<M>> some_loop(const poly_t<M>& p)
    requires VolumeMesh<M>
  {
    std::vector<face_t<M>> all, part;
    for (const auto f : adj_p2f(m, p)) all.push_back(f);
    part.push_back(all[random_() % all.size()]);
    const std::size_t wanted = 2 + random_() % all.size();
    for (unsigned tries = 0; tries < 30 && part.size() < wanted; ++tries) {
      const auto f = all[random_() % all.size()];
      bool is_known = false, is_next = false;
      for (const auto g : part) {
        is_known = is_known || g == f;
        for (const auto e : adj_f2e(m, f))
          for (const auto h : adj_f2e(m, g)) is_next = is_next || e == h;
      }
      if (!is_known && is_next) part.push_back(f);
    }
    std::vector<edge_t<M>> edges, once;
    for (const auto f : part)
      for (const auto e : adj_f2e(m, f)) edges.push_back(e);
    for (const auto& e : edges)
      if (std::count(edges.begin(), edges.end(), e) == 1) once.push_back(e);
    return once;
  }

 public:
  M m;
  bool shape_may_change = false;  // the last edit moved the boundary

  random_poly_editor(const M& start, std::mt19937& random) : random_(random), m(start) {}
  void throw_in_conditions(bool yes) { throws_ = yes; }

  permission apply(unsigned what) {
    shape_may_change = false;
    switch (what) {
      case p_edge_split: {
        const auto e = some_edge(m, random_);
        shape_may_change = VolumeMesh<M> && is_boundary(m, e);  // faces there may not be plane
        return edge_split(m, e, 0.25, {.keep = options().keep});
      }
      case p_edge_merge: {
        auto v = some_vert(m, random_);
        for (unsigned i = 0; i < 40 && num_elements(adj_v2e(m, v)) != 2; ++i) v = some_vert(m, random_);
        shape_may_change = is_boundary(m, v);
        const permission asked = can_edge_merge(m, v);
        if (shape_may_change && random_() % 4) return {refusal::wrong_set, "not tried"};
        const permission done = edge_merge(m, v, options());
        CHECK(asked.reason == done.reason);
        return done;
      }
      case p_poly_cut: {
        const auto p = some_poly(m, random_);
        if constexpr (VolumeMesh<M>) {
          const auto loop = some_loop(p);
          const permission asked = can_poly_cut(m, p, loop);
          const auto made = poly_cut(m, p, loop, options());
          CHECK(asked.reason == made.reason);
          if (made) CHECK((contains(m, made.face) && contains(m, made.polys[0]) && contains(m, made.polys[1]) && made.polys[0] == p));
          return made;
        } else {
          const auto a = one_of(adj_p2v(m, p)), b = one_of(adj_p2v(m, p));
          const permission asked = can_poly_cut(m, p, a, b);
          const auto made = poly_cut(m, p, a, b, options());
          CHECK(asked.reason == made.reason);
          if (made) CHECK((contains(m, made.edge) && contains(m, made.polys[0]) && contains(m, made.polys[1]) && made.polys[0] == p));
          return made;
        }
      }
      case p_merge_polys: {
        const auto f = some_element_of(m, facets(m), facet_index_bound(m), random_);
        const permission asked = can_merge_polys(m, f);
        const auto made = merge_polys(m, f, options());
        CHECK(asked.reason == made.reason);
        if (made) CHECK(contains(m, made.poly));
        return made;
      }
      case p_collapse: {
        const auto e = some_edge(m, random_);
        const auto ends = end_verts(m, e);
        const bool first = is_boundary(m, ends.first), second = is_boundary(m, ends.second);
        shape_may_change = first && second;
        if (shape_may_change && random_() % 4) return {refusal::wrong_set, "not tried"};
        const edge_collapse_options o{.keep = options().keep, .at = first ? 0.0 : second ? 1.0 : 0.5 * double(random_() % 3), .point = {}, .keeps_second = random_() % 2 == 0};
        const permission asked = can_edge_collapse(m, e, {.at = o.at, .keeps_second = o.keeps_second});
        const permission done = edge_collapse(m, e, o);
        CHECK(asked.reason == done.reason);
        return done;
      }
      default:
        if constexpr (VolumeMesh<M>) {
          const auto f = some_element_of(m, faces(m), face_index_bound(m), random_);
          shape_may_change = is_boundary(m, f);
          if (what == p_face_cut) {
            if (shape_may_change && random_() % 4) return {refusal::wrong_set, "not tried"};
            const auto a = one_of(adj_f2v(m, f)), b = one_of(adj_f2v(m, f));
            const permission asked = can_face_cut(m, f, a, b);
            const auto made = face_cut(m, f, a, b, options());
            CHECK(asked.reason == made.reason);
            if (made) CHECK((contains(m, made.edge) && contains(m, made.faces[0]) && contains(m, made.faces[1])));
            return made;
          }
          if (shape_may_change && random_() % 4) return {refusal::wrong_set, "not tried"};
          const auto e = one_of(adj_f2e(m, f));
          const auto g = one_of(adj_e2f(m, e));
          const permission asked = can_face_merge(m, f, g);
          const auto made = face_merge(m, f, g, options());
          CHECK(asked.reason == made.reason);
          if (made) CHECK(contains(m, made.face));
          return made;
        }
        return {refusal::unsupported, "no faces"};
    }
  }
};

/// How often each operator was allowed, and refused.
struct poly_edit_counts {
  unsigned done[num_poly_operators] = {}, refused[num_poly_operators] = {};
};

/// Edits copies of `start`, which are replaced by it when they have become too large or too small.
template<class M>
poly_edit_counts edit_polys_at_random(const M& start, std::mt19937& random, unsigned tries) {
  random_poly_editor<M> editor(start, random);
  M& m = editor.m;
  const auto facts = topology(start);
  poly_edit_counts count;
  double size = signed_size(m);
  const double scale = std::abs(size);
  const auto chi = alternating_count(m);
  const std::size_t least = std::max<std::size_t>(3, num_polys(start) / 3), most = 2 * num_polys(start) + 8;
  const auto one_in = [&](unsigned n) { return random() % n == 0; };
  for (unsigned i = 0; i < tries; ++i) {
    for (unsigned what = 0; what < num_poly_operators; ++what) {
      if (what > p_collapse && !VolumeMesh<M>) continue;
      INFO("operator " << what);
      if (num_polys(m) < least && (what == p_merge_polys || what == p_collapse)) continue;
      if (num_polys(m) > most && what == p_poly_cut) continue;
      if (num_verts(m) > 3 * num_verts(start) && what == p_edge_split) continue;
      if (one_in(512)) {  // conditions that throw, and edits that are undone
        const auto before = state_of(m);
        editor.throw_in_conditions(true);
        try {
          const permission p = editor.apply(what);
          CHECK_FALSE(p);
        } catch (const condition_failed&) {
        }
        editor.throw_in_conditions(false);
        CHECK(state_of(m) == before);
        if constexpr (requirement::has_edits<M>) {
          transaction<M> t(m);
          for (unsigned k = 0; k < 3; ++k) editor.apply(what);
          t.roll_back();
          CHECK(state_of(m) == before);
        }
      }
      const bool is_compared = one_in(64);
      const auto before = is_compared ? state_of(m) : std::vector<double>();
      const permission p = editor.apply(what);
      ++(p ? count.done : count.refused)[what];
      if (!p) {
        CHECK_FALSE(p.why.empty());
        if (is_compared) CHECK(state_of(m) == before);
        continue;
      }
      if (alternating_count(m) != chi) FAIL("the Euler characteristic is " << alternating_count(m) << " after operator " << what);
      if (is_compared || editor.shape_may_change) {
        const double now = signed_size(m);
        if (!editor.shape_may_change && std::abs(now - size) > 1e-12 * scale) FAIL("the size is " << now << ", not " << size << " after operator " << what);
        size = now;
      }
    }
    if (i % 256 == 0 || i + 1 == tries) {
      foreign_laws_hold(m);
      if (topology(m) != facts) FAIL("the topology changed");
      const auto all = validate(m);
      for (const auto& d : all.defects)
        if (d.kind == defect_kind::duplicated_element || d.kind == defect_kind::non_manifold_edge || d.kind == defect_kind::non_manifold_vert) FAIL("a defect: " << static_cast<int>(d.kind));
      if (num_polys(m) < least || i % 2048 == 0) m = start, size = signed_size(m);
    }
  }
  return count;
}

}  // namespace concino::testing
