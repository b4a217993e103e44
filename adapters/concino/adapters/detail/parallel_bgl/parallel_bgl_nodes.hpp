// The nodes of a distributed mesh, verts or polys, as vertices of Parallel BGL, and the arcs from those of a process.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/parallel_bgl/parallel_bgl_graph.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/graph/support/graph_parts.hpp>

#include <mpi.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

template<class M> inline constexpr bool is_distributed_mesh = false;
template<class M> inline constexpr bool is_distributed_mesh<distributed<M>> = true;

/// The primal or dual graph of the distributed mesh itself, where that of a view of it is given.
template<class M> primal_graph<base_mesh_t<M>> graph_of_base(const primal_graph<M>& g) { return {base_mesh(g.m)}; }
template<class M> dual_graph<base_mesh_t<M>> graph_of_base(const dual_graph<M>& g) { return {base_mesh(g.m)}; }

template<class G>
const ghost_exchange& node_exchange(const G& g) { return g.m.exchange(static_cast<const typename G::node*>(nullptr)); }

/// The nodes of this process, whose position in `own` is their number for Parallel BGL, and what all local nodes are
/// there, by index. Collective.
template<class G>
struct distributed_nodes {
  using vertex = distributed_arcs::vertex_descriptor;
  std::vector<typename G::node> own;
  std::vector<vertex> vertices;

  explicit distributed_nodes(const G& g) {
    std::vector<std::size_t> number;
    on_all(g.m.communicator(), [&] {
      number.resize(g.bound());
      vertices.resize(g.bound());
      for (const auto x : g.nodes()) {
        if (g.m.is_ghost(x)) continue;
        number[g.index(x)] = own.size();
        own.push_back(x);
      }
    });
    node_exchange(g).to_ghosts(number.data());
    for (const auto x : g.nodes())
      vertices[g.index(x)] = vertex(static_cast<boost::processor_id_type>(g.m.owner(x)), number[g.index(x)]);
  }
};

/// By index, 1 for the nodes of this process that are sources on any process. Collective.
/// Errors: invalid_mesh if one is not local where it is given, invalid_argument if there is none.
template<class G, class S>
std::vector<char> mark_sources(const G& g, const S& sources, const char* caller) {
  using node = typename G::node;
  std::vector<char> is_source;
  int any = 0;
  on_all(g.m.communicator(), [&] {
    is_source.resize(g.bound());
    const auto take = [&](const node& x) {
      expect_node(g, x, caller, "source");
      is_source[g.index(x)] = 1;
      any = 1;
    };
    if constexpr (core::iterable<S> && !std::same_as<S, node>)
      for (const auto& x : sources) take(static_cast<node>(x));
    else take(static_cast<node>(sources));
  });
  (MPI_Allreduce)(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, g.m.communicator());
  if (!any) throw_empty_list(caller, "source", G::element_name);
  node_exchange(g).to_owners(is_source.data(), [](char& known, char other) { known |= other; });
  return is_source;
}

template<class G>
[[noreturn, gnu::noinline, gnu::cold]] void throw_bad_distributed_length(const G& g, const typename G::node& from,
                                                                         const typename G::node& to, double length,
                                                                         const char* caller) {
  core::throw_joined<invalid_mesh>({caller, ": the length from ", G::element_name, " ", g.m.global_number(from), " to ",
                                    G::element_name, " ", g.m.global_number(to), " is ",
                                    length < 0 ? core::number_text(length) : std::string("not a number"),
                                    "; lengths must be 0 or more"});
}

/// The arcs from the nodes of this process that may be passed, before Parallel BGL has them.
struct arc_lists {
  std::vector<std::size_t> ends;
  std::vector<distributed_arcs::arc> arcs;
  double max_length = 0;

  void add(const distributed_arcs::vertex_descriptor& target, double length) { arcs.push_back({target, length}); }
  void end_vertex() { ends.push_back(arcs.size()); }
};

/// is_source: empty, or as mark_sources returns it; sources may be left though options.may_enter excludes them. All
/// functions of the caller's are called here, so that none throws during a search. Collective.
template<class G, class Lengths, class Options>
arc_lists arcs_of(const G& g, const distributed_nodes<G>& nodes, const std::vector<char>& is_source,
                  const Lengths& lengths, const Options& options, const char* caller) {
  using node = typename G::node;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  arc_lists r;
  on_all(g.m.communicator(), [&] {
    for (const node& v : nodes.own) {
      const bool may_leave =
          !options.may_enter || (!is_source.empty() && is_source[g.index(v)]) || options.may_enter(v);
      if (may_leave) {
        const auto length_to = lengths.from(v);
        for_each_open_neighbour(g, v, options.may_enter, options.may_cross, [&](const node& w) {
          const double length = length_to(w, infinity);
          if (!(length >= 0)) throw_bad_distributed_length(g, v, w, length, caller);
          if (length == infinity) return;
          r.add(nodes.vertices[g.index(w)], length);
          r.max_length = std::max(r.max_length, length);
        });
      }
      r.end_vertex();
    }
  });
  return r;
}

/// Lengths for searches that count steps, or that need none.
struct unit_lengths {
  template<class Node>
  auto from(const Node&) const {
    return [](const Node&, double) { return 1.0; };
  }
};

}  // namespace concino::detail
