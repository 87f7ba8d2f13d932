// A crew of MPI's ranks, in a module of its own: the program itself needs no MPI.
#include <mpi.h>

#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "delos/api.h"
#include "delos/optimize/crew.h"

namespace delos {
namespace {

void check(int result, const char* what) {
  if (result != MPI_SUCCESS)
    throw std::runtime_error(std::string("another process is gone: ") + what +
                             " failed; run it again, studies go on where they were");
}

/// Waits without taking a core from those that work.
void finish(MPI_Request& request) {
  constexpr std::chrono::milliseconds kNap(1);
  for (int done = 0;;) {
    check(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
    if (done) return;
    std::this_thread::sleep_for(kNap);
  }
}

class MpiCrew final : public Crew {
 public:
  MpiCrew() {
    check(MPI_Init(nullptr, nullptr), "MPI_Init");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "MPI_Comm_rank");
    check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "MPI_Comm_size");
  }
  /// After a failure it ends without taking leave, once it has said why: that is how
  /// mpirun knows to end those who still wait for it.
  ~MpiCrew() override {
    if (!abandoned()) MPI_Finalize();
  }

  [[nodiscard]] std::size_t rank() const override {
    return static_cast<std::size_t>(rank_);
  }
  [[nodiscard]] std::size_t size() const override {
    return static_cast<std::size_t>(size_);
  }
  [[nodiscard]] std::string host() const override {
    char name[MPI_MAX_PROCESSOR_NAME + 1] = {};
    int length = 0;
    check(MPI_Get_processor_name(name, &length), "MPI_Get_processor_name");
    return std::string(name, static_cast<std::size_t>(length));
  }

  [[nodiscard]] std::vector<std::string> exchange(const std::string& said) override {
    const std::vector<int> lengths = lengths_of(said);
    std::vector<int> from(lengths.size());
    std::exclusive_scan(lengths.begin(), lengths.end(), from.begin(), 0);
    std::string all(static_cast<std::size_t>(from.back() + lengths.back()), '\0');
    MPI_Request request;
    check(MPI_Iallgatherv(said.data(), static_cast<int>(said.size()), MPI_BYTE,
                          all.data(), lengths.data(), from.data(), MPI_BYTE,
                          MPI_COMM_WORLD, &request),
          "MPI_Iallgatherv");
    finish(request);
    std::vector<std::string> each;
    for (std::size_t r = 0; r < lengths.size(); ++r)
      each.push_back(all.substr(static_cast<std::size_t>(from[r]),
                                static_cast<std::size_t>(lengths[r])));
    return each;
  }

 private:
  [[nodiscard]] std::vector<int> lengths_of(const std::string& said) const {
    constexpr std::size_t kMost = std::size_t{1} << 30;  // MPI counts with an int
    if (said.size() > kMost / static_cast<std::size_t>(size_))
      throw std::runtime_error(
          "the evaluations of one phase are more than MPI can send at once; search "
          "with fewer --starts");
    const int mine = static_cast<int>(said.size());
    std::vector<int> all(static_cast<std::size_t>(size_));
    MPI_Request request;
    check(MPI_Iallgather(&mine, 1, MPI_INT, all.data(), 1, MPI_INT, MPI_COMM_WORLD,
                         &request),
          "MPI_Iallgather");
    finish(request);
    return all;
  }

  int rank_ = 0, size_ = 1;
};

}  // namespace
}  // namespace delos

extern "C" DELOS_API delos::Crew* delos_crew() { return new delos::MpiCrew; }
