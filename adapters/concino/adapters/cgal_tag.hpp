// The tag `cgal`, for functions that CGAL is to do, as in triangulate(outlines, cgal).
// Needs: nothing; the headers with these functions need CGAL.
#pragma once

namespace concino {

struct cgal_t {};
inline constexpr cgal_t cgal{};

}  // namespace concino
