// Prints the verdicts and parameters of all forms fitted to the tables of the arguments. A program for
// another processor must print the same numbers within the bound of aarch64_test.py.
#include <cstdio>

#include "fit/choice.h"
#include "fit/fit.h"
#include "io/formats/read.h"

int main(int count, char** names) {
  using namespace brdf;
  for (int k = 1; k < count; ++k) {
    fit::FitOptions options;
    options.metric = fit::Metric::automatic;
    const fit::Samples samples = fit::arranged(io::read_samples(names[k]), options);
    for (const fit::FormFit& form : fit::fit(samples, fit::models_of("all"), options).ranking) {
      std::printf("%s %s %s", names[k], form.form.c_str(), std::string(name_of(form.verdict)).c_str());
      for (const fit::Estimate& e : form.estimates) std::printf(" %.17g", e.value);
      std::printf("\n");
    }
  }
}
