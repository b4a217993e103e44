// collect_if: the elements of a range for which a condition holds, found in parallel.
#pragma once

#include <concino/core/parallel.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::core {

/// The elements x of a range with keep(x), in the order of the range.
/// Needs:  several threads can iterate over the range and call keep.
/// Result: a vector; the same for any number of threads.      Cost: a call of keep for each element; memory for the result, twice.
/// Errors: what keep throws.
template<class R, class Keep>
auto collect_if(const R& range, const Keep& keep) {
  using element = std::remove_cvref_t<decltype(*range.begin())>;
  using body_type = loop_body<const Keep, element>;
  std::vector<std::unique_ptr<std::vector<element>>> parts;
  if constexpr (is_divisible<R>) {
    constexpr std::size_t chunk = 8192;
    constexpr std::size_t few = 64;  // in a loop without calls, compilers keep in registers what each test reads
    const std::size_t n = range.index_bound();
    std::size_t next = 0;
    run_parts([&](function_ref<void()> release) {
      const std::size_t first = next, last = n - first < chunk ? n : first + chunk;
      next = last;
      parts.push_back(std::make_unique<std::vector<element>>());
      std::vector<element>& found = *parts.back();
      if (release) release();
      body_type body = keep;
      element some[few];
      for (std::size_t at = first; at < last; at += few) {
        std::size_t size = 0;
        for (const element& x : range.part(at, last - at < few ? last : at + few))
          if (body(x)) some[size++] = x;
        if (size > 0) found.insert(found.end(), some, some + size);
      }
      return last < n;
    });
  } else {
    constexpr std::size_t chunk = 2048;
    const auto end = range.end();
    auto next = range.begin();
    run_parts([&](function_ref<void()> release) {
      auto it = next;
      parts.push_back(std::make_unique<std::vector<element>>());
      std::vector<element>& found = *parts.back();
      if (release) {  // the next part begins where this one will end
        for (std::size_t n = 0; n < chunk && next != end; ++n) ++next;
        release();
      }
      body_type body = keep;
      for (std::size_t n = 0; n < chunk && it != end; ++n, ++it)
        if (const element x = *it; body(x)) found.push_back(x);
      if (!release) next = it;
      return it != end;
    });
  }
  std::size_t size = 0;
  for (const auto& part : parts) size += part->size();
  std::vector<element> all;
  all.reserve(size);
  for (const auto& part : parts) all.insert(all.end(), part->begin(), part->end());
  return all;
}

}  // namespace concino::core
