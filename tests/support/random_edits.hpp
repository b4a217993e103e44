// Random edits by every operator of this library, on meshes of any kind and of other libraries: after each, the numbers of elements and the total area or volume are as predicted;
// at intervals laws, validation and a newly constructed mesh agree; refused edits, rolled back transactions and conditions that throw leave equal meshes.
#pragma once

#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus.hpp>
#include <support/foreign_edits.hpp>
#include <support/kept_values.hpp>
#include <support/simplex_edits.hpp>
#include <support/some_element.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

namespace concino::testing {

/// The first operators keep the topology.
enum random_operator : unsigned {
  split_edge, collapse_edge, flip_edge, split_poly, split_vert, flip_face, split_face,
  add_a_vert, remove_a_vert, add_a_poly, remove_a_poly, move_a_vert, reverse_a_poly, merge_two_verts, split_fans, remove_unused, collect_garbage, add_a_face, remove_a_face,
  num_random_operators
};
inline constexpr unsigned num_topological_operators = add_a_vert;

template<class M> inline constexpr bool is_of_simplices = arity_v<M> == dimension_v<M> + 1;
/// Simplices, or a surface whose polys may be triangles.
template<class M> inline constexpr bool has_topological_operators = is_of_simplices<M> || (SurfaceMesh<M> && arity_v<M> == 0);

/// Whether a mesh of this kind has the operator.
template<class M>
constexpr bool has_operator(unsigned what) {
  constexpr bool is_volume = VolumeMesh<M>, has_faces_of_its_own = requirement::has_add_face<M>;
  if (what < num_topological_operators) return has_topological_operators<M> && (is_volume || what < flip_face);
  if (what == add_a_face) return has_faces_of_its_own;
  return what != remove_a_face || is_volume;
}

/// What an operator should change, if it was allowed.
struct predicted_change {
  permission answer = {};
  std::optional<std::ptrdiff_t> chi = 0;  // the number of verts - edges + faces - polys; unknown if empty
  std::optional<double> measure = 0;      // the sum of all areas or signed volumes
};

struct condition_failed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The number of verts - edges + faces - polys, in constant time.
template<class M>
std::ptrdiff_t alternating_count(const M& m) {
  const auto n = [](std::size_t x) { return static_cast<std::ptrdiff_t>(x); };
  const std::ptrdiff_t chi = n(num_verts(m)) - n(num_edges(m));
  if constexpr (VolumeMesh<M>) return chi + n(num_faces(m)) - n(num_polys(m));
  else return chi + n(num_polys(m));
}

template<class M, class Id>
void sort_by_index(const M& m, std::vector<Id>& all) {
  std::sort(all.begin(), all.end(), [&](const Id& a, const Id& b) { return index_of(m, a) < index_of(m, b); });
}

/// The elements that `all` lists as often as `count` says that they are in such lists.
template<class M, class Id, class Count>
std::vector<Id> listed_completely(const M& m, const std::vector<Id>& all, const Count& count) {
  std::vector<Id> found;
  std::vector<unsigned> times;  // by index
  for (const Id x : all) {
    const std::size_t i = index_of(m, x);
    if (i >= times.size()) times.resize(i + 1);
    if (++times[i] == static_cast<std::size_t>(count(x))) found.push_back(x);
  }
  return found;
}

/// Faces of a volume; surfaces have none.
template<class M> using face_list = std::vector<typename concino::detail::face_or_none<M>::type>;

/// What alternating_count() loses with these polys, and with these faces without polys. An element goes with the last poly, or face, that has it.
template<class M>
std::ptrdiff_t count_lost(const M& m, const std::vector<poly_t<M>>& removed, const face_list<M>& loose = {}) {
  const auto n = [](const auto& list) { return static_cast<std::ptrdiff_t>(list.size()); };
  std::vector<edge_t<M>> candidates;
  if constexpr (VolumeMesh<M>) {
    face_list<M> lost;
    for (const poly_t<M> p : removed)
      for (const face_t<M> f : adj_p2f(m, p)) lost.push_back(f);
    lost = listed_completely(m, lost, [&](face_t<M> f) { return num_elements(adj_f2p(m, f)); });
    lost.insert(lost.end(), loose.begin(), loose.end());
    for (const face_t<M> f : lost)
      for (const edge_t<M> e : adj_f2e(m, f)) candidates.push_back(e);
    return n(lost) - n(listed_completely(m, candidates, [&](edge_t<M> e) { return num_elements(adj_e2f(m, e)); })) - n(removed);
  } else {
    for (const poly_t<M> p : removed)
      for (const edge_t<M> e : adj_p2e(m, p)) candidates.push_back(e);
    return n(removed) - n(listed_completely(m, candidates, [&](edge_t<M> e) { return num_elements(adj_e2p(m, e)); }));
  }
}

template<class M>
std::vector<poly_t<M>> polys_at(const M& m, std::initializer_list<vert_t<M>> all) {
  std::vector<poly_t<M>> found;
  for (const vert_t<M> v : all)
    if (contains(m, v))
      for (const poly_t<M> p : adj_v2p(m, v)) found.push_back(p);
  if (all.size() == 1) return found;
  sort_by_index(m, found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// One mesh that is edited at random.
template<class M, class Values>
class random_editor {
  using vert_type = vert_t<M>;
  using edge_type = edge_t<M>;
  using poly_type = poly_t<M>;

  std::mt19937& random_;
  const Values& values_;
  bool throws_ = false;      // the next condition
  bool is_recorded_ = false;
  bool wants_prediction_ = true;

  edge_type edge() { return some_edge(m, random_); }
  poly_type poly() { return some_poly(m, random_); }
  vert_type vert() { return some_vert(m, random_); }
  auto face() { return some_element_of(m, faces(m), face_index_bound(m), random_); }
  vec3 somewhere() {
    const auto x = [&] { return static_cast<double>(random_() % 1024) / 1024; };
    return {x(), x(), x()};
  }
  std::vector<invariant> conditions() {
    if (!throws_) return {};
    return {[](const proposed_edit&) -> permission { throw condition_failed("a condition of the caller"); }};
  }
  /// An edit that models of other libraries may refuse, which have rules of their own.
  template<class Refused, class Edit>
  static permission attempt(const Edit& edit) {
    if constexpr (!HasProperties<M>) {
      try {
        edit();
      } catch (const Refused&) {
        return {refusal::unsupported, "the library cannot link it"};
      }
      return {};
    }
    edit();
    return {};
  }
  std::vector<vert_type> some_verts(std::size_t n, std::vector<vert_type> all = {}) {
    for (unsigned i = 0; all.size() < n && i < 100; ++i)
      if (const vert_type v = vert(); std::find(all.begin(), all.end(), v) == all.end()) all.push_back(v);
    return all;
  }
  face_list<M> loose_faces_at(vert_type v) const {
    face_list<M> all;
    if constexpr (VolumeMesh<M>)
      for (const face_t<M> f : adj_v2f(m, v))
        if (num_elements(adj_f2p(m, f)) == 0) all.push_back(f);
    return all;
  }

  /// Of these polys together; 0 if it is not asked for.
  double measure_of(const std::vector<poly_type>& all) const {
    double sum = 0;
    for (std::size_t i = 0; i < all.size() && wants_prediction_; ++i) sum += measure(m, all[i]);
    return sum;
  }
  double measure_of(poly_type p) const { return wants_prediction_ ? measure(m, p) : 0; }
  /// The measure after the edit minus the one before, of polys at these verts.
  template<class Edit>
  predicted_change with_measure_at(std::initializer_list<vert_type> touched, const Edit& edit) {
    if (!wants_prediction_) return {edit(), 0, std::nullopt};
    const double before = measure_of(polys_at(m, touched));
    predicted_change c{edit()};
    c.measure = measure_of(polys_at(m, touched)) - before;
    return c;
  }

 public:
  M m;

  random_editor(const M& start, std::mt19937& random, const Values& values) : random_(random), values_(values), m(start) {}

  /// Whether the conditions that operators ask throw, and whether the measure is predicted.
  void throw_in_conditions(bool yes) { throws_ = yes; }
  void predict(bool yes) { wants_prediction_ = yes; }
  /// Whether a transaction is open.
  void record(bool yes) { is_recorded_ = yes; }

  predicted_change apply(unsigned what) {
    if constexpr (has_topological_operators<M>)
      if (what < num_topological_operators) return topological(what);
    return elementary(what);
  }

 private:
  predicted_change topological(unsigned what)
    requires has_topological_operators<M>
  {
    switch (what) {
      case split_edge: return {edge_split(m, edge(), 0.3, {.keep = conditions()})};
      case collapse_edge: {
        const edge_type e = edge();
        const auto ends = end_verts(m, e);
        return with_measure_at({ends.first, ends.second}, [&] { return edge_collapse(m, e, {.keep = conditions(), .at = 0.5 * double(random_() % 3)}); });
      }
      case flip_edge: return flip_an_edge(edge());
      case split_poly: {
        const poly_type p = poly();
        vec3 middle;
        for (const vert_type v : adj_p2v(m, p)) middle += to_vec3(point(m, v)) / double(num_elements(adj_p2v(m, p)));
        return {poly_split(m, p, middle, {.keep = conditions()})};
      }
      case split_vert: return split_a_vert();
      default:
        if constexpr (VolumeMesh<M>) {
          const auto f = face();
          if (what == flip_face) return {face_flip(m, f, {.keep = conditions()})};
          vec3 middle;
          for (const vert_type v : adj_f2v(m, f)) middle += point(m, v) / 3;
          return {face_split(m, f, middle, {.keep = conditions()})};
        }
        return {};
    }
  }
  predicted_change flip_an_edge(edge_type e) {
    if constexpr (VolumeMesh<M>) {
      return {edge_flip(m, e, {.keep = conditions(), .diagonal = random_() % 2 ? 1u : 0u})};  // volumes have signs, so their sum is that of the cavity
    } else {
      double before = 0, after = 0;
      for (const poly_type p : adj_e2p(m, e)) before += measure(m, p);
      const auto made = edge_flip(m, e, {.keep = conditions()});
      if (!made) return {made};
      for (const poly_type p : adj_e2p(m, made.edge)) after += measure(m, p);
      return {made, 0, after - before};
    }
  }
  /// The moved polys of tets are those at an edge: a ball.
  predicted_change split_a_vert() {
    const vert_type v = *adj_p2v(m, poly()).begin();
    std::vector<poly_type> moved;
    if constexpr (VolumeMesh<M>) {
      for (const edge_t<M> e : adj_v2e(m, v))
        if (random_() % 4 == 0) {
          for (const poly_type p : adj_e2p(m, e)) moved.push_back(p);
          break;
        }
    } else {
      for (const poly_type p : adj_v2p(m, v))
        if (random_() % 3 == 0) moved.push_back(p);
    }
    const double before = measure_of(polys_at(m, {v}));
    const auto made = vert_split(m, v, moved, somewhere(), {.keep = conditions()});
    if (!made) return {made};
    return {made, 0, measure_of(polys_at(m, {v, made.vert})) - before};
  }

  predicted_change elementary(unsigned what) {
    switch (what) {
      case add_a_vert: return add_vert(m, somewhere()), predicted_change{{}, 1};
      case move_a_vert: {
        const vert_type v = vert();
        return with_measure_at({v}, [&] { return set_point(m, v, somewhere()), permission{}; });
      }
      case reverse_a_poly: {
        const poly_type p = poly();
        const double before = measure_of(p);
        const permission made = attempt<unsupported>([&] { flip_winding(m, p); });
        return {made, 0, measure_of(p) - before};
      }
      case remove_a_vert: {
        const vert_type v = vert();
        const auto gone = polys_at(m, {v});
        const predicted_change c{{}, -1 - count_lost(m, gone, loose_faces_at(v)), -measure_of(gone)};
        return remove_vert(m, v), c;
      }
      case remove_a_poly: {
        const poly_type p = poly();
        const predicted_change c{{}, -count_lost(m, std::vector{p}), -measure_of(p)};
        return remove_poly(m, p), c;
      }
      case add_a_poly: return add_some_poly();
      case merge_two_verts: {
        const vert_type v = vert(), w = vert();
        predicted_change c = with_measure_at({v, w}, [&] {
          return merge_verts(m, v, {w}, {.degenerate = random_() % 2 ? degenerate_polys::remove : degenerate_polys::refuse, .at_mean = random_() % 2 == 0});
        });
        c.chi = std::nullopt;
        return c;
      }
      case split_fans: return split_vert_fans(m, vert()), predicted_change{{}, std::nullopt};
      case remove_unused: return remove_unreferenced(m), predicted_change{{}, std::nullopt};
      case collect_garbage: return collect();
      default: return change_faces(what);
    }
  }
  predicted_change collect() {
    if (is_recorded_) return {};  // refused while a transaction is open
    if (wants_prediction_) {
      const auto before = values_.of(m);
      values_.check_moved(m, before, garbage_collect(m));
    } else {
      garbage_collect(m);
    }
    CHECK(num_verts(m) == vert_index_bound(m));
    CHECK(num_polys(m) == poly_index_bound(m));
    return {};
  }
  predicted_change add_some_poly() {
    poly_type p;
    if constexpr (requirement::has_add_poly_of_faces<M>) {
      std::set<face_t<M>> different;
      for (unsigned i = 0; i < 4; ++i) different.insert(face());
      const std::vector<face_t<M>> list(different.begin(), different.end());
      const std::vector<std::uint8_t> outward(list.size(), 1);
      p = traits<M>::add_poly(m, std::span<const face_t<M>>(list), std::span<const std::uint8_t>(outward));
      return {{}, -1, measure_of(p)};
    } else {
      const std::size_t n = arity_v<M> > 0 ? arity_v<M> : 3 + random_() % 3;
      const auto corners = some_verts(n, random_() % 2 ? ends_at_boundary() : std::vector<vert_type>());
      if (corners.size() < n) return {};
      if (const permission made = attempt<invalid_mesh>([&] { p = add_poly(m, std::span<const vert_type>(corners)); }); !made) return {made};
      return {{}, count_lost(m, std::vector{p}), measure_of(p)};
    }
  }
  /// The ends of an edge of one poly, in the order in which a neighbour has them; empty for other edges.
  std::vector<vert_type> ends_at_boundary() {
    if constexpr (SurfaceMesh<M>)
      if (num_edges(m) > 0) {
        const edge_type e = edge();
        const auto ends = end_verts(m, e);
        const auto at_edge = adj_e2p(m, e);
        if (num_elements(at_edge) != 1) return {};
        vert_type last{};
        for (const vert_type v : adj_p2v(m, *at_edge.begin())) last = v;
        for (const vert_type v : adj_p2v(m, *at_edge.begin())) {
          if (last == ends.first && v == ends.second) return {ends.second, ends.first};
          last = v;
        }
        return {ends.first, ends.second};
      }
    return {};
  }
  predicted_change change_faces(unsigned what) {
    if constexpr (VolumeMesh<M>) {
      if constexpr (requirement::has_add_face<M>)
        if (what == add_a_face) {
          const auto corners = some_verts(3 + random_() % 2);
          if (corners.size() < 3) return {};
          const face_t<M> f = add_face(m, std::span<const vert_type>(corners));
          return {{}, count_lost(m, {}, {f})};
        }
      if (what == remove_a_face) {
        const auto f = face();
        const auto at_face = adj_f2p(m, f);
        const std::vector<poly_type> gone(at_face.begin(), at_face.end());
        const face_list<M> loose(gone.empty() ? 1 : 0, f);
        const predicted_change c{{}, -count_lost(m, gone, loose), -measure_of(gone)};
        return remove_face(m, f), c;
      }
    }
    return {};
  }
};

/// Checks every edit of a mesh at random.
template<class M, class Values>
class random_edits_check {
  static constexpr unsigned compared = 1024, measured = 64;  // one edit in so many is compared with the mesh before, and its measure with the one before

  random_editor<M, Values> editor_;
  const Values& values_;
  std::mt19937& random_;

  bool one_in(unsigned n) { return random_() % n == 0; }
  static bool are_close(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(a) + std::abs(b)); }

  /// All that callers see.
  std::vector<double> state() {
    if constexpr (HasProperties<M>) return whole(editor_.m);
    else {
      std::vector<double> all = foreign_state(editor_.m);
      values_.append(editor_.m, all);
      return all;
    }
  }
  /// An edit whose conditions throw: nothing changes.
  void check_throwing(unsigned what) {
    const auto before = state();
    editor_.throw_in_conditions(true);
    try {
      const permission p = editor_.apply(what).answer;
      CHECK_FALSE(p);  // another reason came first
    } catch (const condition_failed&) {
    }
    editor_.throw_in_conditions(false);
    CHECK(state() == before);
  }
  /// A few edits that are undone.
  void check_roll_back(unsigned what) {
    const auto before = state();
    transaction<M> t(editor_.m);
    editor_.predict(false), editor_.record(true);
    for (unsigned i = 0; i < 3 && num_polys(editor_.m) > 0; ++i) editor_.apply(what);
    t.roll_back();
    editor_.record(false);
    CHECK(state() == before);
  }

 public:
  unsigned done[num_random_operators] = {}, refused[num_random_operators] = {};

  random_edits_check(const M& start, std::mt19937& random, const Values& values) : editor_(start, random, values), values_(values), random_(random) {}
  M& mesh() { return editor_.m; }
  void check(unsigned what) {
    INFO("operator ", what);
    M& m = editor_.m;
    if (one_in(compared) && what < num_topological_operators) check_throwing(what);
    if (one_in(compared)) check_roll_back(what);
    const bool is_compared = one_in(compared), is_measured = one_in(measured);
    const auto before = is_compared ? state() : std::vector<double>();
    const double size = is_measured ? total_measure(m) : 0;
    const std::ptrdiff_t chi = alternating_count(m);
    const auto values = is_measured ? values_.of(m) : typename Values::template list<M>();
    editor_.predict(is_measured);
    const predicted_change c = editor_.apply(what);
    ++(c.answer ? done : refused)[what];
    if (!c.answer) {
      if (is_compared) CHECK(state() == before);
      return;
    }
    if (c.chi && alternating_count(m) != chi + *c.chi) FAIL("the Euler characteristic is " << alternating_count(m) << ", not " << chi << " + " << *c.chi << " after operator " << what);
    if (is_measured && what != collect_garbage) values_.check_kept(m, values);
    if (is_measured && c.measure && !are_close(total_measure(m), size + *c.measure))
      FAIL("the sum of measures is " << total_measure(m) << ", not " << size << " + " << *c.measure << " after operator " << what);
  }
};

/// Edits copies of `start` by the operators below `end`, each `tries` times, but those that keep the topology in one round of four, if there are others too:
/// they have tests of their own. Copies are replaced by `start` when they have become too large or too small. `values`: of properties of another library's mesh.
/// Result: how often each operator was allowed. Topology: facts that all edits keep.
template<class M, class Values = no_values>
random_edits_check<M, Values> edit_at_random(const M& start, std::mt19937& random, unsigned tries, unsigned end, const Values& values = {}) {
  const bool keeps_topology = end <= num_topological_operators;
  const std::size_t most = num_polys(start) + 24, least = std::clamp<std::size_t>(num_polys(start) / 2, 2, 4);
  const auto facts = topology(start);
  random_edits_check<M, Values> r(start, random, values);
  M& m = r.mesh();
  for (unsigned i = 0; i < tries; ++i) {
    for (unsigned what = keeps_topology || i % 4 == 0 ? 0 : num_topological_operators; what < end; ++what) {
      if (!has_operator<M>(what)) continue;
      r.check(what);
      if (num_polys(m) < num_polys(start) / 2 || num_polys(m) < least) m = start;
    }
    if constexpr (has_topological_operators<M>)
      for (unsigned k = 0; k < 6 && num_polys(m) > most; ++k) r.check(collapse_edge);
    if (num_polys(m) > (has_topological_operators<M> ? 2 * most : 3 * num_polys(start))) m = start;
    if (edge_index_bound(m) > 8 * num_edges(m) + 100) garbage_collect(m);
    if (i % 1024 != 0 && i + 1 != tries) continue;
    keeps_all_laws(m);
    equals_rebuilt(m);
    if (keeps_topology) CHECK(topology(m) == facts);
    M used = m;
    remove_unreferenced(used);  // validate does not count faces without polys
    CHECK(validate(used).facts.euler_characteristic == euler_characteristic(used));
  }
  return r;
}

/// Edits another library's mesh by every operator, 10,000 times each: first by those that keep the topology, then by all. `values`: of properties of m.
template<class M, class Values>
void edits_of_all_kinds(M& m, std::mt19937& random, const Values& values) {
  values.write(m);
  const unsigned tries = long_run() ? 1000000 : 10000;
  const auto topological = edit_at_random(m, random, 3 * tries / 4, num_topological_operators, values);
  const auto all = edit_at_random(m, random, tries, num_random_operators, values);  // the topological ones in one round of four
  for (unsigned what = 0; what < num_random_operators; ++what)
    if (has_operator<M>(what)) {
      CHECK_MESSAGE(all.done[what] > 0, "operator " << what);
      CHECK_MESSAGE((what >= num_topological_operators || topological.done[what] > 0), "operator " << what);
    }
}

}  // namespace concino::testing
