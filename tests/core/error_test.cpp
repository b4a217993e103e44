// Everything that concino throws is a concino::error, and errors of files name the line.
#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <string>

TEST_CASE_TEMPLATE("every error is a concino::error with its message", E, concino::invalid_mesh, concino::invalid_argument, concino::solver_error,
                   concino::unsupported, concino::io_error, concino::cancelled) {
  try {
    throw E("what happened");
  } catch (const concino::error& e) {
    CHECK(std::string(e.what()) == "what happened");
  }
}

TEST_CASE("a parse error names file, line, what was expected and what was found") {
  const concino::parse_error e("a.obj", 7, "a number", "'x'");
  CHECK(e.file == "a.obj");
  CHECK(e.line == 7);
  CHECK(e.expected == "a number");
  CHECK(e.found == "'x'");
  CHECK(std::string(e.what()) == "a.obj:7: expected a number, found 'x'");
  CHECK_THROWS_AS(throw e, concino::error);
}
