// The consensus of laboratories that measured one quantity (Mandel and Paule 1970; Paule and Mandel 1982).
#pragma once

#include <span>
#include <vector>

namespace brdf::fit {

// The value of one laboratory with its standard uncertainty, in the same unit.
struct LaboratoryValue {
  double value, uncertainty;
};

// The degree of equivalence of a laboratory: its value minus the consensus, with the standard uncertainty of
// the difference.
struct Equivalence {
  double difference, uncertainty;
  // Returns whether the difference is above twice its standard uncertainty.
  bool is_far() const { return difference > 2 * uncertainty || difference < -2 * uncertainty; }
};

struct Consensus {
  double value = 0, uncertainty = 0;  // with the standard uncertainty
  double half_width = 0;              // of the 95 % interval: the uncertainty times Student's t
  // The standard deviation between laboratories, beyond their own uncertainties; 0 if these are enough.
  double between = 0;
  // The sum of the squared deviations from the mean that is weighted by the laboratories' own uncertainties,
  // each in units of this uncertainty, and the probability of a sum at least as large by chance.
  double chi_square = 0, probability = 1;
  std::vector<Equivalence> degrees;  // [laboratory]
};

// Returns the consensus of at least two laboratories with independent errors. The mean is weighted by
// 1/(u_j^2 + tau^2), with the least tau for which the weighted squared deviations add up to at most n - 1.
// The interval uses Student's t with n - 1 degrees of freedom: with 1.96 it would hold the truth in 86 to
// 91 % instead of 95 % if tau is as large as the uncertainties. Throws std::logic_error for fewer than two
// values, or for an uncertainty that is not above 0.
Consensus consensus_of(std::span<const LaboratoryValue> values);

}  // namespace brdf::fit
