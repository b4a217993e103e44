// The terminal, for terminal_progress.hpp. The only file that asks the system about it.
#pragma once

#include <concino/core/terminal_progress.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace concino {

namespace core {

CONCINO_INLINE std::size_t terminal_width() {
#if defined(__unix__) || defined(__APPLE__)
  if (!::isatty(STDERR_FILENO)) return 0;
  ::winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
#else
  return 0;
#endif
}

/// A time in the two largest of hours, minutes and seconds.
CONCINO_INLINE std::string time_text(double seconds) {
  if (!(seconds < 360000)) return "days";
  const auto s = static_cast<int>(std::ceil(seconds));
  char text[32];
  if (s < 60) std::snprintf(text, sizeof text, "%d s", s);
  else if (s < 3600) std::snprintf(text, sizeof text, "%d:%02d min", s / 60, s % 60);
  else std::snprintf(text, sizeof text, "%d:%02d h", s / 3600, s % 3600 / 60);
  return text;
}

CONCINO_INLINE std::string progress_line(std::string_view label, double fraction, double begin, double seconds,
                                         std::size_t width) {
  const double done = fraction > 0 ? std::min(fraction, 1.0) : 0;  // 0 if it is not a number
  char percent[48];
  std::snprintf(percent, sizeof percent, " %3d %%", static_cast<int>(100 * done));
  std::string end = percent;
  if (seconds > 0 && done > begin) {
    const double rate = (done - begin) / seconds;
    std::snprintf(percent, sizeof percent, "  %.3g %%/s  ", 100 * rate);
    end.append(percent).append(time_text((1 - done) / rate)).append(" left");
  }
  constexpr std::size_t bar = 20;
  std::string line(label);
  if (line.size() + 3 + bar + end.size() <= width) {
    const auto full = static_cast<std::size_t>(done * static_cast<double>(bar));
    line.append(" [").append(full, '#').append(bar - full, ' ').append("]");
  }
  line += end;
  line.resize(std::min(line.size(), width));
  return line;
}

}  // namespace core

CONCINO_INLINE terminal_progress::~terminal_progress() {
  if (has_line_) std::fputs("\r\033[K", stderr);
}

CONCINO_INLINE bool terminal_progress::operator()(double fraction, const char* label) {
  if (width_ == 0) return true;
  const clock::time_point now = clock::now();
  const bool is_new = label_ != label;
  if (is_new) {
    label_ = label;
    begin_ = fraction;
    start_ = now;
  } else if (now - last_ < std::chrono::milliseconds(100)) {
    return true;
  }
  last_ = now;
  has_line_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line = core::progress_line(label_, fraction, begin_, seconds, width_ - 1);
  std::fputs("\r\033[K", stderr);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  return true;
}

}  // namespace concino
