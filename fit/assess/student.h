// Student's t distribution.
#pragma once

namespace brdf::fit {

// 97.5 % quantile; infinite below one degree of freedom.
double t_quantile(double freedom);
// P(T >= t).
double t_tail(double freedom, double t);

}  // namespace brdf::fit
