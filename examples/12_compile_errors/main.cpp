// What the compiler says when a requirement is missing. A concept is a question; asking is never an error, and the answer may be "no". To hear
// why, call explain_<concept><M>(): it does not compile, and says in one sentence what to write. wrong.cpp beside this file does so for the
// mesh of ring.hpp that is half done; message.txt is the sentence, whichever compiler reads it.
#include "ring.hpp"

#include <concino/graph/bfs.hpp>
#include <concino/mesh/trimesh.hpp>

#include <fmt/core.h>

#include <string>

namespace cn = concino;

// Concepts are conjunctions of requirements, one line each, that can be asked about one by one.
template<class M>
void describe(const char* name) {
  namespace r = cn::requirement;
  fmt::print("{}: adapted {}, vert {}, verts {}, index_of {}, adj_v2v {}; PrimalGraph {}, SurfaceMesh {}\n", name, r::is_adapted<M>, r::has_vert<M>,
             r::has_verts<M>, r::has_vert_index_of<M>, r::has_adj_v2v<M>, cn::PrimalGraph<M>, cn::SurfaceMesh<M>);
}

// An algorithm names its concept in its declaration and asserts nothing inside, so one may ask whether a call would compile ...
template<class M> concept can_search = requires(const M& m, cn::vert_id v) { cn::bfs(m, v); };

// ... and choose by it. A failed call names the concept and the requirement too (with g++ best under -fconcepts-diagnostics-depth=2).
template<class M>
std::string reach(const M& m) {
  if constexpr (can_search<M>) return fmt::format("{} hops to the other side", cn::bfs(m, cn::vert_id{0})[cn::vert_id{m.n / 2}]);
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
