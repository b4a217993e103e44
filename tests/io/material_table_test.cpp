#include <concino/io/material_table.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("material_table: find returns the first material of that name") {
  material_table t;
  CHECK(t.empty());
  CHECK(t.find("a") == nullptr);
  t.materials = {{"a", {"Kd 1 0 0"}}, {"b", {}}, {"a", {"Kd 0 1 0"}}};
  CHECK(!t.empty());
  CHECK(t.find("a") == &t.materials[0]);
  CHECK(t.find("b") == &t.materials[1]);
  CHECK(t.find("") == nullptr);
  material_table same = t;
  CHECK(same == t);
  same.materials[0].lines.push_back("illum 2");
  CHECK(same != t);
  CHECK(!material_table{.unread = {"x.mtl"}}.empty());
  CHECK(!material_table{.head = {"# by hand"}}.empty());
  CHECK(!material_table{.libraries = {"x.mtl"}}.empty());
}
