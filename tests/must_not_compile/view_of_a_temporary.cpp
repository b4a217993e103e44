// expect: (use of deleted function|call to deleted function).*dual
#include <concino/concepts/views.hpp>

struct pair_of_polys {};
template<>
struct concino::mesh_traits<pair_of_polys> {
  using poly = poly_id;
  static id_range<poly_id> polys(const pair_of_polys&) { return id_range<poly_id>(2); }
  static unsigned num_polys(const pair_of_polys&) { return 2; }
  static unsigned poly_index_bound(const pair_of_polys&) { return 2; }
  static unsigned index_of(const pair_of_polys&, poly_id p) { return p.raw(); }
  static id_span<poly_id> adj_p2p(const pair_of_polys&, poly_id) { return {}; }
};
static_assert(concino::DualGraph<pair_of_polys>);

auto dangling() { return concino::dual(pair_of_polys()); }
