// expect: has no member named .size.|no member named .size. in
// An algorithm that calls size() of a range uses more than PrimalGraph requires.
#include <concino/concepts/archetypes.hpp>

struct ring { unsigned n; };
template<>
struct concino::mesh_traits<ring> {
  using vert = vert_id;
  static id_range<vert_id> verts(const ring& r) { return id_range<vert_id>(r.n); }
  static unsigned num_verts(const ring& r) { return r.n; }
  static unsigned vert_index_bound(const ring& r) { return r.n; }
  static unsigned index_of(const ring&, vert_id v) { return v.raw(); }
  static id_span<vert_id> adj_v2v(const ring&, vert_id) { return {}; }
};

template<concino::PrimalGraph M>
std::size_t degrees(const M& m) {
  std::size_t n = 0;
  for (auto v : concino::verts(m)) n += concino::adj_v2v(m, v).size();
  return n;
}

std::size_t fine(const ring& r) { return degrees(r); }
std::size_t refused(const ring& r) { return degrees(concino::only_primal_graph(r)); }
