// Base64 encoding, for pictures and tables that are embedded in a page.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// Encodes bytes in Base64 with padding (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace brdf::io
