// Relative addresses, as pages use them to link to neighbouring files.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// Returns the name of a file or folder as a segment of a relative address. Every byte except the unreserved
// characters of RFC 3986 is percent-encoded.
std::string address_of(std::string_view name);

}  // namespace brdf::io
