// Measures Boost's compressed sparse row graph through its adapter, against loops over its arcs and against the functions of Boost.Graph. The graph is that
// of the verts of a triangle mesh; edge lengths are computed during the search.
#include "by_hand.hpp"
#include "../peers/boost_csr.hpp"

#include <concino/adapters/boost_graph.hpp>

#include <boost/graph/connected_components.hpp>

namespace {

using graph = bench::peers::csr_graph;

struct boost_arcs {
  const graph& g;
  using vert = boost::graph_traits<graph>::vertex_descriptor;
  std::size_t index(vert v) const { return v; }
  template<class F>
  void around(vert v, F&& f) const {
    for (auto [a, end] = out_edges(v, g); a != end; ++a) f(target(*a, g));
  }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    namespace hand = bench::by_hand;
    const auto arrays = p.data.tri1m();
    const auto f = bench::built<3>(arrays);
    const graph g = bench::peers::make_csr(bench::floors::rows<0>{f.v_off.data(), f.v2v.data(), f.num_verts()}, f.points.data());
    const boost_arcs l{g};
    using vert = boost_arcs::vert;
    const std::size_t n = num_vertices(g);
    bench::peers::searches own(g);
    const auto& x = arrays.points;
    const auto values = [](const auto& r) {
      if constexpr (requires { r.labels; }) return r.labels.values();
      else return r.values();
    };
    hand::compare(p, "boost-csr.bfs", [&] { return hand::bfs(l, vert{0}, n); }, [&] { return concino::bfs(g, vert{0}); }, values, [&] { return &own.bfs(0); });
    hand::compare(p, "boost-csr.components", [&] { return hand::components<vert>(l, n, [](std::size_t i) { return vert(i); }); },
                  [&] { return concino::connected_components(g); }, values, [&] {
                    std::vector<int> label(n);
                    boost::connected_components(g, boost::make_iterator_property_map(label.begin(), get(boost::vertex_index, g)));
                    return label;
                  });
    hand::compare(p, "boost-csr.dijkstra", [&] { return hand::dijkstra(l, vert{0}, n, [&](vert v) { return x[v]; }); },
                  [&] { return concino::dijkstra(g, vert{0}, [&](vert a, vert b) { return norm(x[a] - x[b]); }); }, values,
                  [&] { return &own.dijkstra_measuring(0, f.points.data()); });
  });
}
