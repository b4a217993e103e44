#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/parallel.hpp>

#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <forward_list>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CONCINO_TEST_WITH_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CONCINO_TEST_WITH_SANITIZER 1
#endif
#endif
#ifndef CONCINO_TEST_WITH_SANITIZER
#define CONCINO_TEST_WITH_SANITIZER 0
#endif

using concino::parallel_for;
using concino::parallel_for_each;
using concino::testing::with_num_threads;

namespace {

constexpr int numbers_of_threads[] = {1, 2, 3, 16};

}  // namespace

TEST_CASE("parallel: the number of threads is that of the environment, else of the cores") {
  const auto said = [](const char* text) {
    const with_num_threads before(1);  // restores the environment variable
    ::setenv("CONCINO_NUM_THREADS", text, 1);
    return concino::core::num_threads();
  };
  CHECK(said("1") == 1);
  CHECK(said("7") == 7);
  CHECK(said("100000000") == 1024);
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (const char* const text : {"", "0", "-3", "many"}) {
    CHECK(said(text) >= 1);
    CHECK(said(text) <= cores);
  }
}

#ifdef __linux__
TEST_CASE("parallel: cores on which the process may not run do not count") {
  std::size_t found = 0;
  std::thread([&] {  // a separate thread, because the others keep all cores
    ::cpu_set_t all, one;
    REQUIRE(::sched_getaffinity(0, sizeof all, &all) == 0);
    CPU_ZERO(&one);
    for (int c = 0; c < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++c)
      if (CPU_ISSET(c, &all)) CPU_SET(c, &one);
    REQUIRE(::sched_setaffinity(0, sizeof one, &one) == 0);
    const with_num_threads before(1);  // restores the environment variable
    ::unsetenv("CONCINO_NUM_THREADS");
    found = concino::core::num_threads();
  }).join();
  CHECK(found == 1);
}
#endif

TEST_CASE("parallel: for_each_chunk runs as many chunks at a time as there are threads") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    std::atomic<int> waiting{0};
    std::vector<std::thread::id> who(static_cast<std::size_t>(n));
    const auto run = [&](std::size_t c) {  // each call waits for all others, so each needs its own thread
      ++waiting;
      while (waiting < n) std::this_thread::yield();
      who[c] = std::this_thread::get_id();
    };
    concino::core::for_each_chunk(who.size(), run);
    std::sort(who.begin(), who.end());
    CHECK(std::unique(who.begin(), who.end()) == who.end());
  }
}

TEST_CASE("parallel: long loops run on several threads, or on one by option") {
  const std::vector<int> range(20000);
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    std::atomic<int> others{0};
    const auto caller = std::this_thread::get_id();
    const auto work = [&] {  // on the calling thread each call takes long until the others have started; those wait for one another
      thread_local const void* known = nullptr;
      if (std::this_thread::get_id() == caller) {
        if (others < n - 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return;
      }
      if (std::exchange(known, &others) != &others) ++others;
      while (others < n - 1) std::this_thread::yield();
    };
    parallel_for(range.size(), [&](std::size_t) { work(); }, 1);
    CHECK(others == n - 1);
    others = 0;
    parallel_for_each(range, [&](int) { work(); }, 1);
    CHECK(others == n - 1);
  }
}

