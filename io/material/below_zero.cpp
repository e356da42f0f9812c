#include "io/material/below_zero.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brdf/least_of_matt.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::io {

void require_not_below_zero(const Material& material, const std::string& name) {
  const auto angle = [](const Vec3<double>& w) {
    return short_number(radians(std::acos(std::clamp(w.z, 0.0, 1.0))).degrees(), 3);
  };
  std::vector<double> f(material.channels.size());
  for (const Term& term : material.terms)
    for (std::size_t c = 0; c < f.size() && info(term.form).basis; ++c) {
      const LeastOfMatt least = least_of_matt(*info(term.form).basis, term.weights[c], 0);
      if (!(least.value < 0)) continue;
      eval(material, least.wi, least.wo, f);
      if (f[c] < 0)
        throw InputError(name + ": f is " + short_number(f[c], 3) + " /sr in channel " +
                         material.channels[c] + " at theta_i " + angle(least.wi) + " and theta_o " +
                         angle(least.wo) +
                         " degrees, and must not be below 0: fit the weights with `brdf fit`, which bounds "
                         "them");
    }
}

}  // namespace brdf::io
