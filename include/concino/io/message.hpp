// Messages put together out of line: readers have many, and string sums at each would triple the time it takes to compile them.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace concino::detail {

/// A text or a number on its way into a message.
class message_piece {
  std::string_view text_;
  std::uint64_t number_ = 0;
  bool is_number_ = false;

 public:
  message_piece(const char* text) : text_(text) {}
  message_piece(std::string_view text) : text_(text) {}
  message_piece(const std::string& text) : text_(text) {}
  template<std::unsigned_integral I>
  message_piece(I number) : number_(number), is_number_(true) {}

  void add_to(std::string& s) const {
    if (!is_number_) {
      s.append(text_);
      return;
    }
    char digits[20];
    char* at = digits + 20;
    std::uint64_t rest = number_;
    do *--at = static_cast<char>('0' + rest % 10);
    while (rest /= 10);
    s.append(std::string_view(at, static_cast<std::size_t>(digits + 20 - at)));
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
