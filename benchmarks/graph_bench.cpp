// Measures breadth-first search, connected components and Dijkstra against the floor and Boost.Graph, on the primal and dual graphs of a surface and a volume.
#include "floor/graph.hpp"
#include "peers/boost_csr.hpp"
#include "support/program.hpp"

#include <concino/graph.hpp>
#include <concino/mesh.hpp>

namespace {

using bench::u32;
namespace floors = bench::floors;

template<class A, class B>
void expect_equal(const std::string& work, const A& a, const B& b) {
  for (u32 i = 0; i < a.size(); ++i) {
    const auto x = static_cast<double>(a[i]), y = static_cast<double>(b[i]);
    if (!(x == y || std::abs(x - y) <= 1e-9 * std::abs(x)))
      throw std::runtime_error(work + ": results differ at node " + std::to_string(i));
  }
}

/// Measures all contenders on one graph. `centres` computes the positions of the nodes; this is part of the measured work.
template<u32 Stride, bool Filled, class M, class Node, class Centres>
void searches(const bench::program& p, const std::string& what, const floors::rows<Stride>& g, const M& m, Node source, Centres centres) {
  const auto points = centres();
  const auto graph = bench::peers::make_csr(g, points.data());
  bench::peers::searches boost(graph);
  const u32 s = source.raw();

  if (const std::string work = "bfs." + what; p.wants(work)) {
    const auto hops = floors::bfs<Stride, Filled>(g, s);
    expect_equal(work, hops, concino::bfs(m, source).values());
    expect_equal(work, hops, boost.bfs(s));
    p.print(bench::compare(work, p.rounds,
                           {{"floor", [&] { return bench::seconds_of([&] { return floors::bfs<Stride, Filled>(g, s); }); }},
                            {"concino", [&] { return bench::seconds_of([&] { return concino::bfs(m, source); }); }},
                            {"boost-csr", [&] { return bench::seconds_of([&] { return &boost.bfs(s); }); }}}));
  }
  if (const std::string work = "components." + what; p.wants(work)) {
    const auto ours = [&] {
      if constexpr (std::same_as<Node, concino::vert_id>) return concino::connected_components(m);
      else return concino::connected_components(concino::dual(m));
    };
    expect_equal(work, floors::components<Stride, Filled>(g), ours().labels.values());
    p.print(bench::compare(work, p.rounds,
                           {{"floor", [&] { return bench::seconds_of([&] { return floors::components<Stride, Filled>(g); }); }},
                            {"concino", [&] { return bench::seconds_of(ours); }}}));
  }
  if (const std::string work = "dijkstra." + what; p.wants(work)) {
    const auto d = floors::dijkstra<Stride, Filled>(g, points.data(), s);
    expect_equal(work, d, concino::dijkstra(m, source).values());
    expect_equal(work, d, boost.dijkstra(s));
    p.print(bench::compare(work, p.rounds,
                           {{"floor",
                             [&] {
                               return bench::seconds_of([&] {
                                 const auto c = centres();
                                 return floors::dijkstra<Stride, Filled>(g, c.data(), s);
                               });
                             }},
                            {"concino", [&] { return bench::seconds_of([&] { return concino::dijkstra(m, source); }); }},
                            {"boost-csr", [&] { return bench::seconds_of([&] { return &boost.dijkstra(s); }); }},
                            {"boost-csr-measuring", [&] {
                               return bench::seconds_of([&] {
                                 const auto c = centres();
                                 return &boost.dijkstra_measuring(s, c.data());
                               });
                             }}}));
  }
}

/// The positions of the nodes are the points themselves: nothing is computed.
struct borrowed {
  const double* at;
  const double* data() const { return at; }
};

/// K verts and N neighbours per poly.
template<u32 K, u32 N, class F, class M>
void both_graphs(const bench::program& p, const std::string& name, const F& f, const M& m) {
  const auto primal = [&] { return borrowed{f.points.data()}; };
  const auto dual = [&] { return floors::centroids<K>(f.points.data(), f.p2v.data(), f.num_polys()); };
  searches<0, false>(p, "primal." + name, floors::rows<0>{f.v_off.data(), f.v2v.data(), f.num_verts()}, m, concino::vert_id{0}, primal);
  searches<N, true>(p, "dual." + name, floors::rows<N>{nullptr, f.p2p.data(), f.num_polys()}, m, concino::poly_id{0}, dual);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    {
      const auto a = p.data.tri1m();
      both_graphs<3, 3>(p, "tri1m", bench::built<3>(a), concino::trimesh(a));
    }
    const auto a = p.data.tet1m();
    both_graphs<4, 4>(p, "tet1m", bench::built<floors::tet_shape>(a), concino::tetmesh(a));
  });
}
