// The clock, the storage and the output of profiler.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/profiler.hpp>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <limits>
#include <mutex>
#include <utility>

namespace concino {

namespace core {

/// Its address tells threads apart. A new thread may have the address of one that has ended.
inline constinit thread_local char profiled_thread = 0;

}  // namespace core

struct profiler::running {
  std::uint32_t node, thread, parent;  // parent: the node of the scope around it
  std::chrono::steady_clock::time_point start;
};

struct profiler::storage {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// One name in one outer scope. Children are a list.
  struct node {
    std::string name;
    std::uint32_t parent = 0, first_child = none, next = none;
    std::size_t calls = 0;
    std::chrono::nanoseconds total{}, inside{};  // inside: in scopes inside of it
  };
  struct thread {
    const char* marker;
    std::uint32_t current;  // the node of the innermost scope that is open
  };
  struct event {
    std::uint32_t node, thread;
    std::chrono::nanoseconds start, duration;
  };

  mutable std::mutex mutex;
  const std::chrono::steady_clock::time_point origin = std::chrono::steady_clock::now();
  std::vector<node> nodes = std::vector<node>(1);  // the first is around all
  std::vector<thread> threads;
  std::vector<event> events;
  std::vector<running> open;
  std::vector<std::uint32_t> unused;  // places in `open`

  std::uint32_t this_thread() {
    const auto it = std::find_if(threads.begin(), threads.end(),
                                 [](const thread& t) { return t.marker == &core::profiled_thread; });
    if (it == threads.end()) {
      threads.push_back({&core::profiled_thread, 0});
      return static_cast<std::uint32_t>(threads.size() - 1);
    }
    return static_cast<std::uint32_t>(it - threads.begin());
  }

  std::uint32_t child(std::uint32_t parent, std::string_view name) {
    std::uint32_t last = none;
    for (std::uint32_t c = nodes[parent].first_child; c != none; c = nodes[c].next) {
      if (nodes[c].name == name) return c;
      last = c;
    }
    const auto c = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({std::string(name), parent});
    (last == none ? nodes[parent].first_child : nodes[last].next) = c;
    return c;
  }

  /// Calls f(node, depth) for all but the first, each before its children.
  template<class F>
  void for_each_node(F&& f) const {
    std::size_t depth = 0;
    std::uint32_t i = nodes[0].first_child;
    while (i != none) {
      f(nodes[i], depth);
      if (nodes[i].first_child != none) {
        i = nodes[i].first_child;
        ++depth;
        continue;
      }
      while (i != 0 && nodes[i].next == none) {
        i = nodes[i].parent;
        --depth;
      }
      i = i == 0 ? none : nodes[i].next;
    }
  }
};

CONCINO_INLINE profiler::profiler() : storage_(std::make_unique<storage>()) {}
CONCINO_INLINE profiler::~profiler() = default;

CONCINO_INLINE std::uint32_t profiler::begin(std::string_view name) {
  storage& s = *storage_;
  const std::lock_guard lock(s.mutex);
  const std::uint32_t thread = s.this_thread(), parent = s.threads[thread].current, node = s.child(parent, name);
  if (s.unused.empty()) {
    s.unused.reserve(s.open.size() + 1);  // so that end() needs no memory
    s.unused.push_back(static_cast<std::uint32_t>(s.open.size()));
    s.open.push_back({});
  }
  if (s.events.capacity() < s.events.size() + s.open.size()) s.events.reserve(2 * s.events.size() + s.open.size());
  const std::uint32_t place = s.unused.back();
  s.unused.pop_back();
  s.threads[thread].current = node;
  s.open[place] = {node, thread, parent, std::chrono::steady_clock::now()};
  return place;
}

CONCINO_INLINE void profiler::end(std::uint32_t place) noexcept {
  const auto now = std::chrono::steady_clock::now();
  storage& s = *storage_;
  const std::lock_guard lock(s.mutex);
  const running r = s.open[place];
  s.unused.push_back(place);
  s.threads[r.thread].current = r.parent;
  storage::node& n = s.nodes[r.node];
  const auto time = std::chrono::duration_cast<std::chrono::nanoseconds>(now - r.start);
  ++n.calls;
  n.total += time;
  s.nodes[r.parent].inside += time;
  const auto start = std::chrono::duration_cast<std::chrono::nanoseconds>(r.start - s.origin);
  s.events.push_back({r.node, r.thread, start, time});
}

CONCINO_INLINE std::vector<profile_entry> profiler::entries() const {
  const auto seconds = [](std::chrono::nanoseconds t) { return std::chrono::duration<double>(t).count(); };
  const std::lock_guard lock(storage_->mutex);
  std::vector<profile_entry> result;
  storage_->for_each_node([&](const storage::node& n, std::size_t depth) {
    if (n.calls == 0 && n.inside.count() == 0) return;
    result.push_back({n.name, depth, n.calls, seconds(n.total), n.calls == 0 ? 0 : seconds(n.total - n.inside)});
  });
  return result;
}

namespace core {

/// Appends a number with a fixed count of digits behind the point, right-aligned.
CONCINO_INLINE void append_fixed(std::string& text, double x, int digits, std::size_t width) {
  char buffer[400];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, digits);
  const auto size = static_cast<std::size_t>(end - buffer);
  text.append(width > size ? width - size : 0, ' ').append(buffer, size);
}

/// Appends a text in quotes, as JSON has it.
CONCINO_INLINE void append_json_string(std::string& text, std::string_view s) {
  text += '"';
  for (const char c : s) {
    if (c == '"' || c == '\\') text += '\\';
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20) text += c;
    else text.append("\\u00").append(1, "0123456789abcdef"[code >> 4]).append(1, "0123456789abcdef"[code & 15]);
  }
  text += '"';
}

}  // namespace core

