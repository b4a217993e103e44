// Hashes that are the same on every machine and in every run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace concino::core {

/// Pseudorandom bits; a bijection, so different inputs give different outputs.      Source: SplitMix64, Steele, Lea and
/// Flood 2014.
constexpr std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Source: Fowler, Noll, Vo: FNV-1a, 64 bits.
inline std::uint64_t hash_bytes(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

/// The hash as 16 digits.
inline std::string hash_text(std::string_view bytes) {
  std::string digits(16, '0');
  std::uint64_t rest = hash_bytes(bytes);
  for (std::size_t i = 16; i-- > 0; rest >>= 4) digits[i] = "0123456789abcdef"[rest & 15];
  return digits;
}

}  // namespace concino::core
