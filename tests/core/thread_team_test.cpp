#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/collect.hpp>
#include <concino/core/parallel.hpp>

#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <pthread.h>
#endif

using concino::parallel_for;
using concino::core::thread_team;
using concino::testing::with_num_threads;

namespace {

using id = std::thread::id;

constexpr int numbers_of_threads[] = {1, 2, 3, 16};

void sleep(int microseconds) { std::this_thread::sleep_for(std::chrono::microseconds(microseconds)); }

/// The threads of two parts that wait for one another, so that each has a thread of its own.
std::vector<id> threads_of_two_parts() {
  std::atomic<int> waiting{0};
  std::vector<id> who(2);
  concino::core::for_each_chunk(2, [&](std::size_t c) {
    who[c] = std::this_thread::get_id();
    for (++waiting; waiting < 2;) std::this_thread::yield();
  });
  return who;
}
id helper_of_loop() {
  const std::vector<id> who = threads_of_two_parts();
  return who[0] == std::this_thread::get_id() ? who[1] : who[0];
}

/// Whether another thread takes a part of a short loop. The calling thread waits for it, but not for ever.
bool is_shared_at_once() {
  std::atomic<bool> is_shared{false};
  const id caller = std::this_thread::get_id();
  const auto run = [&](std::size_t, std::size_t) {
    if (std::this_thread::get_id() != caller) is_shared = true;
    else for (int n = 0; !is_shared && n < 1000; ++n) sleep(100);
  };
  concino::core::run_chunks(2, 1, run, nullptr);
  return is_shared;
}

}  // namespace

TEST_CASE("thread_team: helps with all loops, whether its helpers are awake or asleep between them") {
  const with_num_threads now(2);
  const thread_team team(true);
  CHECK(is_shared_at_once());
  const id helper = helper_of_loop();
  for (const int pause : {0, 20, 150, 200, 250, 5000}) {
    sleep(pause);
    CHECK(helper_of_loop() == helper);
    sleep(pause);
    CHECK(is_shared_at_once());
  }
}

TEST_CASE("thread_team: after finish() loops start helpers of their own, and another team can be made") {
  const with_num_threads now(2);
  thread_team team(true);
  const id helper = helper_of_loop();
  for (int i = 0; i < 2; ++i) {
    team.finish();
    CHECK_FALSE(helper_of_loop() == helper);
    const thread_team second(true);
    const id other = helper_of_loop();
    CHECK_FALSE(other == helper);
    CHECK(is_shared_at_once());
    CHECK(helper_of_loop() == other);
  }
  thread_team none(false);
  none.finish();
}

TEST_CASE("thread_team: starts nothing for one thread, for short calls, inside another team and in parts of a loop") {
  {
    const with_num_threads now(1);
    const thread_team team(true);
    parallel_for(4, [caller = std::this_thread::get_id()](std::size_t) { CHECK(std::this_thread::get_id() == caller); }, 1);
  }
  const with_num_threads now(2);
  {
    const thread_team none(false);
    const id caller = std::this_thread::get_id();
    std::size_t elsewhere = 1;  // 0 unless the system delays the calling thread
    for (int repeat = 0; repeat < 100 && elsewhere > 0; ++repeat) {
      std::atomic<std::size_t> others{0};
      parallel_for(20, [&](std::size_t) { others += std::this_thread::get_id() != caller; }, 1);
      elsewhere = others;
    }
    CHECK(elsewhere == 0);
  }
  const thread_team outer(true);
  const id helper = helper_of_loop();
  {
    const thread_team inner(true);
    CHECK(helper_of_loop() == helper);
  }
  CHECK(helper_of_loop() == helper);
  std::atomic<int> unshared{0};
  concino::core::for_each_chunk(2, [&](std::size_t) {
    const thread_team none(true);
    bool is_shared = true;  // false unless the system delays this thread
    for (int repeat = 0; repeat < 100 && is_shared; ++repeat) {
      std::atomic<bool> is_elsewhere{false};
      parallel_for(2, [&, part = std::this_thread::get_id()](std::size_t) {
        is_elsewhere = is_elsewhere || std::this_thread::get_id() != part;
        sleep(20);  // a helper would take the other part
      }, 1);
      is_shared = is_elsewhere;
    }
    unshared += !is_shared;
  });
  CHECK(unshared == 2);
}

