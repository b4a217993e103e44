// Graphs of Boost pass the conformance kit, as they are and through graph_view.
#include <concino/adapters/boost_graph.hpp>
#include <concino/adapters/doctest.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/grid_graph.hpp>

#include <utility>
#include <vector>

namespace cn = concino;

namespace {

const std::vector<std::pair<int, int>> house = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 3}, {6, 7}};  // vert 5 has no edge

}  // namespace

TEST_CASE("Boost: an undirected adjacency list conforms") {
  cn::check_conformance([] { return boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>(house.begin(), house.end(), 8); });
}

TEST_CASE("Boost: a compressed graph with both arcs of every edge conforms") {
  std::vector<std::pair<int, int>> arcs = house;
  for (const auto& [a, b] : house) arcs.emplace_back(b, a);
  cn::check_conformance([&] { return boost::compressed_sparse_row_graph<>(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), 8); });
}

TEST_CASE("Boost: a grid conforms through graph_view") {
  const boost::array<std::size_t, 2> size = {{4, 3}};
  const boost::grid_graph<2> grid(size);
  cn::check_conformance([&] { return cn::graph_view(grid); });
}
