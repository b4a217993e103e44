// The formats of a list that are read, and what messages say about a list.
#pragma once

#include <concino/io/format.hpp>

#include <string>
#include <vector>

namespace concino::testing {

/// The formats that can be read: others are written only.
template<class... F>
std::vector<format_id> formats_with_reader(format_list<F...>) {
  std::vector<format_id> all;
  ((requirement::is_write_only<F> ? void() : all.push_back(F{})), ...);
  return all;
}

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

/// What the signatures of formats look for, as messages list it.
template<class... F>
std::string signatures_of(format_list<F...>) {
  std::string all;
  const auto add = [&]<class G>(G) {
    if constexpr (requires { G::signature; }) (all += all.empty() ? "" : ", ") += G::signature;
  };
  (add(F{}), ...);
  return all;
}

}  // namespace concino::testing
