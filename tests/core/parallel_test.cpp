#include <concino/core/parallel.hpp>

#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <forward_list>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using concino::parallel_for;
using concino::parallel_for_each;
using concino::testing::with_num_threads;

namespace {

constexpr int numbers_of_threads[] = {1, 2, 3, 16};

}  // namespace

TEST_CASE("the number of threads is what the environment says, else as many as there are cores") {
  const auto said = [](const char* text) {
    const with_num_threads before(1);  // puts the variable back
    ::setenv("CONCINO_NUM_THREADS", text, 1);
    return concino::core::num_threads();
  };
  CHECK(said("1") == 1);
  CHECK(said("7") == 7);
  CHECK(said("100000000") == 1024);
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (const char* const text : {"", "0", "-3", "many"}) CHECK(said(text) == cores);
}

TEST_CASE("loops do run on several threads, and on one where that is wanted") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    std::atomic<int> waiting{0};
    std::vector<std::thread::id> who(static_cast<std::size_t>(n));
    parallel_for(who.size(), [&](std::size_t i) {  // each call waits for all others, so that each needs a thread of its own
      ++waiting;
      while (waiting < n) std::this_thread::yield();
      who[i] = std::this_thread::get_id();
    }, 1);
    std::sort(who.begin(), who.end());
    CHECK(std::unique(who.begin(), who.end()) == who.end());
  }
}

TEST_CASE("parallel_for calls every index once, for any chunk and number of threads") {
  for (const int threads : numbers_of_threads) {
    const with_num_threads now(threads);
    for (const std::size_t n : {0u, 1u, 7u, 1000u})
      for (const std::size_t chunk : {0u, 1u, 3u, 5000u}) {
        std::vector<int> calls(n, 0);
        parallel_for(n, [&](std::size_t i) { ++calls[i]; }, chunk);
        CHECK(calls == std::vector<int>(n, 1));
      }
  }
}

TEST_CASE("parallel_for carries out the exception of the lowest index") {
  for (int repeat = 0; repeat < 20; ++repeat) {
    const with_num_threads now(1 + repeat % 4);
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
  for (const int threads : numbers_of_threads) {
    const with_num_threads now(threads);
    std::vector<int> calls(100000, 0);
    std::atomic<bool> over{false};
    double last = 0;
    const auto caller = std::this_thread::get_id();
    const auto work = [&](std::size_t i) {
      if (i > calls.size() / 2 && std::this_thread::get_id() != caller) {  // else the others may finish before the calling thread goes on
        while (!over) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::microseconds(1));
      }
      ++calls[i];
    };
    parallel_for(calls.size(), work, 1, [&](double fraction) {
      last = fraction;
      over = fraction > 0.1;
      return over.load();
    });
    std::size_t total = 0;
    for (const int c : calls) total += static_cast<std::size_t>(c);
    CHECK(total >= 10000);
    CHECK(total < calls.size());
    CHECK(last > 0.1);
    CHECK(last < 1);
  }
}

TEST_CASE("parallel_for_each calls every element of a range once, and carries out the exception of the first") {
  for (const int threads : numbers_of_threads)
    for (const int n : {0, 1, 7, 3000}) {
      const with_num_threads now(threads);
      std::forward_list<int> range;
      for (int i = n; i-- > 0;) range.push_front(i);
      for (const std::size_t chunk : {0u, 1u, 100u, 5000u}) {
        std::vector<int> calls(static_cast<std::size_t>(n), 0);
        parallel_for_each(range, [&](int i) { ++calls[static_cast<std::size_t>(i)]; }, chunk);
        CHECK(calls == std::vector<int>(static_cast<std::size_t>(n), 1));
      }
      std::string what;
      try {
        parallel_for_each(range, [](int i) { if (i % 100 == 37) throw std::runtime_error(std::to_string(i)); }, 1);
      } catch (const std::runtime_error& e) {
        what = e.what();
      }
      CHECK(what == (n > 37 ? "37" : ""));
    }
}
