// What the source documents claim, judged by the ledger's figures.
#pragma once

#include "trade/ledger/ledger.h"
#include "trade/questions/names.h"

namespace brdf::trade {

using ClaimRows = std::vector<const LedgerRow*>;

struct ClaimRule {
  // The figure that decides, and words for the evidence.
  struct Found {
    double figure;
    std::string words = {};
  };
  struct Below {
    double bound;
    const char* verdict;
  };
  const char *source, *claim;
  std::vector<RowName> rows;  // the first is the claim's
  Found (*find)(const ClaimRows& rows, const Ledger& ledger);
  std::vector<Below> below;  // the first bound above the figure gives the verdict
  const char* otherwise;
  // {figure}, {words}, and of the first row {cost}, {ms}, {max}, {mean}, {image}, {where}, {note}; of the
  // second {cost 1}, ...
  const char* evidence;
};
const std::vector<ClaimRule>& claim_rules();

// Claims whose rows the ledger has; the others are left out.
std::vector<Claim> judge_claims(const Ledger& ledger);

}  // namespace brdf::trade
