#include "io/files/address.h"

namespace brdf::io {

std::string address_of(std::string_view name) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~",
                             kDigits = "0123456789ABCDEF";
  std::string address;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (kPlain.find(c) != std::string_view::npos)
      address += c;
    else
      (((address += '%') += kDigits[byte >> 4]) += kDigits[byte & 15]);
  }
  return address;
}

}  // namespace brdf::io
