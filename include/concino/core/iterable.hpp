// Containers, as far as a range-for needs them.
#pragma once

namespace concino::core {

/// A container, a view or braces.
template<class R> concept iterable = requires(const R& r) { r.begin(); r.end(); *r.begin(); };

}  // namespace concino::core