TEST_CASE("thread_team: loops in loops, lists and chunks are those of one thread") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    const thread_team team(true);
    std::vector<int> calls(64 * 64, 0);
    parallel_for(64, [&](std::size_t i) {
      parallel_for(64, [&](std::size_t k) { ++calls[64 * i + k]; }, 1);
    }, 1);
    CHECK(calls == std::vector<int>(calls.size(), 1));
    const concino::id_range<concino::vert_id> range(50000);
    const auto odd = concino::core::collect_if(range, [](concino::vert_id v) { return v.raw() % 2 == 1; });
    REQUIRE(odd.size() == 25000);
    for (std::size_t i = 0; i < odd.size(); ++i) CHECK(odd[i].raw() == 2 * i + 1);
    std::size_t a = 0, b = 0;
    concino::core::run_both(true, [&] { a = 1; }, [&] { b = 2; });
    CHECK(a + b == 3);
  }
}

TEST_CASE("thread_team: many short loops, one after another") {
  for (const int n : {2, 3}) {
    const with_num_threads now(n);
    const thread_team team(true);
    std::size_t sum = 0;
    for (std::size_t loop = 0; loop < 2000; ++loop) {
      std::size_t parts[7] = {};
      parallel_for(7, [&](std::size_t i) { parts[i] = i + loop; }, 1);
      for (const std::size_t x : parts) sum += x;
    }
    CHECK(sum == 7 * (1999 * 2000 / 2) + 2000 * 21);
  }
}

TEST_CASE("thread_team: the calling thread waits for parts that take long") {
  const with_num_threads now(2);
  const thread_team team(true);
  const id caller = std::this_thread::get_id();
  bool is_done = false;  // not atomic: the end of the loop orders both threads
  std::atomic<bool> begun{false};
  concino::core::for_each_chunk(2, [&](std::size_t) {
    if (std::this_thread::get_id() == caller) {
      while (!begun) std::this_thread::yield();
      return;
    }
    begun = true;
    sleep(3000);
    is_done = true;
  });
  CHECK(is_done);
}

TEST_CASE("thread_team: loops that fail or are cancelled leave it ready for the next") {
  for (const int n : numbers_of_threads) {
    const with_num_threads now(n);
    const thread_team team(true);
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto fail = [](std::size_t i) { if (i % 100 == 37) throw std::runtime_error(std::to_string(i)); };
      CHECK_THROWS_WITH(parallel_for(1000, fail, 1), "37");
      std::atomic<std::size_t> calls{0};
      const auto count = [&](std::size_t) { ++calls; sleep(n > 1 ? 1 : 0); };
      parallel_for(100000, count, 1, [&](double) { return calls >= 10; });
      CHECK(calls >= 10);
      CHECK(calls < 100000);
      CHECK_THROWS_AS(parallel_for(100, [](std::size_t) {}, 1, [](double) -> bool { throw std::domain_error("stop"); }), std::domain_error);
      calls = 0;
      parallel_for(100, [&](std::size_t) { ++calls; }, 1);
      CHECK(calls == 100);
    }
  }
}

#ifdef __GLIBC__
TEST_CASE("thread_team: where the system starts no thread, the calling one does all") {
  const with_num_threads now(3);
  ::pthread_attr_t before, huge;
  REQUIRE(::pthread_getattr_default_np(&before) == 0);
  ::pthread_attr_init(&huge);
  REQUIRE(::pthread_attr_setstacksize(&huge, std::size_t{1} << 50) == 0);
  REQUIRE(::pthread_setattr_default_np(&huge) == 0);
  const id caller = std::this_thread::get_id();
  std::size_t calls = 0;
  {
    const thread_team team(true);
    parallel_for(8, [&](std::size_t) {
      CHECK(std::this_thread::get_id() == caller);
      sleep(100);
      ++calls;
    }, 1);
  }
  CHECK(calls == 8);
  ::pthread_setattr_default_np(&before);
  ::pthread_attr_destroy(&huge);
  ::pthread_attr_destroy(&before);
}
#endif
