// Round robins: the consensus of laboratories that measured the same surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/between/mandel_paule.h"
#include "fit/between/quantities.h"
#include "fit/between/tables.h"

namespace brdf::fit {

// One quantity in all laboratories.
struct RoundRobinQuantity {
  std::string name;                     // alpha, kd[r], f(0:45), albedo(8)
  bool logarithmic = true;              // uncertainties and differences are relative
  std::vector<double> natural;          // [laboratory] in the quantity's own unit
  std::vector<LaboratoryValue> values;  // [laboratory] on the scale of the uncertainty
  std::optional<Consensus> consensus;   // on this scale
  std::string obstacle;                 // the reason why there is no consensus; empty if there is one

  // Returns the consensus, or an end of its 95 % interval (side -1 or 1), in the quantity's own unit.
  double consensus_value(int side = 0) const;
};

struct RoundRobin {
  FittedTables fits;
  std::vector<RoundRobinQuantity> quantities;  // the asked quantities, then the parameters

  // Returns whether every quantity has a consensus.
  bool is_decided() const;
};

// The quantities that follow from the parameters.
struct AskedQuantities {
  std::vector<AskedDirections> at;  // of f
  std::vector<double> albedo;       // polar angles of incidence of the directional albedo, degrees
};
// Compares fits of at least two laboratories. Their errors are taken as independent.
RoundRobin round_robin(FittedTables fits, const AskedQuantities& asked);

}  // namespace brdf::fit
