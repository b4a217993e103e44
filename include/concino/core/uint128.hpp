// An unsigned integer of 128 bits: the built-in type of g++ and clang++.
#pragma once

namespace concino::core {

__extension__ typedef unsigned __int128 uint128;

}  // namespace concino::core
