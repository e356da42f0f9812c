// Compares this library's rule for the directional albedo with product Gauss-Legendre, adaptive cubature and
// Monte Carlo with visible normals, on the isotropic cases of `brdf validate --integrators`.
// Usage: bench_integrals [CASES] [SEED]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "bench/integrands.h"
#include "bench/machine.h"
#include "brdf/integrals.h"
#include "validate/numerics/integrators.h"

namespace {

using namespace brdf;
using namespace brdf::bench;

struct Method {
  const char* name;
  Results (*run)(const Lobe&);
};
constexpr Method kMethods[] = {{"our rule", pole_adapted},
                               {"product Gauss-Legendre", product_gauss},
                               {"adaptive cubature", adaptive_cubature},
                               {"visible-normal Monte Carlo", visible_normals}};
constexpr std::size_t kCount = std::size(kMethods);

struct Account {
  long wrong = 0;  // number of results that claimed the tolerance and missed it
  long said_so = 0;
  double evaluations = 0, seconds = 0;
};

// Runs all methods on one case in turn, starting with a different method each round. Fast methods run seven
// times, and the best time counts.
std::array<Results, kCount> interleaved(const Lobe& lobe, std::size_t number) {
  constexpr double kQuick = 2e-3;  // seconds
  std::array<Results, kCount> best;
  for (std::size_t round = 0; round < 7; ++round)
    for (std::size_t k = 0; k < kCount; ++k) {
      const std::size_t m = (k + round + number) % kCount;
      if (round > 0 && best[m].back().seconds > kQuick) continue;
      const Results now = kMethods[m].run(lobe);
      if (round == 0) {
        best[m] = now;
        continue;
      }
      for (std::size_t t = 0; t < now.size(); ++t)
        best[m][t].seconds = std::min(best[m][t].seconds, now[t].seconds);
    }
  return best;
}

void print(double tolerance, const std::array<Account, kCount>& accounts, std::size_t cases) {
  std::printf("\nrelative error %g\n%-28s %8s %8s %12s %12s %10s %10s\n", tolerance, "", "wrong", "said so",
              "evaluations", "mean us", "evals/ours", "time/ours");
  for (std::size_t m = 0; m < kCount; ++m) {
    const Account &a = accounts[m], &ours = accounts[0];
    std::printf("%-28s %8ld %8ld %12.0f %12.1f %10.1f %10.1f\n", kMethods[m].name, a.wrong, a.said_so,
                a.evaluations / double(cases), 1e6 * a.seconds / double(cases),
                a.evaluations / ours.evaluations, a.seconds / ours.seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  auto cases = validate::integral_cases("isotropic", argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  const std::size_t most = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : cases.size();
  cases.erase(cases.begin() + std::ptrdiff_t(std::min(most, cases.size())), cases.end());
  if (cases.empty()) {
    std::fprintf(stderr, "usage: bench_integrals [CASES] [SEED]\n");
    return 2;
  }
  std::printf("%s\n", machine().c_str());
  std::printf(
      "%zu isotropic cases (alpha 1e-4..1, 0..89.9 degrees), at most %ld evaluations each, one thread\n"
      "wrong: claimed and not met; said so: not met and said so\n",
      cases.size(), kMostEvaluations);
  std::array<std::array<Account, kCount>, kTolerances.size()> accounts{};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    AlbedoOptions truth_options;
    truth_options.order = 192;
    const double truth =
        directional_albedo(cases[k].term, 0, radians(cases[k].theta), {}, truth_options).value;
    const auto results = interleaved({cases[k].term, cases[k].theta}, k);
    for (std::size_t t = 0; t < kTolerances.size(); ++t)
      for (std::size_t m = 0; m < kCount; ++m) {
        const Result& r = results[m][t];
        Account& a = accounts[t][m];
        a.wrong += r.claims && !(std::abs(r.value - truth) <= (kTolerances[t] + 1e-12) * truth);
        a.said_so += !r.claims;
        a.evaluations += double(r.evaluations);
        a.seconds += r.seconds;
      }
  }
  for (std::size_t t = 0; t < kTolerances.size(); ++t) print(kTolerances[t], accounts[t], cases.size());
  const double mean = 1e6 * accounts[1][0].seconds / double(cases.size());
  std::printf("\ngoal: 1e-6 within 120 us in the mean with error control: %.1f us, %s\n", mean,
              mean <= 120 ? "met" : "not met");
  return 0;
}
