// iterable: the concept of types that a range-based for loop accepts.
#pragma once

namespace concino::core {

/// A container, a view or a braced list.
template<class R> concept iterable = requires(const R& r) { r.begin(); r.end(); *r.begin(); };

}  // namespace concino::core
