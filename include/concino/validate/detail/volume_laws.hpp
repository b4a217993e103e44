// The laws of VolumeMesh (VM1 .. VM8).
#pragma once

#include <concino/core/message.hpp>
#include <concino/validate/detail/mesh_laws.hpp>

#include <array>
#include <new>

namespace concino::detail {

/// The faces of a tet or hex in the standard order, counter-clockwise seen from outside; -1 ends a face of fewer verts.
template<int Arity> inline constexpr std::array<std::array<int, 4>, 0> standard_faces{};
template<>
inline constexpr std::array<std::array<int, 4>, 4> standard_faces<4>{
    {{0, 2, 1, -1}, {0, 1, 3, -1}, {0, 3, 2, -1}, {1, 2, 3, -1}}};
template<> inline constexpr std::array<std::array<int, 4>, 6> standard_faces<8>{
    {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}}};

/// The number of the standard face with the local verts `face`, starting at any of them; -1 if none.
template<int Arity>
int standard_face(std::span<const int> face) {
  for (std::size_t s = 0; s < standard_faces<Arity>.size(); ++s) {
    const auto& want = standard_faces<Arity>[s];
    const std::size_t n = want[3] < 0 ? 3 : 4;
    for (std::size_t turn = 0; face.size() == n && turn < n; ++turn) {
      std::size_t i = 0;
      while (i < n && face[(turn + i) % n] == want[i]) ++i;
      if (i == n) return static_cast<int>(s);
    }
  }
  return -1;
}

/// VM7: the verts of tets and hexes are in the standard order.
template<int Arity, class P, class V>
void check_standard_order(const element_table<P>& ps, const element_table<V>& vs, const adjacency_lists& p2v,
                          const adjacency_lists& p2f, const adjacency_lists& f2v, const std::vector<bool>& outward,
                          law_log& log) {
  std::vector<int> local;
  for (order_index p = 0; p < ps.size() && !log.full("VM7"); ++p) {
    const auto ring = p2v[p];
    bool good = ring.size() == Arity && p2f[p].size() == standard_faces<Arity>.size();
    unsigned visited = 0;
    for (std::size_t k = 0; good && k < p2f[p].size(); ++k) {
      const auto cycle = f2v[p2f[p][k]];
      local.clear();
      for (const order_index v : cycle) {
        const auto found = std::find(ring.begin(), ring.end(), v);
        local.push_back(found == ring.end() ? -2 : static_cast<int>(found - ring.begin()));
      }
      if (!outward[p2f.offsets[p] + k]) std::reverse(local.begin(), local.end());
      const int which = standard_face<Arity>(local);
      good = which >= 0 && !(visited >> which & 1u);
      if (good) visited |= 1u << which;
    }
    if (!good && vs.is_complete)
      log.add("VM7",
              core::joined({"adj_p2v(", ps.name(p), ") is not the standard order of a ", Arity == 4 ? "tet" : "hex",
                      " with the faces adj_p2f gives, turned outward"}),
              ps.name(p));
  }
}

/// VM6: an edge of a poly that lies in two of its faces is traversed by them in opposite directions, if they are turned
/// outward.
template<class P, class E>
void check_winding(const element_table<P>& ps, const element_table<E>& es, const adjacency_lists& p2f,
                   const adjacency_lists& f2e, const std::vector<sense>& senses, const std::vector<bool>& outward,
                   law_log& log) {
  struct tally { order_index poly = no_order_index; int faces = 0, sum = 0; };
  std::vector<tally> at(es.items.size());
  for (order_index p = 0; p < ps.size() && !log.full("VM6"); ++p) {
    bool closed = true;
    const auto each = [&](const auto& visit) {
      for (std::size_t k = p2f.offsets[p]; k < p2f.offsets[p + std::size_t{1}]; ++k) {
        const order_index f = p2f.items[k];
        for (std::size_t j = f2e.offsets[f]; j < f2e.offsets[f + std::size_t{1}]; ++j) visit(k, j);
      }
    };
    each([&](std::size_t k, std::size_t j) {
      tally& t = at[f2e.items[j]];
      if (t.poly != p) t = {p, 0, 0};
      closed = closed && senses[j] != sense::inconsistent;
      ++t.faces;
      t.sum += (senses[j] == sense::along) == outward[k] ? 1 : -1;
    });
    each([&](std::size_t, std::size_t j) { closed = closed && at[f2e.items[j]].faces == 2; });
    if (!closed) continue;
    bool good = true;
    each([&](std::size_t, std::size_t j) {
      const order_index e = f2e.items[j];
      if (good && at[e].sum != 0) {
        good = false;
        log.add("VM6",
                core::joined({"the two faces of ", ps.name(p), " at ", es.name(e),
                        ", turned outward as face_is_outward says, run along it in the same sense"}),
                core::joined({ps.name(p), " ", es.name(e)}));
      }
    });
  }
}

