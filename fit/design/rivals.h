// Directions that distinguish one fitted model from another.
#pragma once

#include "fit/design/design_rows.h"

namespace brdf::fit {

// The further readings that distinguish two models (T-optimal; Atkinson and Fedorov 1975). Each model is once
// taken for true, at its fitted values, and the other is refitted in first order to the measured rows and to
// the values of the true one at the rows read so far. The gain of a candidate is the expected rise of the
// logarithm of the likelihood ratio by a reading there, after this refit, averaged over the two cases.
class Rivals {
 public:
  // Both models with the rows of the same directions. `noise`: relative, of one reading.
  Rivals(const DesignRows& start_a, const DesignRows& candidates_a, const DesignRows& hemisphere_a,
         const DesignRows& start_b, const DesignRows& candidates_b, const DesignRows& hemisphere_b,
         double noise);

  // Returns the gain of every candidate.
  std::vector<double> gains() const;
  // Returns ln of the first model over the second one, refitted to the first, at a candidate: the largest by
  // size over the channels.
  double difference(std::size_t candidate) const;
  // Takes a reading at a candidate into account.
  void read(std::size_t candidate);

 private:
  // The model that is refitted, its information, and ln of the true model minus ln of this one, [channel].
  struct Refitted {
    const DesignRows* candidates;
    RowMatrix information;
    std::vector<Eigen::VectorXd> difference;
  };
  double noise_variance_;
  std::array<Refitted, 2> models_;
};

}  // namespace brdf::fit
