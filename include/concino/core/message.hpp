// Joins texts and numbers into a message, by functions that are not inline: string concatenation at each message would
// triple the compile time of readers.
#pragma once

#include <concino/core/compiled.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace concino::core {

/// A part of a message: a text, a character or an integer.
class message_piece {
  enum class kind : unsigned char { text, terminated_text, character, number, negative };
  const char* text_ = nullptr;
  std::uint64_t number_ = 0;  // or the length of the text, or the character
  kind kind_;

 public:
  message_piece(const char* text) : text_(text), kind_(kind::terminated_text) {}
  message_piece(std::string_view text) : text_(text.data()), number_(text.size()), kind_(kind::text) {}
  message_piece(const std::string& text) : text_(text.data()), number_(text.size()), kind_(kind::text) {}
  message_piece(char c) : number_(static_cast<unsigned char>(c)), kind_(kind::character) {}
  message_piece(bool) = delete;
  template<std::integral I>
  message_piece(I number)
      : number_(number < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(number)
                           : static_cast<std::uint64_t>(number)),
        kind_(number < 0 ? kind::negative : kind::number) {}

  void add_to(std::string& s) const;
};

using message = std::initializer_list<message_piece>;

std::string joined(message pieces);

template<class Error>
[[noreturn, gnu::noinline, gnu::cold]] void throw_joined(message pieces) {
  throw Error(joined(pieces));
}

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/message.ipp>
#endif
