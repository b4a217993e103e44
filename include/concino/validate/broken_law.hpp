// The findings of check_laws.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// One violation of a law of a concept. The laws are listed in the concept headers (<concino/concepts/primal_graph.hpp>
/// ...).
struct broken_law {
  std::string law;      ///< "PG3"
  std::string what;     ///< a sentence: what was found
  std::string witness;  ///< the elements concerned, by letter and index_of: "v7 v9"
};

namespace detail {

/// Collects broken laws, at most a few of each: the first witnesses explain a mistake, further ones do not.
class law_log {
  std::vector<broken_law> found_;

 public:
  static constexpr std::size_t per_law = 4;

  std::size_t count(const char* law) const {
    std::size_t n = 0;
    for (const broken_law& b : found_) n += b.law == law;
    return n;
  }
  bool empty() const { return found_.empty(); }
  bool full(const char* law) const { return count(law) >= per_law; }
  void add(const char* law, std::string what, std::string witness) {
    if (!full(law)) found_.push_back({law, std::move(what), std::move(witness)});
  }
  std::vector<broken_law> take() { return std::move(found_); }
};

}  // namespace detail

}  // namespace concino
