// Probabilities of the tests of a sampler.
#pragma once

namespace brdf::validate {

// Returns the probability that a standard normal variate is beyond z on either side.
double two_sided_tail(double z);
// Returns the z with this two-sided probability, for 0 < probability < 1.
double two_sided_quantile(double probability);
// Returns the probability that a chi-square variate with this many degrees of freedom exceeds x. Relative
// accuracy 1e-10 down to 1e-200.
double chi_square_tail(double x, double degrees_of_freedom);
// Returns the probability of a count at least as far from `mean` in its own direction as `count`, for a
// Poisson variate, times two.
double poisson_two_sided(double count, double mean);

// Returns the level of each of `tests` independent tests, if one of them may fail by chance with probability
// `overall` (Sidak 1967).
double sidak(double overall, int tests);

}  // namespace brdf::validate
