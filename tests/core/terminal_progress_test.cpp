#include <concino/core/terminal_progress.hpp>

#include <concino/core/progress.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace cn = concino;

TEST_CASE("terminal_progress: the line has label, bar, fraction, rate and time left, and fits the terminal") {
  using cn::core::progress_line;
  CHECK(progress_line("solving", 0.5, 0, 10, 80) == "solving [##########          ]  50 %  5 %/s  10 s left");
  CHECK(progress_line("solving", 0.5, 0.25, 10, 80) == "solving [##########          ]  50 %  2.5 %/s  20 s left");
  CHECK(progress_line("solving", 0, 0, 0, 80) == "solving [                    ]   0 %");
  CHECK(progress_line("solving", 1, 0, 4, 80) == "solving [####################] 100 %  25 %/s  0 s left");
  CHECK(progress_line("solving", 0.1, 0, 10, 80).find("  1 %/s  1:30 min left") != std::string::npos);
  CHECK(progress_line("solving", 0.01, 0, 100, 80).find("  0.01 %/s  2:45 h left") != std::string::npos);
  CHECK(progress_line("solving", 0.5, 0, 10, 40) == "solving  50 %  5 %/s  10 s left");
  CHECK(progress_line("solving", 0.5, 0, 10, 12) == "solving  50 ");
  CHECK(progress_line("x", 2, 0, 1, 10).size() <= 10);
  CHECK(progress_line("x", 1e-12, 0, 1000, 80).find("days left") != std::string::npos);
}

TEST_CASE("terminal_progress: never cancels, and writes nothing to a pipe") {
  cn::terminal_progress line;
  const cn::progress p = line;
  for (int i = 0; i <= 4; ++i) CHECK(p(i / 4.0, "working"));
  CHECK(cn::core::terminal_width() < 100000);
}
