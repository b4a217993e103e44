// expect: (after instantiation|is_adapted)
// An adapter specialises mesh_traits for many types. If one of them was used before, g++ rejects the adapter; with clang++ the concept stays false.
#include <concino/concepts/mesh.hpp>

struct foreign {};
bool asked = concino::PrimalGraph<foreign>;

template<std::derived_from<foreign> M>
struct concino::mesh_traits<M> {
  using vert = vert_id;
  static id_range<vert_id> verts(const foreign&);
  static unsigned num_verts(const foreign&);
  static unsigned vert_index_bound(const foreign&);
  static unsigned index_of(const foreign&, vert_id);
  static id_span<vert_id> adj_v2v(const foreign&, vert_id);
};

static_assert(concino::PrimalGraph<foreign>);
