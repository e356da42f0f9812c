#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// What to write instead of a field that is no finite number, as the end of a message: "; write no row where
// nothing was measured". Empty where it looks like nothing known.
std::string advice_on(std::string_view field);

}  // namespace brdf::io
