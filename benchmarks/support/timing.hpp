// Measures contenders for the same work against each other.
//
// The result is a ratio that load or clock changes of the machine do not distort. Each round runs every contender once, in an order that changes from round
// to round. The ratio is computed in each round, and its median is reported. Google Benchmark is not used: it can interleave repetitions, but reports each
// benchmark alone. It measures the wall-clock time of loops that would store or free the results inside the measurement. And here memory is a column of the
// same table.
#pragma once

#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <sched.h>
#include <time.h>

namespace bench {

/// Keeps the thread on one core, so that no contender pays for a move: the last core allowed, because the first one serves interrupts. Returns what was allowed
/// before, for use_cores().
inline cpu_set_t pin_to_one_core() {
  cpu_set_t allowed, one;
  CPU_ZERO(&allowed);
  CPU_ZERO(&one);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return allowed;
  for (int cpu = CPU_SETSIZE - 1; cpu >= 0; --cpu)
    if (CPU_ISSET(cpu, &allowed)) {
      CPU_SET(cpu, &one);
      sched_setaffinity(0, sizeof one, &one);
      break;
    }
  return allowed;
}

/// For works of several threads.
inline void use_cores(const cpu_set_t& allowed) { sched_setaffinity(0, sizeof allowed, &allowed); }

inline double process_seconds() {
  timespec t = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// CPU seconds of f(); its result is destroyed after the clock has stopped.
template<class F>
double seconds_of(F&& f) {
  const double start = process_seconds();
  auto result = f();
  asm volatile("" : : "g"(&result) : "memory");
  return process_seconds() - start;
}

/// Seconds that pass while f() runs, for works of several threads.
template<class F>
double wall_seconds_of(F&& f) {
  const auto now = [] {
    timespec t = {};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  auto result = f();
  asm volatile("" : : "g"(&result) : "memory");
  return now() - start;
}

inline double median(std::vector<double> x) {
  if (x.empty()) return 0;
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  if (x.size() % 2) return *middle;
  return (*middle + *std::max_element(x.begin(), middle)) / 2;
}

/// One row of the result: the value of one contender, and the value of `concino` divided by it. Both are medians.
struct row {
  std::string work, contender, unit;
  double value, ours_over_it;
};

/// Prints a row as tab-separated text. report.awk joins the rows of all programs with the budgets.
inline void print(std::FILE* out, const row& r) {
  std::fprintf(out, "%s\t%s\t%s\t%.6g\t%.4g\n", r.work.c_str(), r.contender.c_str(), r.unit.c_str(), r.value, r.ours_over_it);
  std::fflush(out);
}

/// Prints one point of a curve: the cost of `elements` elements for the library and for the floor. model says how the cost should grow: "n" or "n log n".
inline void print_point(std::FILE* out, const std::string& work, const char* model, double elements, double ours, double floor) {
  std::fprintf(out, "point\t%s\t%s\t%.0f\t%.6g\t%.6g\n", work.c_str(), model, elements, ours, floor);
  std::fflush(out);
}

struct contender {
  std::string name;
  std::function<double()> run;   // does one run and returns its CPU seconds
  int every = 1;                 // slow peers run only in every `every`-th round
};

/// Runs `rounds` rounds of all contenders. A first round to warm up does not count; it is left out if `rounds` is 1. Work that takes less than a few
/// milliseconds gets more rounds.
inline std::vector<row> compare(const std::string& work, int rounds, const std::vector<contender>& them) {
  std::vector<std::vector<double>> seconds(them.size()), ratios(them.size());
  std::vector<std::size_t> order(them.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::size_t ours = them.size();
  for (std::size_t i = 0; i < them.size(); ++i)
    if (them[i].name == "concino") ours = i;
  std::mt19937 shuffle(1);
  if (rounds > 1)
    for (const auto& c : them)
      if (c.every == 1 && c.run() < 0.01) rounds = std::max(rounds, 25);
  for (int r = 0; r < rounds; ++r) {
    std::vector<double> now(them.size(), -1);
    std::shuffle(order.begin(), order.end(), shuffle);
    for (std::size_t i : order)
      if (r % them[i].every == 0) seconds[i].push_back(now[i] = them[i].run());
    for (std::size_t i = 0; i < them.size(); ++i)
      if (ours < them.size() && now[i] > 0) ratios[i].push_back(now[ours] / now[i]);
  }
  std::vector<row> rows;
  for (std::size_t i = 0; i < them.size(); ++i) rows.push_back({work, them[i].name, "s", median(seconds[i]), median(ratios[i])});
  return rows;
}

}  // namespace bench
