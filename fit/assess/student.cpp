#include "fit/assess/student.h"

#include <boost/math/distributions/students_t.hpp>
#include <limits>

namespace brdf::fit {

double t_quantile(double freedom) {
  if (freedom < 1) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::students_t(freedom), 0.975);
}

double t_tail(double freedom, double t) {
  return boost::math::cdf(boost::math::complement(boost::math::students_t(freedom), t));
}

}  // namespace brdf::fit
