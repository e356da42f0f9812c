// SHA-256 (FIPS 180-4), computed by OpenSSL and returned in hexadecimal digits as sha256sum prints them.
// These functions form the library brdf_digest, separate from brdf_io, so that users of brdf_io do not need
// OpenSSL.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace brdf::io {

// Returns the SHA-256 of `bytes`.
std::string sha256(std::string_view bytes);
// Returns the SHA-256 of a file of any length. Throws InputError if the file cannot be opened,
// EnvironmentError if the machine fails.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace brdf::io
