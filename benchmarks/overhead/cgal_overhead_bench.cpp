// Measures CGAL's Surface_mesh through its adapter, against loops over CGAL's half-edges. Measures also the library's own mesh against what users of CGAL
// call: Boost.Graph on CGAL's graph traits, and connected_components of CGAL's polygon mesh processing.
#include "by_hand.hpp"

#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/mesh.hpp>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

namespace {

using point = CGAL::Simple_cartesian<double>::Point_3;
using mesh = CGAL::Surface_mesh<point>;

struct cgal {
  const mesh& m;
  using vert = mesh::Vertex_index;
  using poly = mesh::Face_index;
  using halfedge = mesh::Halfedge_index;

  std::size_t num_verts() const { return m.num_vertices(); }
  std::size_t num_polys() const { return m.num_faces(); }
  std::size_t num_edges() const { return m.num_edges(); }
  vert vert_at(std::size_t i) const { return vert(static_cast<unsigned>(i)); }
  poly poly_at(std::size_t i) const { return poly(static_cast<unsigned>(i)); }
  template<class Handle>
  std::size_t index(Handle x) const { return x.idx(); }
  concino::vec3 at(vert v) const {
    const point& x = m.point(v);
    return {x.x(), x.y(), x.z()};
  }

  template<class F>
  void leaving(vert v, F&& f) const {
    if (m.is_isolated(v)) return;
    const halfedge first = m.opposite(m.halfedge(v));
    halfedge h = first;
    do {
      f(h);
      h = m.next(m.opposite(h));
    } while (h != first);
  }
  template<class F>
  void along(poly p, F&& f) const {
    const halfedge first = m.halfedge(p);
    halfedge h = first;
    do {
      f(h);
      h = m.next(h);
    } while (h != first);
  }
  template<class F>
  void around(vert v, F&& f) const { leaving(v, [&](halfedge h) { f(m.target(h)); }); }
  template<class F>
  void around(poly p, F&& f) const {
    along(p, [&](halfedge h) {
      if (const halfedge o = m.opposite(h); !m.is_border(o)) f(m.face(o));
    });
  }
  template<class F>
  void corners(poly p, F&& f) const { along(p, [&](halfedge h) { f(m.source(h)); }); }
  template<class F>
  void sides(poly p, F&& f) const { along(p, [&](halfedge h) { f(m.edge(h).idx()); }); }
  template<class F>
  void edges_at(vert v, F&& f) const { leaving(v, [&](halfedge h) { f(m.edge(h).idx(), m.target(h)); }); }
};

mesh from(const bench::surface_arrays& a) {
  mesh m;
  for (const auto& x : a.points) m.add_vertex(point(x.x, x.y, x.z));
  const auto corner = [&](std::size_t i) { return mesh::Vertex_index(a.verts[i].raw()); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(corner(i), corner(i + 1), corner(i + 2));
  return m;
}

/// Hop counts, distances and components by Boost.Graph. `index` maps its vertices to numbers, at(v) returns the position of a vertex.
template<class Graph, class Index>
std::vector<int> boost_bfs(const Graph& g, typename boost::graph_traits<Graph>::vertex_descriptor source, Index index) {
  std::vector<int> hops(num_vertices(g), -1);
  std::vector<boost::default_color_type> colors(hops.size());
  hops[get(index, source)] = 0;
  const auto distance = boost::make_iterator_property_map(hops.begin(), index);
  boost::breadth_first_search(g, source, boost::visitor(boost::make_bfs_visitor(boost::record_distances(distance, boost::on_tree_edge())))
                                             .color_map(boost::make_iterator_property_map(colors.begin(), index)).vertex_index_map(index));
  return hops;
}

template<class Graph, class Index, class At>
std::vector<double> boost_dijkstra(const Graph& g, typename boost::graph_traits<Graph>::vertex_descriptor start, Index index, At at) {
  using arc = typename boost::graph_traits<Graph>::edge_descriptor;
  std::vector<double> d(num_vertices(g));
  const auto length = [&](const arc& e) { return norm(at(source(e, g)) - at(target(e, g))); };
  boost::dijkstra_shortest_paths(g, start, boost::distance_map(boost::make_iterator_property_map(d.begin(), index)).vertex_index_map(index)
                                               .weight_map(boost::make_function_property_map<arc>(length)));
  return d;
}

template<class Graph, class Index>
std::vector<int> boost_components(const Graph& g, Index index) {
  std::vector<int> label(num_vertices(g));
  boost::connected_components(g, boost::make_iterator_property_map(label.begin(), index), boost::vertex_index_map(index));
  return label;
}

std::vector<int> cgal_components(const mesh& m) {
  std::vector<int> label(m.num_faces());
  const auto index = get(CGAL::face_index, m);
  CGAL::Polygon_mesh_processing::connected_components(m, boost::make_iterator_property_map(label.begin(), index));
  return label;
}

/// Measures the library's own mesh and the peer, but prints only the row of the peer: graph_bench prints the others.
template<class Ours, class Peer, class Values>
void against_own_mesh(const bench::program& p, const std::string& work, const std::string& peer, Ours ours, Peer by_peer, Values values) {
  if (!p.wants(work)) return;
  bench::by_hand::expect_equal(work, by_peer(), values(ours()));
  for (const auto& row : bench::compare(work, std::min(p.rounds, 3), {{"concino", [&] { return bench::seconds_of(ours); }},
                                                                      {peer, [&] { return bench::seconds_of(by_peer); }}}))
    if (row.contender == peer) p.print({row});
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    {
      const auto arrays = p.data.tri1m();
      const mesh m = from(arrays);
      const cgal l{m};
      bench::by_hand::compare_all(p, "cgal", l, m);

      const concino::trimesh own(arrays);
      const CGAL::Dual<mesh> dual(m);
      const auto vert_index = get(boost::vertex_index, m);
      const auto face_index = get(CGAL::face_index, m);
      const concino::vert_id v{0};
      const concino::poly_id q{0};
      const auto values = [](const auto& r) {
        if constexpr (requires { r.labels; }) return r.labels.values();
        else return r.values();
      };
      against_own_mesh(p, "bfs.primal.tri1m", "cgal-boost", [&] { return concino::bfs(own, v); }, [&] { return boost_bfs(m, l.vert_at(0), vert_index); }, values);
      against_own_mesh(p, "bfs.dual.tri1m", "cgal-boost", [&] { return concino::bfs(own, q); }, [&] { return boost_bfs(dual, l.poly_at(0), face_index); }, values);
      against_own_mesh(p, "components.primal.tri1m", "cgal-boost", [&] { return concino::connected_components(own); },
                       [&] { return boost_components(m, vert_index); }, values);
      against_own_mesh(p, "components.dual.tri1m", "cgal", [&] { return concino::connected_components(concino::dual(own)); }, [&] { return cgal_components(m); },
                       values);
      against_own_mesh(p, "dijkstra.primal.tri1m", "cgal-boost", [&] { return concino::dijkstra(own, v); },
                       [&] { return boost_dijkstra(m, l.vert_at(0), vert_index, [&](cgal::vert w) { return l.at(w); }); }, values);
      against_own_mesh(p, "dijkstra.dual.tri1m", "cgal-boost", [&] { return concino::dijkstra(own, q); },
                       [&] {
                         const auto c = bench::by_hand::centres(l);
                         return boost_dijkstra(dual, l.poly_at(0), face_index, [&](cgal::poly w) { return c[l.index(w)]; });
                       },
                       values);
    }
    const mesh small = from(p.data.bunny());
    bench::by_hand::compare_harmonic(p, "cgal", cgal{small}, small);
  });
}
