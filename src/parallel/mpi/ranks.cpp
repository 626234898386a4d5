// SPDX-License-Identifier: Apache-2.0
#include "parallel/ranks.hpp"

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>

namespace kerf::ranks {
namespace {

int rank_count = 1, rank_number = 0;

// MPI counts in numbers of 32 bits: longer messages go in parts.
constexpr std::size_t longest_part = std::size_t(1) << 30;

// Calls post(address, length, part) for each part of a message.
template <class Address, class Post>
void in_parts(Address* bytes, std::size_t length, const Post& post) {
  for (std::size_t done = 0, part = 0; done < length; done += longest_part, ++part)
    post(bytes + done, static_cast<int>(std::min(longest_part, length - done)),
         static_cast<int>(part));
}

std::set<std::string> environment_names() {
  std::set<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry)
    names.emplace(*entry, std::strcspn(*entry, "="));
  return names;
}

}  // namespace

// Open MPI adds variables to the environment of a process that mpirun has not started. The programs
// that it starts, such as mpirun in a job of Slurm, would take themselves for a part of its run.
Session::Session(int& argc, char**& argv) {
  const std::set<std::string> before = environment_names();
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_size(MPI_COMM_WORLD, &rank_count);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_number);
  if (rank_count > 1) return;
  for (const std::string& name : environment_names())
    if (!before.contains(name)) unsetenv(name.c_str());
}

Session::~Session() {
  MPI_Finalize();
}

int count() {
  return rank_count;
}

int number() {
  return rank_number;
}

void abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::_Exit(code);
}

void gather_from_all(const void* own, std::size_t bytes, void* all) {
  MPI_Allgather(own, static_cast<int>(bytes), MPI_BYTE, all, static_cast<int>(bytes), MPI_BYTE,
                MPI_COMM_WORLD);
}

void add_over_all(std::int64_t* values, std::size_t number) {
  MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(number), MPI_INT64_T, MPI_SUM,
                MPI_COMM_WORLD);
}

void broadcast(Bytes& bytes) {
  std::uint64_t length = bytes.size();
  MPI_Bcast(&length, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  bytes.resize(length);
  in_parts(bytes.data(), bytes.size(), [](std::byte* part, int size, int) {
    MPI_Bcast(part, size, MPI_BYTE, 0, MPI_COMM_WORLD);
  });
}

std::vector<Bytes> exchange(const std::vector<Bytes>& to) {
  std::vector<std::uint64_t> sent, received(to.size());
  for (const Bytes& message : to) sent.push_back(message.size());
  MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<Bytes> from;
  for (const std::uint64_t length : received) from.emplace_back(length);
  exchange_known(to, from);
  return from;
}

void exchange_known(const std::vector<Bytes>& to, std::vector<Bytes>& from) {
  std::vector<MPI_Request> requests;
  const auto own = static_cast<std::size_t>(rank_number);
  for (std::size_t r = 0; r < from.size(); ++r)
    if (r != own)
      in_parts(from[r].data(), from[r].size(), [&](std::byte* part, int size, int tag) {
        MPI_Irecv(part, size, MPI_BYTE, static_cast<int>(r), tag, MPI_COMM_WORLD,
                  &requests.emplace_back());
      });
  for (std::size_t r = 0; r < to.size(); ++r)
    if (r != own)
      in_parts(to[r].data(), to[r].size(), [&](const std::byte* part, int size, int tag) {
        MPI_Isend(part, size, MPI_BYTE, static_cast<int>(r), tag, MPI_COMM_WORLD,
                  &requests.emplace_back());
      });
  from[own] = to[own];
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace kerf::ranks
