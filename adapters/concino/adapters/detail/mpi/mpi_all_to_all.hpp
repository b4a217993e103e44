// Messages of any length from every process to every other one.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_bytes.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Sends values sent[r] to process r. Result: the values from each process. Collective.
template<class T>
  requires std::is_trivially_copyable_v<T> std::vector<std::vector<T>> all_to_all(
      MPI_Comm communicator, const std::vector<std::vector<T>>& sent) {
    std::vector<std::uint64_t> sizes(sent.size()), sizes_back(sent.size());
    for (std::size_t r = 0; r < sent.size(); ++r) sizes[r] = sent[r].size();
    (MPI_Alltoall)(sizes.data(), 1, MPI_UINT64_T, sizes_back.data(), 1, MPI_UINT64_T, communicator);
    std::vector<std::vector<T>> received(sent.size());
    on_all(communicator, [&] {
      for (std::size_t r = 0; r < sent.size(); ++r) received[r].resize(static_cast<std::size_t>(sizes_back[r]));
    });
    std::vector<MPI_Request> requests;
    for (std::size_t r = 0; r < sent.size(); ++r) {
      const std::size_t in = received[r].size() * sizeof(T), out = sent[r].size() * sizeof(T);
      for (std::size_t at = 0; at < in; at += longest_message)
        (MPI_Irecv)(reinterpret_cast<char*>(received[r].data()) + at,
                    static_cast<int>(std::min(longest_message, in - at)), MPI_BYTE, static_cast<int>(r), 2,
                    communicator, &requests.emplace_back());
      for (std::size_t at = 0; at < out; at += longest_message)
        (MPI_Isend)(reinterpret_cast<const char*>(sent[r].data()) + at,
                    static_cast<int>(std::min(longest_message, out - at)), MPI_BYTE, static_cast<int>(r), 2,
                    communicator, &requests.emplace_back());
    }
    (MPI_Waitall)(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    return received;
  }

/// The values of all processes, in the order of these, on every one. Collective.
template<class T>
std::vector<T> all_from_all(MPI_Comm communicator, const std::vector<T>& own) {
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  std::vector<T> all;
  for (const auto& values : all_to_all(communicator, std::vector<std::vector<T>>(static_cast<std::size_t>(size), own)))
    all.insert(all.end(), values.begin(), values.end());
  return all;
}

/// Replaces values[i] by its sum over all processes, which have as many values. Collective.
inline void add_over_processes(MPI_Comm communicator, std::vector<double>& values) {
  for (std::size_t at = 0; at < values.size(); at += longest_message / sizeof(double))
    (MPI_Allreduce)(MPI_IN_PLACE, values.data() + at,
                    static_cast<int>(std::min(longest_message / sizeof(double), values.size() - at)), MPI_DOUBLE,
                    MPI_SUM, communicator);
}

}  // namespace concino::detail
