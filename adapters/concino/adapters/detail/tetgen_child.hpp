// Runs a function in a child process, so that the caller survives whatever it does. Where the system is not Linux it
// runs in the caller, without limits.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/progress.hpp>

#include <cstddef>
#include <cstring>
#include <string>

#ifdef __linux__
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#endif

namespace concino::detail {

struct child_limits {
  double seconds = 0;
  std::size_t bytes = 0;  // beyond what the caller has; 0: any
  concino::progress progress = nullptr;
};

#ifdef __linux__

/// A file in memory, without a name. It grows as it is written, so the size of a result need not be known before.
class memory_file {
  int descriptor_;

 public:
  /// Errors: unsupported if the system has no room for it.
  explicit memory_file(const char* caller) : descriptor_(memfd_create("concino", MFD_CLOEXEC)) {
    if (descriptor_ < 0)
      core::throw_joined<unsupported>(
          {caller, ": the system allows no further file in memory; .in_process = true needs none"});
  }
  memory_file(const memory_file&) = delete;
  memory_file& operator=(const memory_file&) = delete;
  ~memory_file() { close(descriptor_); }

  /// Appends; returns whether there was room.
  bool write(const void* data, std::size_t n) const {
    for (const char* p = static_cast<const char*>(data); n > 0;) {
      const ssize_t written = ::write(descriptor_, p, n);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      p += written;
      n -= static_cast<std::size_t>(written);
    }
    return true;
  }
  /// Reads n bytes from an offset; returns whether there were as many.
  bool read(std::size_t offset, void* data, std::size_t n) const {
    for (char* p = static_cast<char*>(data); n > 0;) {
      const ssize_t got = pread(descriptor_, p, n, static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      p += got;
      offset += static_cast<std::size_t>(got);
      n -= static_cast<std::size_t>(got);
    }
    return true;
  }
};

/// The size of the address space of this process, in bytes; with sanitizers it is far larger than the memory in use.
inline std::size_t address_space() {
  std::size_t pages = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(f, "%zu", &pages) != 1) pages = 0;
    std::fclose(f);
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// A child process. If it still runs when this is destroyed, it is ended.
class child_process {
  pid_t id_;
  bool runs_ = true;
  int status_ = 0;

 public:
  explicit child_process(pid_t id) : id_(id) {}
  child_process(const child_process&) = delete;
  child_process& operator=(const child_process&) = delete;
  ~child_process() {
    if (!runs_) return;
    kill(id_, SIGKILL);
    while (waitpid(id_, &status_, 0) < 0 && errno == EINTR) continue;
  }
  /// Whether it has ended. A program that ignores SIGCHLD learns no status, so ECHILD counts as the end.
  bool has_ended() {
    const pid_t r = waitpid(id_, &status_, WNOHANG);
    if (r == id_ || (r < 0 && errno == ECHILD)) runs_ = false;
    return !runs_;
  }
  int signal() const { return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0; }
};

/// What the child does first: it ends with the caller, within its limits, without messages of its own and without
/// handlers of the caller's signals.
inline bool prepare_child(rlim_t address_limit) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int s : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT}) std::signal(s, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (const int null = open("/dev/null", O_WRONLY); null >= 0) {
    dup2(null, 1);
    dup2(null, 2);
  }
  if (address_limit == RLIM_INFINITY) return true;
  rlimit now;
  if (getrlimit(RLIMIT_AS, &now) != 0) return false;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY || address_limit < now.rlim_max ? address_limit : now.rlim_max;
  return setrlimit(RLIMIT_AS, &now) == 0;
}

/// Ends the child at once: without destructors, which may crash.
[[noreturn]] inline void end_child() { _exit(0); }

/// Calls work() in a child process, which writes its results to memory files that were made before, and waits for the
/// end. The child ends by _exit: without destructors of the caller's objects. Its exit code is not used: the files say
/// what was done.
/// Errors: unsupported that says why the child was ended or crashed. cancelled.
template<class Work>
void run_in_child(const char* caller, const char* what, const child_limits& limits, const Work& work) {
  const rlim_t address_limit = limits.bytes == 0 ? RLIM_INFINITY : static_cast<rlim_t>(address_space() + limits.bytes);
  const pid_t id = fork();
  if (id < 0)
    core::throw_joined<unsupported>({caller, ": the system allows no further process; .in_process = true needs none"});
  if (id == 0) {
    if (prepare_child(address_limit)) work();
    end_child();
  }
  child_process child(id);
  const auto start = std::chrono::steady_clock::now();
  for (long pause = 50'000; !child.has_ended(); pause = pause < 2'000'000 ? pause + pause / 4 : pause) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (elapsed > limits.seconds)
      core::throw_joined<unsupported>({caller, ": ", what, " was ended since it took longer than max_seconds"});
    // how long it will take is not known
    report_progress(limits.progress, elapsed / (elapsed + 10), "tetrahedralizing");
    const timespec t{0, pause};
    nanosleep(&t, nullptr);
  }
  if (child.signal() != 0)
    core::throw_joined<unsupported>(
        {caller, ": ", what, " crashed, by signal ", child.signal(), " (", strsignal(child.signal()), ")"});
}

#else

/// A file in memory.
class memory_file {
  mutable std::string bytes_;

 public:
  explicit memory_file(const char*) {}
  bool write(const void* data, std::size_t n) const {
    bytes_.append(static_cast<const char*>(data), n);
    return true;
  }
  bool read(std::size_t offset, void* data, std::size_t n) const {
    if (offset > bytes_.size() || bytes_.size() - offset < n) return false;
    if (n > 0) std::memcpy(data, bytes_.data() + offset, n);
    return true;
  }
};

inline void end_child() {}

/// Calls work() in this process.
template<class Work>
void run_in_child(const char*, const char*, const child_limits&, const Work& work) {
  work();
}

#endif

}  // namespace concino::detail
