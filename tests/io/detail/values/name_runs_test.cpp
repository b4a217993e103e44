#include <concino/io/detail/values/name_runs.hpp>

#include <doctest/doctest.h>

using namespace concino::detail;

namespace {

std::string spelled(const name_runs& names, std::size_t polys) {
  std::string s;
  names.for_each(polys, [&](std::size_t first, std::size_t end, std::string_view name) {
    (((s += std::to_string(first)) += '-') += std::to_string(end)) += (std::string("=") += name) += ' ';
  });
  return s;
}

}  // namespace

TEST_CASE("name_runs: a name applies to the polys up to the next name or the end") {
  name_runs n;
  CHECK(n.empty());
  CHECK(spelled(n, 3) == "0-3= ");
  CHECK(spelled(n, 0) == "");
  n.change(1, "a");
  n.change(3, "b");
  n.change(4, "b");
  n.change(5, "c");
  n.change(5, "");
  n.change(6, "d");
  n.end(6);
  CHECK(spelled(n, 6) == "0-1= 1-3=a 3-5=b 5-6= ");
  CHECK(n.all([](std::string_view s) { return s < "c"; }));
  CHECK(!n.all([](std::string_view s) { return s < "b"; }));
}

TEST_CASE("name_runs: changes without effect are not stored") {
  name_runs n;
  n.change(0, "");
  CHECK(n.empty());
  n.change(0, "a");
  n.change(0, "b");
  n.change(2, "c");
  n.change(2, "b");
  CHECK(spelled(n, 4) == "0-4=b ");
  n.rename([](std::string_view) { return std::string(); });
  CHECK(n.empty());
  n.change(2, "a");
  n.end(2);
  CHECK(n.empty());
}

TEST_CASE("name_numbers: names are numbered from 1 in order of appearance; the empty name is 0") {
  name_numbers number;
  CHECK(number("b") == 1);
  CHECK(number("a") == 2);
  CHECK(number("") == 0);
  CHECK(number("b") == 1);
}

TEST_CASE("is_number: accepts exactly the texts that writing the number gives") {
  int i = 0;
  CHECK(is_number("label_7", "label_", i));
  CHECK(i == 7);
  CHECK(is_number("label_-2147483648", "label_", i));
  for (const char* bad : {"label_", "label_07", "label_7 ", "label_+7", "label_7x", "label_2147483648", "Label_7", "7", "", "label_-0", "label_-07", "label_2147483648", "label_-2147483649", "label_99999999999999999999"})
    CHECK_MESSAGE(!is_number(bad, "label_", i), bad);
}

TEST_CASE("name_table: finds each of 1,000 names, and keeps its number") {
  name_table names;
  CHECK(names.find("") == name_table::none);
  for (std::size_t i = 0; i < 1000; ++i) CHECK(names.add("name " + std::to_string(i)) == i);
  CHECK(names.add("") == 1000);
  CHECK(names.size() == 1001);
  for (std::size_t i = 0; i < 1000; ++i) {
    CHECK(names.find("name " + std::to_string(i)) == i);
    CHECK(names[i] == "name " + std::to_string(i));
  }
  CHECK(names.add("name 7") == 7);
  CHECK(names.find("name 1000") == name_table::none);
}
