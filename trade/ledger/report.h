// The ledger as a page: claims, fronts with plots, extremes.
#pragma once

#include <string>

#include "trade/ledger/ledger.h"

namespace brdf::trade {

std::string to_html(const Ledger& ledger);

}  // namespace brdf::trade
