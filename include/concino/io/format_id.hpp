// The name of a file format, to choose a format at run time.
#pragma once

#include <concepts>
#include <string_view>

namespace concino {

/// The format of a file; by default the extension determines it. Any format converts to it: format_id f =
/// file_format::obj. Two are equal if their names are.
class format_id {
  std::string_view name_;

 public:
  constexpr format_id() = default;
  template<class F>
    requires requires { { F::name } -> std::convertible_to<std::string_view>; F::extensions; }
  constexpr format_id(const F&) : name_(F::name) {}

  /// Empty: the extension determines the format.
  constexpr std::string_view name() const { return name_; }

  friend constexpr bool operator==(format_id, format_id) = default;
};

/// An object of the type of each format: <concino/io/obj.hpp> defines file_format::obj, and its siblings the others.
namespace file_format {

inline constexpr format_id by_extension{};

}  // namespace file_format

}  // namespace concino
