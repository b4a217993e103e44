// Which processes have polys at a vert, and ghosts of polys, where no process knows the whole mesh.
#pragma once

#include <concino/adapters/detail/distributed/distributed_graph.hpp>
#include <concino/adapters/detail/distributed/distributed_records.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/detail/mpi/mpi_bytes.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Sends polys to other processes: sent[r] are the places of those for process r. Result: all that this process gets,
/// from each process. Collective.
inline std::vector<poly_records> send_records(MPI_Comm communicator, const poly_records& own,
                                              const std::vector<std::vector<std::size_t>>& sent, bool has_faces) {
  std::vector<std::vector<char>> messages(sent.size());
  on_all(communicator, [&] {
    for (std::size_t r = 0; r < sent.size(); ++r) {
      if (sent[r].empty()) continue;
      byte_writer writer;
      selected_records(own, sent[r], has_faces).for_each_array([&](const auto& array) { writer.put(array); });
      messages[r] = writer.bytes();
    }
  });
  messages = all_to_all(communicator, messages);
  std::vector<poly_records> received;
  on_all(communicator, [&] {
    for (std::vector<char>& bytes : messages) {
      if (bytes.empty()) continue;
      byte_reader reader(bytes);
      received.emplace_back().for_each_array([&](auto& array) { reader.get(array); });
      std::vector<char>().swap(bytes);
    }
  });
  return received;
}

/// The processes that have a poly at each of the verts of this process, and on the first one all verts of no poly.
struct shared_verts {
  std::vector<std::size_t> ends;
  std::vector<int> processes;  // of each vert, increasing, this one too
  std::vector<std::uint64_t> unused;
};

/// The verts from first to last - 1 that are not in a sorted list.
inline std::vector<std::uint64_t> unused_verts(const std::vector<std::pair<std::uint64_t, int>>& used,
                                               std::uint64_t first, std::uint64_t last) {
  std::vector<std::uint64_t> r;
  for (const auto& [v, process] : used) {
    for (; first < v; ++first) r.push_back(first);
    first = v + 1;
  }
  for (; first < last; ++first) r.push_back(first);
  return r;
}

/// Every process asks others about its verts, whose numbers are below vert_bound: each of these answers for a range of
/// numbers. Collective.
inline shared_verts share_verts(MPI_Comm communicator, const std::vector<std::uint64_t>& verts,
                                std::uint64_t vert_bound) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  const auto processes = static_cast<std::size_t>(size);
  std::vector<std::vector<std::uint64_t>> questions(processes);
  on_all(communicator, [&] {
    for (const std::uint64_t v : verts) questions[process_of_vert(v, vert_bound, processes)].push_back(v);
  });
  auto asked = all_to_all(communicator, questions);
  questions.clear();
  std::vector<std::vector<int>> answers(processes);  // for each vert how many processes, and these
  std::vector<std::vector<std::uint64_t>> unused(processes);
  on_all(communicator, [&] {
    std::vector<std::pair<std::uint64_t, int>> who;  // the verts of the range, and each process that asks
    for (std::size_t r = 0; r < processes; ++r)
      for (const std::uint64_t v : asked[r]) who.emplace_back(v, static_cast<int>(r));
    asked.clear();
    std::sort(who.begin(), who.end());
    for (std::size_t begin = 0, end; begin < who.size(); begin = end) {
      for (end = begin; end < who.size() && who[end].first == who[begin].first;) ++end;
      for (std::size_t k = begin; k < end; ++k) {
        auto& answer = answers[static_cast<std::size_t>(who[k].second)];
        answer.push_back(static_cast<int>(end - begin));
        for (std::size_t j = begin; j < end; ++j) answer.push_back(who[j].second);
      }
    }
    const auto [first, last] = verts_of_process(static_cast<std::uint64_t>(rank), vert_bound, processes);
    unused[0] = unused_verts(who, first, last);
  });
  const auto answered = all_to_all(communicator, answers);  // in the order of the verts, as ranges increase
  unused = all_to_all(communicator, unused);
  shared_verts r;
  on_all(communicator, [&] {
    for (const auto& some : unused) r.unused.insert(r.unused.end(), some.begin(), some.end());
    for (const auto& answer : answered)
      for (std::size_t at = 0; at < answer.size();) {
        for (int n = answer[at++]; n > 0; --n) r.processes.push_back(answer[at++]);
        r.ends.push_back(r.processes.size());
      }
  });
  return r;
}

/// Adds the polys of other processes that share a vert with one of these. All polys are owned by this process at first.
/// Verts get owners. The first process gets the numbers of all verts of no poly. Collective.
inline poly_records with_ghosts(MPI_Comm communicator, poly_records own, std::uint64_t vert_bound, bool has_faces,
                                std::vector<std::uint64_t>& unused) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  shared_verts shared = share_verts(communicator, own.vert_numbers, vert_bound);
  std::vector<std::vector<std::size_t>> sent(static_cast<std::size_t>(size));
  on_all(communicator, [&] {
    unused = std::move(shared.unused);
    own.poly_owners.assign(own.num_polys(), rank);
    own.vert_owners.clear();
    for (std::size_t v = 0; v < shared.ends.size(); ++v)
      own.vert_owners.push_back(shared.processes[v == 0 ? 0 : shared.ends[v - 1]]);
    for (std::size_t p = 0; p < own.num_polys(); ++p)
      own.for_each_vert(p, has_faces, [&](std::uint32_t v) {
        for (std::size_t k = v == 0 ? 0 : shared.ends[v - 1]; k < shared.ends[v]; ++k) {
          auto& list = sent[static_cast<std::size_t>(shared.processes[k])];
          if (shared.processes[k] != rank && (list.empty() || list.back() != p)) list.push_back(p);
        }
      });
  });
  std::vector<poly_records> parts = send_records(communicator, own, sent, has_faces);
  on_all(communicator, [&] {
    shared = {}, sent.clear();
    parts.push_back(std::move(own));
    own = merged_records(std::move(parts), has_faces);
  });
  return own;
}

}  // namespace concino::detail
