#include "call.hpp"

#include <concino/validate.hpp>
#include <concino/validate/halfedge_links.hpp>

void call_validate() {
  call("check_laws", [](auto& m) { cn::check_laws(m); }, all);
  call("validate", [](auto& m) { cn::validate(m); }, all);
  call("assert_halfedge_links", [](auto& m) { cn::assert_halfedge_links(m); }, kinds<>());  // no native mesh has half-edges
  call("defect_name", [] { cn::defect_name(cn::defect_kind{}); });
}
