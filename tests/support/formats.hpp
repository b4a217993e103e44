// What messages say about a list of formats.
#pragma once

#include <concino/io/format.hpp>

#include <string>

namespace concino::testing {

/// The names of formats, as messages list them.
template<class... F>
std::string names_of(format_list<F...>) {
  std::string all;
  const auto add = [&](std::string_view name) { (all += all.empty() ? "" : ", ") += name; };
  (add(F::name), ...);
  return all;
}

/// The extensions of formats, as messages list them.
template<class... F>
std::string extensions_of(format_list<F...>) {
  std::string all;
  const auto add = [&](const auto& extensions) {
    for (const std::string_view e : extensions) (all += all.empty() ? "" : ", ") += e;
  };
  (add(F::extensions), ...);
  return all;
}

}  // namespace concino::testing
