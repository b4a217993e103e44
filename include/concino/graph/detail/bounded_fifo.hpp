// bounded_fifo: the queue of breadth-first search. Every node enters at most once, so the capacity is known in advance.
#pragma once

#include <cstddef>
#include <memory>

namespace concino::detail {

/// A first-in, first-out queue with at most `room` push operations in all. Memory is not touched before it is needed;
/// push does no checks.
template<class Node>
class bounded_fifo {
  std::allocator<Node> memory_;
  std::size_t room_;
  Node* nodes_;
  std::size_t head_ = 0, tail_ = 0;

 public:
  explicit bounded_fifo(std::size_t room) : room_(room), nodes_(memory_.allocate(room)) {}
  bounded_fifo(const bounded_fifo&) = delete;
  bounded_fifo& operator=(const bounded_fifo&) = delete;
  ~bounded_fifo() {
    std::destroy_n(nodes_, tail_);
    memory_.deallocate(nodes_, room_);
  }

  bool empty() const { return head_ == tail_; }
  void push(const Node& x) { std::construct_at(nodes_ + tail_++, x); }
  Node pop() { return nodes_[head_++]; }
};

}  // namespace concino::detail
