// The name of a file format, for a choice that is made when a program runs.
#pragma once

#include <concepts>
#include <string_view>

namespace concino {

/// Which format a file is in; by default its extension says. Made of any format: format_id f = file_format::obj; equal where the names are.
class format_id {
  std::string_view name_;

 public:
  constexpr format_id() = default;
  template<class F>
    requires requires { { F::name } -> std::convertible_to<std::string_view>; F::extensions; }
  constexpr format_id(const F&) : name_(F::name) {}

  /// Empty: by the extension.
  constexpr std::string_view name() const { return name_; }

  friend constexpr bool operator==(format_id, format_id) = default;
};

/// One object for each format, of its type: file_format::obj, where <concino/io/obj.hpp> is included, and its siblings.
namespace file_format {

inline constexpr format_id by_extension{};

}  // namespace file_format

}  // namespace concino
