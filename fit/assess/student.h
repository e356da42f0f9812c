// Student's t distribution, and of a variance that a few values decide.
#pragma once

#include "fit/solve/noise_shares.h"

namespace brdf::fit {

// 97.5 % quantile; infinite below one degree of freedom.
double t_quantile(double freedom);
// 97.5 % quantile of z over the root of a variance that is estimated from values with these shares of it: of
// z^2 against the weighted sum of the squares of as many independent normal numbers, by an integral over an
// angle (Craig 1991); those beside the largest are taken as equal. Student's t with the freedom of the shares
// is wider where one value outweighs many small ones, below which the variance cannot fall. To 1e-3.
double t_quantile(const NoiseShares& shares);
// P(T >= t).
double t_tail(double freedom, double t);

// By how much wider a 95 % interval is than one of a variance that is known: t_quantile() over that of
// infinitely many degrees of freedom, to 1e-4, in a few nanoseconds. 1 or more.
double widening(double freedom);

}  // namespace brdf::fit
