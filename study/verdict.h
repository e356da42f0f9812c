// What a study says first: how good the best form is, in a sentence, and what a reader must know beside it.
#pragma once

#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "io/html_report.h"

namespace brdf::study {

struct Judgement {
  io::Mark mark = io::Mark::bad;
  std::string sentence;
  std::vector<std::string>
      warnings;  // what the fit found (energy), weakly determined parameters, lack of fit, faults of the samples
};

// Good where the fit converged, describes the samples to within their scatter, keeps energy and every parameter is
// determined; a warning where it can be used in spite of one of these.
Judgement judge(const fit::FitResult& result);

// The free parameters whose 95 % interval, with lack of fit where that is known, reaches over more than a factor of
// three and more than a twentieth of 1, each with its channels: "ks (r, g)".
std::vector<std::string> weakly_determined(const fit::FormFit& fit);

}  // namespace brdf::study
