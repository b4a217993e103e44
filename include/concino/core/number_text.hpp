// Numbers as text for error messages, independent of any locale.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>

#include <concepts>
#include <string>

namespace concino::core {

/// The shortest text that reads back as the same number.
std::string number_text(double x);
std::string number_text(float x);
template<std::integral I>
std::string number_text(I x) {
  return joined({x});
}

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/number_text.ipp>
#endif
