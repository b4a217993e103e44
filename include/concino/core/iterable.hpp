// iterable: containers, as far as a range-based for loop needs them.
#pragma once

namespace concino::core {

/// A container, a view or a braced list.
template<class R> concept iterable = requires(const R& r) { r.begin(); r.end(); *r.begin(); };

}  // namespace concino::core
