// The meaning of every check, for readers who do not know the checks.
#pragma once

#include <string_view>

namespace brdf::validate {

// Returns one sentence; empty if there is no such check.
std::string_view check_meaning(std::string_view check);

}  // namespace brdf::validate
