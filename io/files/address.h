// Addresses beside a page, as it links to them.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// A name of a file or folder as part of a relative address: what has a meaning there is percent-encoded (RFC
// 3986).
std::string address_of(std::string_view name);

}  // namespace brdf::io