template<VolumeMesh M>
void check_volume_mesh(const M& m, const graph_tables<vert_t<M>>& primal, const graph_tables<poly_t<M>>& dual,
                       law_log& log) {
  const auto& vs = primal.nodes;
  const auto& ps = dual.nodes;
  const edge_tables<M> edge = check_edges(m, primal, log);
  const auto& es = edge.edges;
  const auto fs = read_elements<face_t<M>>(m, 'f', faces, num_faces, face_index_bound, "VM1", "VM1", log);

  const adjacency_lists f2v = read_adjacency(m, fs, vs, adj_f2v, "VM2", "adj_f2v", log);
  const adjacency_lists f2e = read_adjacency(m, fs, es, listed_f2e{}, "VM2", "adj_f2e", log);
  const std::vector<sense> senses = check_cycles(fs, vs, es, f2v, f2e, edge.e2v, "VM2", "adj_f2v", "adj_f2e", log);

  if constexpr (!lists_edges_unordered<M>)
    check_edges_in_order(
        fs, vs, es, f2v, f2e, edge.e2v,
        [](std::size_t k, std::size_t n) { return std::pair(k, k + 1 == n ? 0 : k + 1); }, "VM8", "adj_f2e", "adj_f2v",
        log);

  const adjacency_lists p2f = read_adjacency(m, ps, fs, adj_p2f, "VM3", "adj_p2f", log);
  const adjacency_lists f2p = read_adjacency(m, fs, ps, adj_f2p, "VM3", "adj_f2p", log);
  check_mirror(es, fs, read_adjacency(m, es, fs, adj_e2f, "VM3", "adj_e2f", log), f2e, "VM3", "adj_e2f", "adj_f2e",
               log);
  check_mirror(vs, fs, read_adjacency(m, vs, fs, adj_v2f, "VM3", "adj_v2f", log), f2v, "VM3", "adj_v2f", "adj_f2v",
               log);
  check_mirror(fs, ps, f2p, p2f, "VM3", "adj_f2p", "adj_p2f", log);

  const adjacency_lists p2v = read_adjacency(m, ps, vs, adj_p2v, "VM4", "adj_p2v", log);
  const adjacency_lists p2e = read_adjacency(m, ps, es, listed_p2e{}, "VM4", "adj_p2e", log);
  check_same(ps, es, p2e, composed(p2f, f2e), "VM4", "adj_p2e", "an edge of one of its faces", log);
  check_mirror(es, ps, read_adjacency(m, es, ps, adj_e2p, "VM4", "adj_e2p", log), p2e, "VM4", "adj_e2p", "adj_p2e",
               log);
  check_same(ps, vs, p2v, composed(p2f, f2v), "VM4", "adj_p2v", "a vert of one of its faces", log);
  check_mirror(vs, ps, read_adjacency(m, vs, ps, adj_v2p, "VM4", "adj_v2p", log), p2v, "VM4", "adj_v2p", "adj_p2v",
               log);

  check_neighbours(ps, fs, dual.next, p2f, f2p, "VM5", log);

  std::vector<bool> outward(p2f.items.size());  // parallel to p2f
  for (order_index p = 0; p < ps.size(); ++p)
    for (std::size_t k = p2f.offsets[p]; k < p2f.offsets[p + std::size_t{1}]; ++k) {
      try {
        outward[k] = face_is_outward(m, ps.items[p], fs.items[p2f.items[k]]);
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception& e) {
        log.add("VM6", core::joined({"face_is_outward throws: ", e.what()}),
                core::joined({ps.name(p), " ", fs.name(p2f.items[k])}));
      }
    }
  check_winding(ps, es, p2f, f2e, senses, outward, log);
  // the laws of tets and hexes
  if constexpr (arity_v<M> == 4 || arity_v<M> == 8)
    check_standard_order<arity_v<M>>(ps, vs, p2v, p2f, f2v, outward, log);
  if constexpr (arity_v<M> == 4 && !lists_edges_unordered<M>) {  // in other volumes the edges of a poly have no order
    static constexpr std::pair<std::size_t, std::size_t> ends[6] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    check_edges_in_order(
        ps, vs, es, p2v, p2e, edge.e2v, [](std::size_t k, std::size_t) { return ends[k % 6]; }, "VM8", "adj_p2e",
        "adj_p2v", log);
  }
}

}  // namespace concino::detail