CONCINO_INLINE std::string profiler::report() const {
  const std::vector<profile_entry> rows = entries();
  std::size_t width = 5;
  double all = 0;
  for (const profile_entry& e : rows) {
    width = std::max(width, 2 * e.depth + e.name.size());
    if (e.depth == 0) all += e.total;
  }
  std::string text = "scope";
  text.append(width - text.size(), ' ').append("     calls     total s       own s   share\n");
  for (const profile_entry& e : rows) {
    text.append(2 * e.depth, ' ').append(e.name).append(width - 2 * e.depth - e.name.size(), ' ');
    core::append_fixed(text, static_cast<double>(e.calls), 0, 10);
    core::append_fixed(text, e.total, 6, 12);
    core::append_fixed(text, e.own, 6, 12);
    core::append_fixed(text, all > 0 ? 100 * e.total / all : 0, 1, 7);
    text += "%\n";
  }
  return text;
}

CONCINO_INLINE std::string profiler::trace() const {
  const std::lock_guard lock(storage_->mutex);
  std::string text = "{\"displayTimeUnit\": \"ms\", \"traceEvents\": [";
  const char* separator = "\n";
  for (const storage::event& e : storage_->events) {
    text.append(std::exchange(separator, ",\n")).append("{\"name\": ");
    core::append_json_string(text, storage_->nodes[e.node].name);
    text += ", \"ph\": \"X\", \"pid\": 1, \"tid\": ";
    core::append_fixed(text, e.thread + 1.0, 0, 0);
    text += ", \"ts\": ";  // in microseconds
    core::append_fixed(text, static_cast<double>(e.start.count()) / 1000, 3, 0);
    text += ", \"dur\": ";
    core::append_fixed(text, static_cast<double>(e.duration.count()) / 1000, 3, 0);
    text += '}';
  }
  text += "\n]}\n";
  return text;
}

CONCINO_INLINE void profiler::save_trace(const std::string& path) const {
  const std::string text = trace();
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  const bool is_written = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if ((file && std::fclose(file) != 0) || !is_written)
    core::throw_joined<io_error>({path, ": the trace cannot be written; check that its folder exists and has space"});
}

namespace core {

CONCINO_INLINE progress_scopes::progress_scopes(profiler* p, const progress& next, const char* name)
    : profiler_(p), next_(next) {
  if (p) all_.emplace(p, name);
}

CONCINO_INLINE bool progress_scopes::operator()(double fraction, const char* label) {
  if (label != label_) {
    step_.reset();
    label_ = label;
    step_.emplace(profiler_, label);
  }
  return !next_ || next_(fraction, label);
}

}  // namespace core

}  // namespace concino
