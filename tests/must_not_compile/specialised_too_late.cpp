// expect: specialization of .concino::mesh_traits<foreign>. after instantiation
#include <concino/concepts/mesh.hpp>

struct foreign {};
bool asked = concino::PrimalGraph<foreign>;

template<>
struct concino::mesh_traits<foreign> {};
