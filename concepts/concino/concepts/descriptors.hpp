// Typed descriptors of the native meshes: vert_id, edge_id, face_id, poly_id. Foreign meshes keep their own
// descriptors.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

/// The id of one element: its index with a type. Regular, ordered, 32 bits, unrelated to integers and to ids of other
/// kinds: `vert_id{3} == poly_id{3}` and `vert_id{2.5}` do not compile. A default id refers to no element; `is_none()`
/// is true for it.
template<class Tag>
class id {
  unsigned raw_ = ~0u;

 public:
  using tag = Tag;

  constexpr id() = default;
  template<std::integral I>
  constexpr explicit id(I index) : raw_(static_cast<unsigned>(index)) {}

  constexpr unsigned raw() const { return raw_; }
  constexpr bool is_none() const { return raw_ == ~0u; }

  friend constexpr bool operator==(id, id) = default;
  friend constexpr auto operator<=>(id, id) = default;

  /// Prints a letter and the index (`v7`) to any stream, without this header including one.
  template<class Stream>
    requires requires(Stream& s) { s << 'v' << 0u; }
  friend Stream& operator<<(Stream& s, id x) {
    s << Tag::letter << x.raw_;
    return s;
  }
};

struct vert_tag { static constexpr char letter = 'v'; };
struct edge_tag { static constexpr char letter = 'e'; };
struct face_tag { static constexpr char letter = 'f'; };
struct poly_tag { static constexpr char letter = 'p'; };

using vert_id = id<vert_tag>;
using edge_id = id<edge_tag>;
using face_id = id<face_tag>;
using poly_id = id<poly_tag>;

static_assert(sizeof(unsigned) == 4 && sizeof(vert_id) == 4 && std::is_trivially_copyable_v<vert_id>);

}  // namespace concino
