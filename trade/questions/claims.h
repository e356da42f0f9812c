// What the source documents claim, judged by the ledger's figures.
#pragma once

#include "trade/ledger/ledger.h"
#include "trade/questions/names.h"

namespace brdf::trade {

// The rows that every claim is judged by, the claim's own first.
std::vector<std::vector<RowName>> claim_rows();

// Claims whose rows the ledger has; the others are left out.
std::vector<Claim> judge_claims(const Ledger& ledger);

}  // namespace brdf::trade
