// SHA-256 (FIPS 180-4) by OpenSSL, in hexadecimal digits, as sha256sum prints it. In the library brdf_digest,
// apart from brdf_io, whose users need no OpenSSL.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace brdf::io {

std::string sha256(std::string_view bytes);
// Of a file of any length. Throws InputError where it cannot be opened, EnvironmentError where the machine
// fails.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace brdf::io
