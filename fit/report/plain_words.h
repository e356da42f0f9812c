// The results of a fit in plain words: the state of the fit, the most important warnings, and the names of
// its parameters.
#pragma once

#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "fit/assess/result.h"
#include "fit/report/states.h"
#include "io/page/html_report.h"

namespace brdf::fit {

// Returns the free parameters that the samples barely determine: "ks (r, g, b)", "f0 (r)". A weight or an
// angle is listed if half of its 95 % interval exceeds half of its value (and a twentieth of the
// parameter's usual range, or of the channel's weights). A parameter on a logarithmic scale is listed if
// its interval spans more than a factor of 4. If the form has lack of fit, the interval with lack of fit is
// used.
std::vector<std::string> weakly_determined(const FormFit& fit);
// Returns the same list as a clause; empty if the list is empty.
std::string weakness_text(const FormFit& fit);

// Returns the findings, conditions (fit/report/states.h), weakly determined parameters and lack of fit,
// each with its mark.
std::vector<io::Remark> remarks_on(const FormFit& fit);

// A parameter with its plain name.
struct NamedParameter {
  std::string plain;     // "surface roughness"; in a sum with the name of the form
  std::string symbol;    // name in options and JSON: alpha, kd, terms[1].ks
  std::string meaning;   // one sentence
  bool repeats = false;  // second axis of a form with equal axes, already listed
  const ParameterInfo* info = nullptr;
};
// Returns the names of the parameter of an estimate.
NamedParameter named(const FormFit& fit, const Estimate& estimate);

}  // namespace brdf::fit
