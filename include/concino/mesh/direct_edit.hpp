// direct_edit: what became of an edit that a mesh may do itself, faster than by rewire.
#pragma once

namespace concino {

enum class direct_edit : unsigned char {
  done,
  refused,         // a flip: the new edge exists; a collapse: the link condition does not hold
  left_to_rewire,  // nothing was done: the caller uses rewire, or finds out why the edit is impossible
};

}  // namespace concino
