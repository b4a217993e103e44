// Values of ghosts: from the processes that own them, and back.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Which local elements a process sends to which other one, and which it receives. Made once for verts and once for
/// polys. Collective.
class ghost_exchange {
  struct partner {
    int rank;
    std::vector<std::size_t> indices;
  };
  std::vector<partner> owned_, ghosts_;  // copies of owned elements elsewhere; own copies of elements elsewhere
  MPI_Comm communicator_ = MPI_COMM_SELF;

  /// Sends values of the elements of `from`, of `size` bytes each, and calls take(index, value) for those of `to`.
  template<class Take>
  void move(const std::vector<partner>& from, const std::vector<partner>& to, const char* values, std::size_t size,
            const Take& take) const {
    std::vector<std::vector<char>> sent(from.size()), received(to.size());
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < to.size(); ++k) {
      received[k].resize(to[k].indices.size() * size);
      (MPI_Irecv)(received[k].data(), static_cast<int>(received[k].size()), MPI_BYTE, to[k].rank, 1, communicator_,
                  &requests.emplace_back());
    }
    for (std::size_t k = 0; k < from.size(); ++k) {
      sent[k].reserve(from[k].indices.size() * size);
      for (const std::size_t i : from[k].indices)
        sent[k].insert(sent[k].end(), values + i * size, values + (i + 1) * size);
      (MPI_Isend)(sent[k].data(), static_cast<int>(sent[k].size()), MPI_BYTE, from[k].rank, 1, communicator_,
                  &requests.emplace_back());
    }
    (MPI_Waitall)(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    for (std::size_t k = 0; k < to.size(); ++k)
      for (std::size_t j = 0; j < to[k].indices.size(); ++j) take(to[k].indices[j], received[k].data() + j * size);
  }

 public:
  ghost_exchange() = default;

  /// global: the numbers of local elements; owner: their processes; local(global number): the index of an own element.
  template<class LocalOf>
  ghost_exchange(MPI_Comm communicator, const std::vector<std::uint64_t>& global, const std::vector<int>& owner,
                 const LocalOf& local)
      : communicator_(communicator) {
    int size = 1, rank = 0;
    (MPI_Comm_size)(communicator, &size);
    (MPI_Comm_rank)(communicator, &rank);
    const auto processes = static_cast<std::size_t>(size);
    std::vector<std::vector<std::size_t>> wanted(processes);
    for (std::size_t i = 0; i < owner.size(); ++i)
      if (owner[i] != rank) wanted[static_cast<std::size_t>(owner[i])].push_back(i);
    std::vector<int> counts(processes), counts_back(processes), starts(processes), starts_back(processes);
    std::vector<std::uint64_t> numbers;
    for (std::size_t r = 0; r < processes; ++r) {
      counts[r] = static_cast<int>(wanted[r].size());
      starts[r] = static_cast<int>(numbers.size());
      for (const std::size_t i : wanted[r]) numbers.push_back(global[i]);
      if (!wanted[r].empty()) ghosts_.push_back({static_cast<int>(r), wanted[r]});
    }
    (MPI_Alltoall)(counts.data(), 1, MPI_INT, counts_back.data(), 1, MPI_INT, communicator);
    int total = 0;
    for (std::size_t r = 0; r < processes; ++r) {
      starts_back[r] = total;
      total += counts_back[r];
    }
    std::vector<std::uint64_t> asked(static_cast<std::size_t>(total));
    (MPI_Alltoallv)(numbers.data(), counts.data(), starts.data(), MPI_UINT64_T, asked.data(), counts_back.data(),
                    starts_back.data(), MPI_UINT64_T, communicator);
    for (std::size_t r = 0; r < processes; ++r) {
      if (counts_back[r] == 0) continue;
      owned_.push_back({static_cast<int>(r), {}});
      for (int k = 0; k < counts_back[r]; ++k)
        owned_.back().indices.push_back(local(asked[static_cast<std::size_t>(starts_back[r] + k)]));
    }
  }

  /// Copies the values of owned elements, of `size` bytes each, to their ghosts.
  void to_ghosts(void* values, std::size_t size) const {
    char* const bytes = static_cast<char*>(values);
    move(owned_, ghosts_, bytes, size,
         [&](std::size_t i, const char* value) { std::memcpy(bytes + i * size, value, size); });
  }
  template<class T>
  void to_ghosts(T* values) const {
    static_assert(std::is_trivially_copyable_v<T>);
    to_ghosts(values, sizeof(T));
  }
  /// Calls combine(values[i] of the owner, values[i] of a ghost) for all ghosts, in the order of their processes.
  template<class T, class Combine>
  void to_owners(T* values, const Combine& combine) const {
    static_assert(std::is_trivially_copyable_v<T>);
    move(ghosts_, owned_, reinterpret_cast<const char*>(values), sizeof(T), [&](std::size_t i, const char* value) {
      T x;
      std::memcpy(&x, value, sizeof x);
      combine(values[i], x);
    });
  }
};

}  // namespace concino::detail
