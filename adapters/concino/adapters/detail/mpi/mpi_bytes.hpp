// Arrays as bytes, sent from one process to another.
#pragma once

#include <concino/core/error.hpp>

#include <mpi.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Arrays of plain values, one after another, each after its size.
class byte_writer {
  std::vector<char> bytes_;

 public:
  template<class T>
    requires std::is_trivially_copyable_v<T>
  void put(const std::vector<T>& values) {
    const std::size_t count = values.size(), at = bytes_.size();
    bytes_.resize(at + sizeof count + count * sizeof(T));
    std::memcpy(bytes_.data() + at, &count, sizeof count);
    if (count > 0) std::memcpy(bytes_.data() + at + sizeof count, values.data(), count * sizeof(T));
  }
  const std::vector<char>& bytes() const { return bytes_; }
};

/// Reads them in the same order.
class byte_reader {
  const std::vector<char>* bytes_;
  std::size_t at_ = 0;

 public:
  explicit byte_reader(const std::vector<char>& bytes) : bytes_(&bytes) {}
  template<class T>
  void get(std::vector<T>& values) {
    std::size_t count = 0;
    assert(at_ + sizeof count <= bytes_->size());
    std::memcpy(&count, bytes_->data() + at_, sizeof count);
    values.resize(count);
    at_ += sizeof count;
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), bytes_->data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
  }
};

/// MPI counts with int, so long messages are sent in pieces.
inline constexpr std::size_t longest_message = std::size_t{1} << 30;

inline void send_bytes(const std::vector<char>& bytes, int to, MPI_Comm communicator) {
  unsigned long long size = bytes.size();
  (MPI_Send)(&size, 1, MPI_UNSIGNED_LONG_LONG, to, 0, communicator);
  for (std::size_t at = 0; at < bytes.size(); at += longest_message)
    (MPI_Send)(bytes.data() + at, static_cast<int>(std::min(longest_message, bytes.size() - at)), MPI_BYTE, to, 0,
               communicator);
}

inline std::vector<char> receive_bytes(int from, MPI_Comm communicator) {
  unsigned long long size = 0;
  (MPI_Recv)(&size, 1, MPI_UNSIGNED_LONG_LONG, from, 0, communicator, MPI_STATUS_IGNORE);
  std::vector<char> bytes(size);
  for (std::size_t at = 0; at < bytes.size(); at += longest_message)
    (MPI_Recv)(bytes.data() + at, static_cast<int>(std::min(longest_message, bytes.size() - at)), MPI_BYTE, from, 0,
               communicator, MPI_STATUS_IGNORE);
  return bytes;
}

}  // namespace concino::detail
