#include <concino/parallel.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using concino::parallel_for;

TEST_CASE("parallel_for calls every index once, for any chunk") {
  for (const std::size_t n : {0u, 1u, 7u, 1000u})
    for (const std::size_t chunk : {0u, 1u, 3u, 5000u}) {
      std::vector<int> calls(n, 0);
      parallel_for(n, [&](std::size_t i) { ++calls[i]; }, chunk);
      CHECK(calls == std::vector<int>(n, 1));
    }
}

TEST_CASE("parallel_for carries out the exception of the lowest index") {
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::string what;
    try {
      parallel_for(1000, [](std::size_t i) { if (i % 100 == 37) throw std::runtime_error(std::to_string(i)); }, 1);
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    CHECK(what == "37");
  }
}

TEST_CASE("parallel_for stops when asked, and says how far it is") {
  std::vector<int> calls(100000, 0);
  std::atomic<bool> asked{false};
  double last = 0;
  const auto work = [&](std::size_t i) {
    while (i > calls.size() / 2 && !asked) std::this_thread::yield();  // else another thread may finish before the calling one begins
    ++calls[i];
  };
  parallel_for(calls.size(), work, 1, [&](double fraction) {
    asked = true;
    last = fraction;
    return fraction > 0.1;
  });
  std::size_t total = 0;
  for (const int c : calls) total += static_cast<std::size_t>(c);
  CHECK(total >= 10000);
  CHECK(total < calls.size());
  CHECK(last > 0.1);
  CHECK(last < 1);
}
