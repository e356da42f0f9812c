// Student's t distribution, the distribution for a variance that a few values decide, and that of quadratic
// forms.
#pragma once

#include "fit/solve/noise_shares.h"

namespace brdf::fit {

// Returns the 97.5 % quantile. The quantile is infinite for fewer than one degree of freedom.
double t_quantile(double freedom);
// Returns the 97.5 % quantile of z over the root of a variance that is estimated from values with these
// shares of it. The distribution is that of z^2 over a weighted sum of the squares of as many independent
// normal numbers. It is computed by an integral over an angle (Craig 1991), accurate to 1e-3; the values
// other than the largest are assumed to be equal. Student's t with the degrees of freedom of the shares is
// wider if one value outweighs many small ones, because the variance cannot fall below the contribution of
// the small ones.
double t_quantile(const NoiseShares& shares);
// Returns P(T >= t).
double t_tail(double freedom, double t);

// The quadratic form d' C^-1 d of `dimension` normal differences with the covariance C, if they have the mean
// 0. It is distributed as chi-square if C is known, and as `dimension` times Fisher's F if C was estimated
// with `freedom` degrees of freedom. From 60 degrees of freedom on, C is taken as known.
// Returns the probability of a form of at least `value`.
double quadratic_tail(double value, double dimension, double freedom);
// Returns the value that the form exceeds with a probability of 5 %.
double quadratic_quantile(double dimension, double freedom);

// Returns the ratio of the width of a 95 % interval to the width for a known variance: t_quantile() divided
// by its value for infinitely many degrees of freedom. Accurate to 1e-4, takes a few nanoseconds. The
// result is at least 1.
double widening(double freedom);

}  // namespace brdf::fit
