// What every check asks, for readers who know none of them.
#pragma once

#include <string_view>

namespace brdf::validate {

// One sentence; empty where there is no such check.
std::string_view check_meaning(std::string_view check);

}  // namespace brdf::validate
