// Messages put together out of line: readers have many, and string sums at each would triple the time it takes to compile them.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

namespace concino::detail {

/// A text or a number on its way into a message.
class message_piece {
  static constexpr std::uint64_t ends_with_zero = ~std::uint64_t{0};
  const char* text_;      // null: a number
  std::uint64_t number_;  // or the length of the text

 public:
  message_piece(const char* text) : text_(text), number_(ends_with_zero) {}
  message_piece(std::string_view text) : text_(text.data() ? text.data() : ""), number_(text.size()) {}
  message_piece(const std::string& text) : text_(text.data()), number_(text.size()) {}
  template<std::unsigned_integral I>
  message_piece(I number) : text_(nullptr), number_(number) {}

  void add_to(std::string& s) const {
    char digits[20];
    const char* at = text_;
    std::size_t size = number_;
    if (!text_) {
      std::uint64_t rest = number_;
      char* digit = digits + 20;
      do *--digit = static_cast<char>('0' + rest % 10);
      while (rest /= 10);
      at = digit;
      size = static_cast<std::size_t>(digits + 20 - digit);
    } else if (number_ == ends_with_zero) {
      size = std::strlen(text_);
    }
    s.append(at, size);
  }
};

using message = std::initializer_list<message_piece>;

[[gnu::noinline, gnu::cold]] inline std::string joined(message pieces) {
  std::string s;
  for (const message_piece& p : pieces) p.add_to(s);
  return s;
}

template<class Error>
[[noreturn, gnu::noinline, gnu::cold]] void throw_joined(message pieces) {
  throw Error(joined(pieces));
}

}  // namespace concino::detail
