// What a fit found, in words for people: how it stands, what must be known at once, what its parameters are
// called.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "fit/assess/result.h"
#include "fit/report/states.h"
#include "io/page/html_report.h"

namespace brdf::fit {

// "ks (r, g, b)", "f0 (r)": free parameters that the samples leave wide open. Of a weight or an angle half of
// the 95 % interval is beyond half of the value (and a twentieth of the parameter's usual range, or of the
// channel's weights); a parameter on a logarithmic scale varies by more than a factor of 4. Where the form
// lacks something, the interval is the one with lack of fit.
std::vector<std::string> weakly_determined(const FormFit& fit);
// The same as a clause; empty where there is none.
std::string weakness_text(const FormFit& fit);

// Findings, conditions (fit/report/states.h), weak parameters and lack of fit, each with its mark.
std::vector<io::Remark> remarks_on(const FormFit& fit);

// A parameter as people know it.
struct NamedParameter {
  std::string plain;     // "surface roughness", in a sum with the form
  std::string symbol;    // as options and JSON name it: alpha, kd, terms[1].ks
  std::string meaning;   // one sentence
  bool repeats = false;  // the second axis of a form whose axes have one value: said already
  const ParameterInfo* info = nullptr;
};
NamedParameter named(const FormFit& fit, const Estimate& estimate);

}  // namespace brdf::fit
