// expect: (use of deleted function|call to deleted function).*graph_view
#include <concino/adapters/boost_graph.hpp>

using linked = boost::adjacency_list<boost::vecS, boost::listS, boost::undirectedS, boost::property<boost::vertex_index_t, int>>;

auto fine(const linked& g) { return concino::graph_view(g); }
auto dangling() { return concino::graph_view(linked()); }
