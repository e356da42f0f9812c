// The claims of the source documents, judged by the ledger's figures.
#pragma once

#include "trade/ledger/ledger.h"
#include "trade/questions/names.h"

namespace brdf::trade {

// Returns the rows that judge each claim, with the claim's own row first.
std::vector<std::vector<RowName>> claim_rows();

// Returns the claims for which the ledger has rows. Other claims are left out.
std::vector<Claim> judge_claims(const Ledger& ledger);

}  // namespace brdf::trade
