#include "session/joined_crew.h"

#include <sched.h>

#include <algorithm>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <thread>

#include "session/refusal.h"

namespace delos::session {
namespace {

/// A number that the launcher has set; 0 where it hasn't.
int number_of(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return 0;
}

std::unique_ptr<Crew> launched_crew() {
  // Open MPI's name, and that of MPICH and of resource managers.
  if (number_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) < 2) return nullptr;
  const std::filesystem::path module = plugin_folders().back() / "crews/mpi.so";
  if (!std::filesystem::exists(module))
    throw Refusal(Blame::question,
                  "mpirun started several processes, but Delos was built without MPI: "
                  "build it where libopenmpi-dev is installed, or search parts with "
                  "--shard");
  // Never closed: the crew's code is in it.
  static auto& library = *new boost::dll::shared_library(
      module, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  return std::unique_ptr<Crew>(library.get<Crew*()>("delos_crew")());
}

/// The cores that this process may use, divided among those of its machine that may
/// use the same.
int share_of_cores() {
  cpu_set_t mine;
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int cores =
      sched_getaffinity(0, sizeof mine, &mine) == 0 ? CPU_COUNT(&mine) : all;
  const int beside =
      std::max(1, number_of({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}));
  return std::max(1, cores < all ? cores : all / beside);
}

}  // namespace

JoinedCrew::JoinedCrew(int threads)
    : crew_(launched_crew()),
      threads_(crew_ && threads == 0 ? share_of_cores() : threads) {}

JoinedCrew::~JoinedCrew() {
  if (crew_ && crew_->rank() == 0 && !crew_->abandoned()) dismiss(*crew_);
}

bool JoinedCrew::served(PluginRegistry& plugins) const {
  if (!crew_ || crew_->rank() == 0) return false;
  serve(*crew_, plugins, threads_);
  return true;
}

}  // namespace delos::session
