// An unsigned integer of 128 bits: what g++ and clang++ have built in.
#pragma once

namespace concino::core {

__extension__ typedef unsigned __int128 uint128;

}  // namespace concino::core
