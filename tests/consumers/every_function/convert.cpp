#include "call.hpp"

#include <concino/convert.hpp>

void call_convert() {
  call("convert", [](auto& m) { cn::convert<std::remove_reference_t<decltype(m)>>(m); }, all);
  call("convert_with_correspondence", [](auto& m) { cn::convert_with_correspondence<std::remove_reference_t<decltype(m)>>(m); }, all);
}
