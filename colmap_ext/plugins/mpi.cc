// SPDX-License-Identifier: BSD-3-Clause
// The plug-in limn_mpi: ranks, by Boost.MPI.
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <boost/dll/alias.hpp>
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/collectives/all_gatherv.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include "colmap_ext/host/mpi_backend.h"

namespace limn::colmap_ext {
namespace {

class BoostMpi : public MpiBackend {
 public:
  // Only the main thread speaks with other ranks. Exceptions are dealt with by main.
  BoostMpi() : environment_(boost::mpi::threading::funneled, /*abort_on_exception=*/false) {}

  int Rank() const override { return world_.rank(); }
  int Size() const override { return world_.size(); }
  std::string HostName() const override { return boost::mpi::environment::processor_name(); }

  int Broadcast(int value) const override {
    boost::mpi::broadcast(world_, value, 0);
    return value;
  }

  std::vector<std::string> Gather(const std::string& mine) const override {
    std::vector<int> sizes;
    boost::mpi::all_gather(world_, static_cast<int>(mine.size()), sizes);
    std::string all(std::accumulate(sizes.begin(), sizes.end(), size_t{0}), '\0');
    boost::mpi::all_gatherv(world_, mine.data(), all.data(), sizes);
    std::vector<std::string> of_ranks;
    for (size_t begin = 0; const int size : sizes) {
      of_ranks.push_back(all.substr(begin, size));
      begin += size;
    }
    return of_ranks;
  }

  void Wait() const override { world_.barrier(); }
  void Abort(int exit_code) const override { boost::mpi::environment::abort(exit_code); }

 private:
  boost::mpi::environment environment_;
  boost::mpi::communicator world_;
};

std::unique_ptr<MpiBackend> MakeMpi() { return std::make_unique<BoostMpi>(); }

}  // namespace
}  // namespace limn::colmap_ext

BOOST_DLL_ALIAS(limn::colmap_ext::MakeMpi, limn_make_mpi)
