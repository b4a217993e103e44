// The reports of validate on random volumes agree with a brute-force check of every element.
#include <concino/validate/validate.hpp>

#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

struct volume_facts {
  std::size_t crowded_faces = 0, unreferenced = 0, isolated = 0, open = 0, components = 0, loops = 0, skin_pieces = 0;
  std::ptrdiff_t chi = 0, skin_chi = 0;
  bool manifold = true, orientable = true;
};

template<class R>
auto list_of(const R& range) {
  std::vector<std::remove_cvref_t<decltype(*range.begin())>> r;
  for (const auto x : range) r.push_back(x);
  return r;
}

/// The number of connected components of the graph `joined` on `all`.
template<class X>
std::size_t classes(const std::vector<X>& all, const std::map<X, std::set<X>>& joined) {
  std::set<X> met;
  std::size_t n = 0;
  for (const X& x : all) {
    if (!met.insert(x).second) continue;
    ++n;
    std::vector<X> waiting = {x};
    while (!waiting.empty()) {
      const auto next = joined.find(waiting.back());
      waiting.pop_back();
      if (next == joined.end()) continue;
      for (const X& y : next->second)
        if (met.insert(y).second) waiting.push_back(y);
    }
  }
  return n;
}

/// Whether face f contains edge e in the direction from its first to its second vert.
template<class M>
bool runs(const M& m, face_id f, edge_id e) {
  const auto ring = list_of(adj_f2v(m, f));
  const auto ends = list_of(adj_e2v(m, e));
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ends[0] && ring[(i + 1) % ring.size()] == ends[1]) return true;
  return false;
}

template<class M>
volume_facts look_at(const M& m) {
  volume_facts r;
  std::set<std::size_t> used_verts, used_edges;
  for (const poly_id p : polys(m)) {
    std::map<edge_id, std::vector<bool>> sides;  // for each edge of p: whether faces have it in its direction, as seen from outside
    const auto faces_of_p = list_of(adj_p2f(m, p));
    for (const face_id f : faces_of_p) {
      for (const edge_id e : adj_f2e(m, f)) sides[e].push_back(runs(m, f, e) == face_is_outward(m, p, f));
      for (const vert_id v : adj_f2v(m, f)) used_verts.insert(v.raw());
    }
    bool open = false;
    for (const auto& [e, ways] : sides) {
      used_edges.insert(e.raw());
      open = open || ways.size() == 1;
      r.manifold = r.manifold && ways.size() == 2 && ways[0] != ways[1];
    }
    r.open += open;
    r.manifold = r.manifold && faces_of_p.size() >= 4;
  }
  std::map<poly_id, std::set<poly_id>> together;
  std::map<poly_id, std::vector<std::pair<poly_id, bool>>> across;  // the neighbours, and whether one of both must be inverted
  std::vector<face_id> skin;
  std::size_t used_faces = 0;
  for (const face_id f : faces(m)) {
    const auto at = list_of(adj_f2p(m, f));
    used_faces += !at.empty();
    r.unreferenced += at.empty();
    r.crowded_faces += at.size() > 2;
    for (const poly_id p : at)
      for (const poly_id q : at) together[p].insert(q);
    if (at.size() == 1) skin.push_back(f);
    if (at.size() != 2) continue;
    const bool turn = face_is_outward(m, at[0], f) == face_is_outward(m, at[1], f);
    across[at[0]].push_back({at[1], turn});
    across[at[1]].push_back({at[0], turn});
  }
  r.manifold = r.manifold && r.crowded_faces == 0;
  r.isolated = num_verts(m) - used_verts.size();
  r.components = classes(list_of(polys(m)), together);
  r.chi = static_cast<std::ptrdiff_t>(used_verts.size() + used_faces) - static_cast<std::ptrdiff_t>(used_edges.size() + num_polys(m));
  std::map<poly_id, bool> turned;
  for (const poly_id start : polys(m)) {
    if (!turned.emplace(start, false).second) continue;
    std::vector<poly_id> waiting = {start};
    while (!waiting.empty()) {
      const poly_id p = waiting.back();
      waiting.pop_back();
      for (const auto& [q, turn] : across[p]) {
        const auto [known, is_new] = turned.emplace(q, turned[p] != turn);
        if (is_new) waiting.push_back(q);
        r.orientable = r.orientable && known->second == (turned[p] != turn);
      }
    }
  }

  std::map<edge_id, std::vector<face_id>> at_edge;
  std::map<vert_id, std::set<vert_id>> pieces, border;
  std::map<vert_id, std::vector<face_id>> at_vert;
  for (const face_id f : skin) {
    const auto ring = list_of(adj_f2v(m, f));
    for (const vert_id v : ring) {
      at_vert[v].push_back(f);
      pieces[v].insert(ring.begin(), ring.end());
    }
    for (const edge_id e : adj_f2e(m, f)) at_edge[e].push_back(f);
  }
  for (const auto& [e, at] : at_edge) {
    r.manifold = r.manifold && at.size() <= 2;
    if (at.size() != 1) continue;
    const auto ends = list_of(adj_e2v(m, e));
    border[ends[0]].insert(ends[1]);
    border[ends[1]].insert(ends[0]);
  }
  std::vector<vert_id> skin_verts, border_verts;
  for (const auto& [v, at] : at_vert) {
    skin_verts.push_back(v);
    std::map<face_id, std::set<face_id>> fans;
    for (const edge_id e : adj_v2e(m, v))
      for (const face_id f : at_edge[e]) fans[f].insert(at_edge[e].begin(), at_edge[e].end());
    r.manifold = r.manifold && classes(at, fans) == 1;
  }
  for (const auto& [v, at] : border) border_verts.push_back(v);
  for (auto it = at_edge.begin(); it != at_edge.end();) it = it->second.empty() ? at_edge.erase(it) : std::next(it);
  r.loops = classes(border_verts, border);
  r.skin_pieces = classes(skin_verts, pieces);
  r.skin_chi = static_cast<std::ptrdiff_t>(skin_verts.size() + skin.size()) - static_cast<std::ptrdiff_t>(at_edge.size());
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("validate: agrees with a brute-force check on 1,000 random volumes", M, CONCINO_VOLUME_KINDS) {
  std::mt19937 random(13);
  std::size_t with_genus = 0;
  for (int round = 0; round < 1000; ++round) {
    const M m = random_mesh<M>(random);
    const volume_facts f = look_at(m);
    const auto r = validate(m, {.max_per_kind = 0});
    REQUIRE(r.count(defect_kind::non_manifold_face) == f.crowded_faces);
    REQUIRE(r.count(defect_kind::unreferenced_face) == f.unreferenced);
    REQUIRE(r.count(defect_kind::isolated_vert) == f.isolated);
    REQUIRE(r.count(defect_kind::open_cell) == f.open);
    REQUIRE((r.count(defect_kind::not_orientable) == 0) == f.orientable);
    REQUIRE(r.facts.components == f.components);
    REQUIRE(r.facts.boundary_loops == f.loops);
    REQUIRE(r.facts.euler_characteristic == f.chi);
    REQUIRE(r.facts.closed == (f.open == 0));
    REQUIRE(r.facts.orientable == f.orientable);
    REQUIRE(r.facts.manifold == f.manifold);
    REQUIRE(r.facts.genus.has_value() == (f.manifold && f.orientable));
    if (!r.facts.genus) continue;
    ++with_genus;
    REQUIRE(2 * static_cast<std::ptrdiff_t>(*r.facts.genus) == 2 * static_cast<std::ptrdiff_t>(f.skin_pieces) - f.skin_chi);
  }
  CHECK(with_genus > 50);
}
