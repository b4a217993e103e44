#include <concino/io/label_names.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("label_names: finds the first name of a label, and the first label of a name, of the kind") {
  const label_names empty;
  CHECK(empty.find(element_kind::poly, 1) == nullptr);
  CHECK(empty.find(element_kind::poly, "steel") == nullptr);
  label_names t{{{element_kind::poly, 1, "steel"},
                 {element_kind::face, 1, "inlet", {"type patch;"}},
                 {element_kind::poly, 1, "iron"},
                 {element_kind::poly, 2, "steel"}}};
  CHECK(t.find(element_kind::poly, 1) == &t.names[0]);
  CHECK(t.find(element_kind::face, 1) == &t.names[1]);
  CHECK(t.find(element_kind::poly, 2) == &t.names[3]);
  CHECK(t.find(element_kind::edge, 1) == nullptr);
  CHECK(t.find(element_kind::poly, "steel") == &t.names[0]);
  CHECK(t.find(element_kind::poly, "iron") == &t.names[2]);
  CHECK(t.find(element_kind::face, "steel") == nullptr);
  label_names same = t;
  CHECK(same == t);
  same.names[1].lines.push_back("nFaces 3;");
  CHECK(same != t);
}
