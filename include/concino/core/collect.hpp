// collect_if: the elements of a range for which a condition holds, found in parallel.
#pragma once

#include <concino/core/parallel.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::core {

/// The elements x of a range with keep(x), in the order of the range.
/// Needs:  several threads can iterate over the range, more than once, and call keep.
/// Result: a vector; the same for any number of threads.      Cost: a call of keep for each element; memory for the
///         result, twice.
/// Errors: what keep throws.
template<class R, class Keep>
auto collect_if(const R& range, const Keep& keep) {
  using element = std::remove_cvref_t<decltype(*range.begin())>;
  const range_chunks<R> chunks(range, 4096);
  std::vector<std::vector<element>> parts(chunks.size());
  const auto run = [&](std::size_t c, std::size_t) {
    loop_body<const Keep, element> body = keep;
    std::vector<element> found;  // not beside those of other threads
    chunks.for_each(c, [&](const element& x) {
      if (body(x)) found.push_back(x);
    });
    parts[c] = std::move(found);
  };
  run_chunks(chunks.size(), 1, run, {});
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  std::vector<element> all;
  all.reserve(size);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace concino::core