TEST_CASE("parallel: short loops run on the calling thread") {
  const with_num_threads now(16);
  std::size_t fewest = 20;  // calls on other threads; none unless the system delays the calling thread
  for (int repeat = 0; repeat < 100 && fewest > 0; ++repeat) {
    const auto caller = std::this_thread::get_id();
    std::atomic<std::size_t> elsewhere{0};
    parallel_for(20, [&](std::size_t) { elsewhere += std::this_thread::get_id() != caller; }, 1);
    fewest = std::min(fewest, elsewhere.load());
  }
  CHECK(fewest == 0);
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

TEST_CASE("parallel_for throws the exception of the lowest index") {
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

TEST_CASE("parallel_for reports progress and can be cancelled") {
  for (const int threads : numbers_of_threads) {
    const with_num_threads now(threads);
    std::vector<int> calls(100000, 0);
    std::atomic<bool> over{false};
    double last = 0;
    const auto caller = std::this_thread::get_id();
    const auto work = [&](std::size_t i) {
      if (i > calls.size() / 2 && std::this_thread::get_id() != caller) {  // otherwise the others may finish before the calling thread continues
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

TEST_CASE("parallel_for_each visits every element once, and throws the exception of the first") {
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

TEST_CASE("parallel_for_each visits the parts of a range, without deleted elements") {
  std::vector<unsigned char> dead(5000);
  for (std::size_t i = 0; i < dead.size(); ++i) dead[i] = i % 3 == 0 || i / 1000 == 2;
  const concino::id_range<concino::vert_id> range(dead.size(), dead.data());
  for (const int threads : numbers_of_threads) {
    const with_num_threads now(threads);
    for (const std::size_t chunk : {0u, 1u, 100u, 6000u}) {
      std::vector<int> calls(dead.size(), 0);
      parallel_for_each(range, [&](concino::vert_id v) { ++calls[v.raw()]; }, chunk);
      for (std::size_t i = 0; i < dead.size(); ++i) CHECK(calls[i] == !dead[i]);
    }
    parallel_for_each(concino::id_range<concino::vert_id>(), [](concino::vert_id) { FAIL("there is none"); });
  }
}

TEST_CASE("parallel: loops call the function itself, not a copy") {
  const with_num_threads now(1);
  int last = 0;
  auto count = [&last, n = 0](auto) mutable { last = ++n; };
  parallel_for(10, count, 3);
  CHECK(last == 10);
  parallel_for_each(std::forward_list<int>(10), count, 3);
  CHECK(last == 20);
  parallel_for_each(concino::id_range<concino::vert_id>(10), count, 3);
  CHECK(last == 30);
}

TEST_CASE("parallel: loops in loops and many short loops are those of one thread") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    std::vector<int> calls(64 * 64, 0);
    concino::core::for_each_chunk(64, [&](std::size_t i) {
      const auto outer = std::this_thread::get_id();
      parallel_for(64, [&](std::size_t k) { calls[64 * i + k] += n == 1 || std::this_thread::get_id() == outer; }, 1);
    });
    CHECK(calls == std::vector<int>(calls.size(), 1));
    std::size_t sum = 0;
    for (std::size_t loop = 0; loop < 200; ++loop) {
      std::size_t parts[7] = {};
      concino::core::for_each_chunk(7, [&](std::size_t i) { parts[i] = i + loop; });
      for (const std::size_t x : parts) sum += x;
    }
    CHECK(sum == 7 * (199 * 200 / 2) + 200 * 21);
  }
}

TEST_CASE("parallel: the calling thread waits for chunks that take long") {
  const with_num_threads now(2);
  const auto caller = std::this_thread::get_id();
  bool is_done = false;  // not atomic: the end of the loop orders both threads
  std::atomic<bool> begun{false};
  concino::core::for_each_chunk(2, [&](std::size_t) {
    if (std::this_thread::get_id() == caller) {
      while (!begun) std::this_thread::yield();
      return;
    }
    begun = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    is_done = true;
  });
  CHECK(is_done);
}

TEST_CASE("parallel: what stop throws reaches the caller, and the next loop is complete") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::atomic<std::size_t> calls{0};
      std::atomic<bool> has_stopped{false};
      const auto wait = [&, caller = std::this_thread::get_id()](std::size_t) {
        ++calls;
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        while (std::this_thread::get_id() != caller && !has_stopped) std::this_thread::yield();  // however slow the caller is
      };
      const auto stop = [&](double) -> bool {
        if (calls < 10) return false;
        has_stopped = true;
        throw std::domain_error("stop");
      };
      CHECK_THROWS_AS(parallel_for(1000, wait, 1, stop), std::domain_error);
      CHECK(calls >= 10);
      CHECK(calls < 1000);
      calls = 0;
      concino::core::for_each_chunk(20, [&](std::size_t) { ++calls; });
      CHECK(calls == 20);
    }
  }
}

TEST_CASE("parallel: run_twice_at_once runs on two threads at the same time, whatever their maximum number, and throws what the first call throws") {
  const with_num_threads one(1);
  std::thread::id ids[2];
  std::atomic<int> waiting{2};
  concino::core::run_twice_at_once([&](std::size_t i) {
    ids[i] = std::this_thread::get_id();
    for (--waiting; waiting > 0;) std::this_thread::yield();
  });
  CHECK(ids[0] == std::this_thread::get_id());
  CHECK(ids[1] != ids[0]);
  int calls[2] = {};
  CHECK_THROWS_WITH_AS(concino::core::run_twice_at_once([&](std::size_t i) {
    ++calls[i];
    throw std::runtime_error(i == 0 ? "zero" : "one");
  }),
                       "zero", std::runtime_error);
  CHECK_THROWS_AS(concino::core::run_twice_at_once([&](std::size_t i) {
    ++calls[i];
    if (i == 1) throw std::runtime_error("one");
  }),
                  std::runtime_error);
  CHECK(calls[0] == 2);
  CHECK(calls[1] == 2);
}

#if defined(__linux__) && !CONCINO_TEST_WITH_SANITIZER
TEST_CASE("parallel: where the system starts no thread, the calling one does all") {
  const with_num_threads now(3);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  ::rlimit before;
  REQUIRE(::getrlimit(RLIMIT_AS, &before) == 0);
  const ::rlimit small{pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + (std::size_t{4} << 20), before.rlim_max};
  std::atomic<bool> is_over{false};
  std::vector<std::thread> others;  // take the memory that ended threads have left
  others.reserve(100);
  std::size_t calls = 0, elsewhere = 0;
  REQUIRE(::setrlimit(RLIMIT_AS, &small) == 0);
  try {
    while (others.size() < 100) others.emplace_back([&] { while (!is_over) std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
  } catch (const std::system_error&) {
  }
  const auto caller = std::this_thread::get_id();
  parallel_for(8, [&](std::size_t) {
    elsewhere += std::this_thread::get_id() != caller;
    std::this_thread::sleep_for(std::chrono::microseconds(300));
    ++calls;
  }, 1);
  ::setrlimit(RLIMIT_AS, &before);
  is_over = true;
  for (std::thread& t : others) t.join();
  CHECK(others.size() < 100);
  CHECK(calls == 8);
  CHECK(elsewhere == 0);
}
#endif
