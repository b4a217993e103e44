// expect: (no match for .operator==.|invalid operands to binary expression).*id<(concino::)?vert_tag>
#include <concino/concepts/descriptors.hpp>

bool same(concino::vert_id v, concino::poly_id p) { return v == p; }
