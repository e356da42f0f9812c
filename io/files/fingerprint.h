// A short hash that identifies the inputs of a result.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace brdf::io {

// Returns the 64-bit FNV-1a hash (Fowler, Noll and Vo) of the concatenated texts in hexadecimal digits. The
// hash detects changes. It gives no protection against texts that were constructed to collide.
std::string fingerprint(std::initializer_list<std::string_view> texts);

}  // namespace brdf::io
