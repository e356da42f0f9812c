// Bytes as text: what a page holds of pictures and tables.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// RFC 4648, section 4, with its padding.
std::string base64(std::string_view bytes);

}  // namespace brdf::io
