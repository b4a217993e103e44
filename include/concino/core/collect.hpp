// collect_if: the elements of a range for which a condition holds, found in parallel.
#pragma once

#include <concino/core/parallel.hpp>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::core {

/// Adds the elements x of range.part(first, last) with keep(x).
template<class R, class Keep, class T>
[[gnu::always_inline]] inline void collect_part(const R& range, std::size_t first, std::size_t last, const Keep& keep, std::vector<T>& found) {
  constexpr std::size_t few = 64;  // in a loop without calls, compilers keep in registers what each test reads
  T some[few];
  for (std::size_t at = first; at < last; at += few) {
    std::size_t size = 0;
    for (const T& x : range.part(at, last - at < few ? last : at + few))
      if (keep(x)) some[size++] = x;
    if (size > 0) found.insert(found.end(), some, some + size);
  }
}

/// The same for tests that read much memory, of at most MaxSize elements: first all tests, then what is kept. Between tests there is no branch on what they
/// read; where processors predict such a branch wrongly, they read the memory of later tests again.
template<std::size_t MaxSize, class R, class Keep, class T>
[[gnu::always_inline]] inline void collect_after_tests(const R& range, std::size_t first, std::size_t last, const Keep& keep, std::vector<T>& found) {
  constexpr std::size_t few = 64;
  static_assert(sizeof(bool) == 1 && MaxSize % few == 0);
  bool is_kept[MaxSize];
  const auto some = [&](std::size_t at) { return range.part(at, last - at < few ? last : at + few); };
  for (std::size_t at = first; at < last; at += few) {
    bool *to = is_kept + (at - first), *const end = to + few;
    for (const T& x : some(at)) *to++ = keep(x);
    std::fill(to, end, false);
  }
  for (std::size_t at = first; at < last; at += few) {
    const bool* next = is_kept + (at - first);
    if (!std::memchr(next, 1, few)) continue;
    for (const T& x : some(at))
      if (*next++) found.push_back(x);
  }
}

/// The elements x of a range with keep(x), in the order of the range. TestsFirst: in parts, as collect_after_tests() does it.
/// Needs:  several threads can iterate over the range and call keep.
/// Result: a vector; the same for any number of threads.      Cost: a call of keep for each element; memory for the result, twice.
/// Errors: what keep throws.
template<bool TestsFirst = false, class R, class Keep>
auto collect_if(const R& range, const Keep& keep) {
  using element = std::remove_cvref_t<decltype(*range.begin())>;
  using body_type = loop_body<const Keep, element>;
  std::vector<std::unique_ptr<std::vector<element>>> parts;
  if constexpr (is_divisible<R>) {
    constexpr std::size_t chunk = 16384;
    const std::size_t n = range.index_bound();
    std::size_t next = 0;
    run_parts([&](function_ref<void()> release) {
      const std::size_t first = next, left = n - first, most = left > 4 * chunk ? chunk : chunk / 4;  // small at the end, so that all threads end together
      const std::size_t last = left < most ? n : first + most;
      next = last;
      parts.push_back(std::make_unique<std::vector<element>>());
      std::vector<element>& found = *parts.back();
      if (release) release();
      body_type body = keep;
      if constexpr (TestsFirst) collect_after_tests<chunk>(range, first, last, body, found);
      else collect_part(range, first, last, body, found);
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
