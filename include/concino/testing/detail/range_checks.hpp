// Checks that ranges of elements do not change while others are computed, and can be iterated repeatedly, also by
// several threads.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/parallel.hpp>
#include <concino/testing/detail/adjacencies.hpp>
#include <concino/validate/broken_law.hpp>

#include <cstddef>
#include <cstdint>
#include <new>

namespace concino::testing::detail {

/// KIT2: ranges are independent of one another, repeatable, and have independent iterators.
template<class M>
void check_ranges(const M& m, concino::detail::law_log& log) {
  constexpr std::size_t enough = 500;  // elements of each kind
  for_each_adjacency(m, [&](const char* verb, char letter, const auto& all, const auto& adjacent) {
    std::size_t count = 0;
    const auto elements = indices(m, all(m));
    if (indices(m, all(m)) != elements)
      log.add("KIT2",
              concino::core::joined({"the range of arguments of ", verb, " has other elements when iterated again"}),
              "");
    bool first = true;
    decltype(auto) walk = all(m);
    const auto end = walk.end();
    auto before = walk.begin();
    for (auto it = walk.begin(); it != end && count < enough; ++it, ++count) {
      if (!first) {
        const auto a = *before, b = *it;
        const std::string what = concino::core::joined({verb, "(", name(letter, index_of(m, a)), ")"});
        decltype(auto) ring = adjacent(m, a);
        const auto once = indices(m, ring);
        decltype(auto) other = adjacent(m, b);
        const auto there = indices(m, other);
        if (indices(m, ring) != once)
          log.add("KIT2", concino::core::joined({what, " changes when ", verb, "(", name(letter, index_of(m, b)),
                                          ") is called; a range must own its values or refer to the mesh"}),
                  concino::core::joined({name(letter, index_of(m, a)), " ", name(letter, index_of(m, b))}));
        else if (indices(m, adjacent(m, a)) != once)
          log.add("KIT2", concino::core::joined({what, " differs when called again"}), name(letter, index_of(m, a)));
        if (!once.empty()) {
          const auto stays = ring.begin();
          auto goes = ring.begin();
          ++goes;
          if (index_of(m, *stays) != once[0])
            log.add("KIT2", concino::core::joined({"incrementing one iterator of ", what, " moves another"}),
                    name(letter, index_of(m, a)));
        }
        ++before;
      }
      first = false;
    }
  });
}

/// KIT3: two threads that read a const mesh at the same time get the same results as one.
template<class M>
void check_threads(const M& m, concino::detail::law_log& log) {
  const std::uint64_t expected = digest(m);
  bool wrong[2] = {};
  concino::core::run_twice_at_once([&](std::size_t thread) {
    for (int round = 0; round < 20; ++round) {
      try {
        if (digest(m) != expected) wrong[thread] = true;
      } catch (const std::bad_alloc&) {
        throw;
      } catch (...) {
        wrong[thread] = true;
      }
    }
  });
  if (wrong[0] || wrong[1])
    log.add("KIT3",
            "two threads that read the const mesh at the same time get other results than one; reading must not write",
            "");
}

}  // namespace concino::testing::detail
