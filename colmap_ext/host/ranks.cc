#include "colmap_ext/host/ranks.h"

#include <cstdlib>
#include <stdexcept>

#include "colmap_ext/host/interrupt.h"
#include "limn/util/errors.h"

#ifdef LIMN_WITH_MPI
#include <algorithm>
#include <memory>
#include <numeric>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/collectives/all_gatherv.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#endif

namespace limn::colmap_ext {
namespace {

// By Open MPI's mpirun, by others with PMI, or by srun.
bool IsStartedByMpi() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
}

#ifdef LIMN_WITH_MPI
std::unique_ptr<boost::mpi::environment>& Environment() {
  static std::unique_ptr<boost::mpi::environment> environment;
  return environment;
}
#endif

}  // namespace

#ifdef LIMN_WITH_MPI

MpiSession::MpiSession() {
  // Only the main thread speaks with other ranks. Exceptions are dealt with by main.
  if (IsStartedByMpi()) {
    const InterruptsBlocked in_its_threads;
    Environment() = std::make_unique<boost::mpi::environment>(boost::mpi::threading::funneled,
                                                              /*abort_on_exception=*/false);
  }
}
MpiSession::~MpiSession() { Environment().reset(); }

int Rank() { return Environment() ? boost::mpi::communicator().rank() : 0; }
int NumRanks() { return Environment() ? boost::mpi::communicator().size() : 1; }

static void MeetOtherRanks(const std::string& error) {
  const std::string place =
      "rank " + std::to_string(Rank()) + " on " + boost::mpi::environment::processor_name() + ": ";
  const auto errors = RankTeam().Exchange(error.empty() ? "" : place + error);
  const auto first = std::find_if(errors.begin(), errors.end(),
                                  [](const std::string& text) { return !text.empty(); });
  if (first == errors.end()) return;
  if (Rank() == 0) throw std::runtime_error(*first);
  boost::mpi::communicator().barrier();  // which rank 0 never enters
}

// What rank 0 sends, on every rank.
static RankOrder OrderOfRankZero(RankOrder sent) {
  int order = static_cast<int>(sent);
  if (NumRanks() > 1) boost::mpi::broadcast(boost::mpi::communicator(), order, 0);
  return static_cast<RankOrder>(order);
}
void TellOtherRanks(RankOrder order) { OrderOfRankZero(order); }
RankOrder WaitForRankZero() { return OrderOfRankZero(RankOrder::kEnd); }

std::vector<std::string> RankTeam::Exchange(const std::string& mine) {
  const boost::mpi::communicator ranks;
  std::vector<int> sizes;
  boost::mpi::all_gather(ranks, static_cast<int>(mine.size()), sizes);
  std::string all(std::accumulate(sizes.begin(), sizes.end(), size_t{0}), '\0');
  boost::mpi::all_gatherv(ranks, mine.data(), all.data(), sizes);
  bytes_exchanged_ += all.size() * (sizes.size() - 1);
  std::vector<std::string> of_ranks;
  for (size_t begin = 0; const int size : sizes) {
    of_ranks.push_back(all.substr(begin, size));
    begin += size;
  }
  return of_ranks;
}

void AbortRanks(int exit_code) {
  if (NumRanks() > 1) boost::mpi::environment::abort(exit_code);
}

#else

MpiSession::MpiSession() {
  if (IsStartedByMpi()) {
    throw OptionError(
        "started by mpirun or srun, but built without MPI: build with "
        "-DLIMN_WITH_MPI=ON, or start shards (--shard i/n)");
  }
}
MpiSession::~MpiSession() = default;

int Rank() { return 0; }
int NumRanks() { return 1; }
static void MeetOtherRanks(const std::string&) {}
void TellOtherRanks(RankOrder) {}
RankOrder WaitForRankZero() { return RankOrder::kEnd; }
std::vector<std::string> RankTeam::Exchange(const std::string& mine) { return {mine}; }
void AbortRanks(int) {}

#endif

void MeetAllRanks(const std::string& error) {
  if (NumRanks() > 1) return MeetOtherRanks(error);
  if (!error.empty()) throw std::runtime_error(error);
}

int RankTeam::Rank() const { return colmap_ext::Rank(); }
int RankTeam::Size() const { return NumRanks(); }

}  // namespace limn::colmap_ext
