#include <concino/core/profiler.hpp>

#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace cn = concino;

namespace {

/// Opens 250 scopes in each other: "a" in "b" in "a" ...
void nest(cn::profiler& p, int depth) {
  if (depth == 0) return;
  const auto s = p.scope(depth % 2 ? "a" : "b");
  nest(p, depth - 1);
}

struct some_options {
  cn::progress progress = nullptr;
  cn::profiler* profiler = nullptr;
};

/// A function as those of the library: it reports two steps.
void work(const some_options& input) {
  const cn::core::profiled_options options(input, "work");
  cn::detail::report_progress(options->progress, 0, "first");
  cn::detail::report_progress(options->progress, 0.5, "first");
  cn::detail::report_progress(options->progress, 0, "second");
}

}  // namespace

TEST_CASE("profiler: 1,000 nested scopes on 4 threads add up") {
  cn::profiler p;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&] { nest(p, 250); });
  for (std::thread& t : threads) t.join();
  const auto entries = p.entries();
  REQUIRE(entries.size() == 250);
  double own = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    CHECK(entries[i].depth == i);
    CHECK(entries[i].calls == 4);
    CHECK(entries[i].name == (i % 2 ? "a" : "b"));
    CHECK(entries[i].own >= 0);
    if (i > 0) CHECK(entries[i].total <= entries[i - 1].total);
    own += entries[i].own;
  }
  CHECK(own == doctest::Approx(entries[0].total));
  const std::string trace = p.trace();
  CHECK(std::count(trace.begin(), trace.end(), '{') == 1001);
}

TEST_CASE("profiler: scopes of one name are one entry for each scope around them, in the order of their begins") {
  cn::profiler p;
  CHECK(p.entries().empty());
  for (int i = 0; i < 3; ++i) {
    const auto outer = p.scope("outer");
    { const auto inner = p.scope("inner"); }
    { const auto inner = p.scope("inner"); }
    const auto open = p.scope("late");
    CHECK(p.entries().size() == (i == 0 ? 2 : 3));  // those that have ended, and what is around them
  }
  { const auto inner = p.scope("inner"); }
  std::vector<std::string> names;
  std::vector<std::size_t> calls, depths;
  for (const auto& e : p.entries()) {
    names.push_back(e.name);
    calls.push_back(e.calls);
    depths.push_back(e.depth);
  }
  CHECK(names == std::vector<std::string>{"outer", "inner", "late", "inner"});
  CHECK(calls == std::vector<std::size_t>{3, 6, 3, 1});
  CHECK(depths == std::vector<std::size_t>{0, 1, 1, 0});
  const std::string report = p.report();
  CHECK(report.substr(0, report.find('\n')) == "scope       calls     total s       own s   share");
  CHECK(report.find("\n  inner         6") != std::string::npos);
  CHECK(std::count(report.begin(), report.end(), '\n') == 5);
}

TEST_CASE("profiler: an exception ends scopes") {
  cn::profiler p;
  try {
    const auto a = p.scope("a");
    const auto b = p.scope("b");
    throw 1;
  } catch (int) {
  }
  { const auto c = p.scope("c"); }
  CHECK(p.entries()[2].depth == 0);
}

TEST_CASE("profiler: functions open a scope and one for each label of progress; without a profiler they call progress only") {
  std::vector<std::string> labels;
  const auto note = [&](double, const char* label) {
    labels.push_back(label);
    return labels.size() != 3;
  };
  cn::profiler p;
  work({.profiler = &p});
  const auto entries = p.entries();
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].name == "work");
  CHECK(entries[1].name == "first");
  CHECK(entries[1].calls == 1);
  CHECK(entries[2].name == "second");
  CHECK(entries[2].depth == 1);
  CHECK_THROWS_AS(work({.progress = note, .profiler = &p}), cn::cancelled);
  CHECK(labels == std::vector<std::string>{"first", "first", "second"});
  CHECK(p.entries()[0].calls == 2);
  work({});
  CHECK(p.entries()[0].calls == 2);
}

TEST_CASE("profiler: functions that a function calls with its options are steps of it") {
  cn::profiler p;
  const some_options input{.profiler = &p};
  {
    const cn::core::profiled_options options(input, "whole");
    CHECK(!options->profiler);
    cn::detail::report_progress(options->progress, 0, "start");
    work(*options);
  }
  std::vector<std::string> names;
  for (const auto& e : p.entries()) names.push_back(std::string(e.depth, '-') + e.name);
  CHECK(names == std::vector<std::string>{"whole", "-start", "-first", "-second"});
}

TEST_CASE("profiler: traces are JSON, and are saved") {
  cn::profiler p;
  { const auto s = p.scope("say \"1\\2\"\n"); }
  const std::string trace = p.trace();
  CHECK(trace.find("{\"name\": \"say \\\"1\\\\2\\\"\\u000a\", \"ph\": \"X\", \"pid\": 1, \"tid\": 1, \"ts\": ") != std::string::npos);
  const std::string path = "profiler_test_trace.json";
  p.save_trace(path);
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  REQUIRE(file);
  std::string text(trace.size() + 1, ' ');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  std::remove(path.c_str());
  CHECK(text == trace);
  CHECK_THROWS_WITH_AS(p.save_trace("no_such_folder/t.json"),
                       "no_such_folder/t.json: the trace cannot be written; check that its folder exists and has space", cn::io_error);
}
