// Construction of messages; see message.hpp.
#pragma once

#include <concino/core/message.hpp>

#include <cstring>

namespace concino::core {

CONCINO_INLINE void message_piece::add_to(std::string& s) const {
  if (kind_ == kind::text) {
    if (number_ > 0) s.append(text_, number_);
  } else if (kind_ == kind::terminated_text) {
    s.append(text_, std::strlen(text_));
  } else if (kind_ == kind::character) {
    s.push_back(static_cast<char>(number_));
  } else {
    char digits[21];
    char* digit = digits + 21;
    std::uint64_t rest = number_;
    do *--digit = static_cast<char>('0' + rest % 10);
    while (rest /= 10);
    if (kind_ == kind::negative) *--digit = '-';
    s.append(digit, static_cast<std::size_t>(digits + 21 - digit));
  }
}

CONCINO_INLINE std::string joined(message pieces) {
  std::string s;
  for (const message_piece& p : pieces) p.add_to(s);
  return s;
}

}  // namespace concino::core
