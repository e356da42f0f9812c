// best SAMPLES: the canonical form that describes a sample table best, and whether the form conserves energy.
#include <cstdio>
#include <exception>

#include "brdf/fit/fit.h"
#include "brdf/io/formats/read.h"
#include "brdf/validate/form/checks.h"

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: best SAMPLES\n"), 2;
  const brdf::io::SampleTable table = brdf::io::read_samples(argv[1]);
  const brdf::fit::FitResult result = brdf::fit::fit(table, brdf::fit::canonical_models(), {});
  const brdf::fit::FormFit& best = result.ranking.front();
  std::printf("%s, median error %.3g\n", best.form.c_str(), best.median_relative_error);
  const auto subject = brdf::validate::Subject::material(argv[1], best.material);
  std::printf("energy: %s\n", check_energy(subject, {}).statement.c_str());
  return 0;
} catch (const std::exception& error) {
  return std::fprintf(stderr, "best: %s\n", error.what()), 2;
}
