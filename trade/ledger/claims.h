// What the source documents claim, judged by the ledger's figures.
#pragma once

#include "trade/ledger/ledger.h"

namespace brdf::trade {

// Claims whose rows the ledger has; the others are left out.
std::vector<Claim> judge_claims(const Ledger& ledger);

}  // namespace brdf::trade
