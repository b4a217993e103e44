// Records the message of every concino::error that a test program throws, for the page of the target docs_messages: the linker hands __cxa_throw to this file
// (-Wl,--wrap=__cxa_throw). Nothing is recorded unless the environment variable CONCINO_TEST_MESSAGES names an existing folder.
// There each process appends to a file of its own, <process>.tsv, one line per message: the test's file, the test case, the type thrown and the message.
// Allocates nothing, for tests in which every allocation fails. Messages of one test case that differ in digits only are recorded once.
#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <fcntl.h>
#include <unistd.h>

#include <bitset>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <typeinfo>

extern "C" {
[[noreturn]] void __real___cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*));
[[noreturn]] void __wrap___cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*));
}

namespace {

// A line on its way into a file: fields with tabs between them, and other unprintable characters escaped.
class line {
  char text_[8192];
  std::size_t size_ = 0;

  void append(char c) {
    if (size_ + 1 < sizeof text_) text_[size_++] = c;  // keeps a place for the end of the line
  }

 public:
  void add_field(std::string_view field) {
    if (size_ > 0) append('\t');
    for (const char c : field) {
      if (c >= ' ' && c <= '~' && c != '\\') {
        append(c);
      } else {
        const auto byte = static_cast<unsigned char>(c);
        for (const char escaped : {'\\', 'x', "0123456789abcdef"[byte / 16], "0123456789abcdef"[byte % 16]}) append(escaped);
      }
    }
  }
  void write_to(int file) {
    text_[size_++] = '\n';
    [[maybe_unused]] const auto written = ::write(file, text_, size_);
  }
};

// The part of "/somewhere/tests/io/obj_test.cpp" after tests/.
std::string_view below_tests(std::string_view path) {
  const auto at = path.rfind("/tests/");
  return at == path.npos ? path : path.substr(at + 7);
}

// "invalid_mesh" of "N7concino12invalid_meshE": the last name of a mangled name.
std::string_view last_name(std::string_view mangled) {
  std::string_view name = mangled;
  for (std::size_t i = 0; i < mangled.size();) {
    std::size_t length = 0, digits = i;
    for (; digits < mangled.size() && mangled[digits] >= '0' && mangled[digits] <= '9'; ++digits)
      length = 10 * length + static_cast<std::size_t>(mangled[digits] - '0');
    if (length > 0) name = mangled.substr(digits, length);
    i = length > 0 ? digits + length : i + 1;
  }
  return name;
}

// True the first time that this test case throws this message, digits aside. Rarely false then too: only a hash is kept.
bool is_new(const void* test_case, const char* type, const char* message) {
  static std::bitset<(1 << 22)> seen;
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(test_case);
  const auto mix = [&](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3; };
  for (; *type; ++type) mix(*type);
  for (; *message; ++message)
    if (*message < '0' || *message > '9') mix(*message);
  hash = (hash ^ hash >> 32) % seen.size();
  if (seen[hash]) return false;
  return seen[hash] = true;
}

// -1 where nothing is to be recorded.
int open_file() {
  const char* folder = std::getenv("CONCINO_TEST_MESSAGES");
  char path[4096];
  if (!folder || !*folder || std::snprintf(path, sizeof path, "%s/%ld.tsv", folder, static_cast<long>(::getpid())) >= int{sizeof path}) return -1;
  return ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
}

void record(const concino::error& e, const std::type_info& type) {
  static const int file = open_file();
  static std::mutex one_at_a_time;
  if (file == -1) return;
  const std::lock_guard lock(one_at_a_time);
  const doctest::ContextOptions* const run = doctest::getContextOptions();
  const doctest::detail::TestCase* const test_case = run ? run->currentTest : nullptr;
  if (!test_case || !is_new(test_case, type.name(), e.what())) return;
  static line l;
  l = {};
  l.add_field(below_tests(test_case->m_file.c_str()));
  std::string_view name = test_case->m_name;
  if (const auto type_size = test_case->m_type.size()) name.remove_suffix(type_size + 2);  // "name<type>"
  l.add_field(name);
  l.add_field(last_name(type.name()));
  l.add_field(e.what());
  l.write_to(file);
}

}  // namespace

extern "C" void __wrap___cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*)) {
  const int error_number = errno;
  void* base = thrown;
  if (typeid(concino::error).__do_catch(type, &base, 1)) record(*static_cast<const concino::error*>(base), *type);
  errno = error_number;
  __real___cxa_throw(thrown, type, destroy);
}
