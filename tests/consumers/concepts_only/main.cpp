#include <concino/concepts/mesh.hpp>

static_assert(!concino::AnyMesh<int>);
