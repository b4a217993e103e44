#include <concino/core/function_ref.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {
int twice(int x) { return 2 * x; }
struct options { cn::function_ref<bool(int)> keep = nullptr; };
int kept(const options& o) { int n = 0; for (int i = 0; i < 10; ++i) n += !o.keep || o.keep(i); return n; }
}  // namespace

TEST_CASE("function_ref: refers to nothing, a lambda, a function or a const object") {
  CHECK(kept({}) == 10);
  int limit = 3;
  CHECK(kept({.keep = [&](int i) { return i < limit; }}) == 3);
  CHECK(kept({.keep = [](auto i) { return i != 4; }}) == 9);
  cn::function_ref<double(int)> f = twice;
  CHECK(f(21) == 42.0);
  f = &twice;
  CHECK(f(1) == 2.0);
  const auto c = [](int i) { return i + 1; };
  f = c;
  CHECK(f(1) == 2.0);
  f = nullptr;
  CHECK_FALSE(f);
  int (*none)(int) = nullptr;
  CHECK_FALSE(cn::function_ref<int(int)>(none));
}

TEST_CASE("function_ref: void ignores the result, and the callable keeps its state") {
  int calls = 0;
  auto count = [&](int) mutable { return ++calls; };
  cn::function_ref<void(int)> f = count;
  f(1);
  f(1);
  CHECK(calls == 2);
  static_assert(!std::is_constructible_v<cn::function_ref<int(int)>, int>);
}
