// See what the compiler says when a requirement is missing. Testing a concept is never an error: the result is true or false. To learn why it is false, call
// explain_<concept><M>(): it does not compile, and the error says in one sentence what to write. wrong.cpp beside this file does so for the mesh type
// `half_done` of ring.hpp. message.txt holds the sentence; it is the same for all compilers.
#include "ring.hpp"

#include <concino/graph/bfs.hpp>
#include <concino/mesh/trimesh.hpp>

#include <fmt/core.h>

#include <string>

namespace cn = concino;

// A concept is a conjunction of requirements. Each of them can be tested alone.
template<class M>
void describe(const char* name) {
  namespace r = cn::requirement;
  fmt::print("{}: adapted {}, vert {}, verts {}, index_of {}, adj_v2v {}; PrimalGraph {}, SurfaceMesh {}\n", name, r::is_adapted<M>, r::has_vert<M>,
             r::has_verts<M>, r::has_vert_index_of<M>, r::has_adj_v2v<M>, cn::PrimalGraph<M>, cn::SurfaceMesh<M>);
}

// An algorithm states its concept in its declaration and asserts nothing inside, so a program can test whether a call compiles ...
template<class M> concept can_search = requires(const M& m, cn::vert_id v) { cn::bfs(m, v); };

// ... and branch on it. The error of a wrong call names the concept and the requirement too (with g++ best under -fconcepts-diagnostics-depth=2).
template<class M>
std::string reach(const M& m) {
  if constexpr (can_search<M>) return fmt::format("{} hops to the opposite vert", cn::bfs(m, cn::vert_id{0})[cn::vert_id{m.n / 2}]);
  else return "search does not compile";
}

int main() {
  describe<int>("int");
  describe<half_done>("half done");
  describe<whole>("whole");
  describe<cn::trimesh>("trimesh");
  fmt::print("half done: {}\n", reach(half_done{12}));
  fmt::print("whole: {}\n", reach(whole{{12}}));
  cn::explain_primal_graph<whole>();  // nothing is missing: compiles, and does nothing
}
