// The covariance of 10⁵ filtered runs of each linear system beside P∞, as the table of
// docs/simulation.md. bench_linear_runs [RUNS [NAME]]
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "simulation/linear_systems.h"

int main(int argc, char** argv) {
  using namespace delos::test;
  const int runs = argc > 1 ? std::atoi(argv[1]) : 100000;
  std::cout << "| system | covariance | √tr P measured/predicted | entries | largest "
               "deviation [its standard error] | χ² (degrees) | NEES (states; band) |\n"
               "|---|---|---|---|---|---|---|\n";
  for (const LinearCase& of : linear_cases()) {
    if (argc > 2 && of.name != argv[2]) continue;
    const delos::Simulation s =
        simulate(of.system, kOrigin, {.runs = runs, .seed = 1, .seconds = of.seconds});
    const delos::Consistency& nees = s.instants.back().nees;
    for (const delos::SimulatedCovariance& c : s.covariances) {
      const CovarianceFit fit = covariance_fit(c, s.runs - s.lost);
      std::cout << "| " << of.name << " | " << c.name << " | " << std::fixed
                << std::setprecision(5)
                << std::sqrt(c.measured.trace() / c.predicted.trace()) << " | "
                << std::setprecision(0) << fit.degrees << " | " << std::setprecision(2)
                << fit.largest << " | ";
      const bool instant = c.name != "average" && of.name != "sequential";
      if (instant || c.name == "worst prior" || c.name == "best posterior")
        std::cout << std::setprecision(1) << fit.chi_squared << " ("
                  << std::setprecision(0) << fit.degrees << ")";
      else
        std::cout << "–";
      std::cout << " | " << std::setprecision(3) << nees.mean << " ("
                << std::setprecision(0) << nees.expected << "; " << std::setprecision(3)
                << nees.lower << " to " << nees.upper << ") |" << std::endl;
    }
  }
}
