#include "maps/digest.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "io/error.h"

namespace brdf::maps {
namespace {

class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_) throw std::bad_alloc();
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }

  void add(std::string_view bytes) { check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size())); }

  std::string digits() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> raw;
    unsigned size = 0;
    check(EVP_DigestFinal_ex(context_.get(), raw.data(), &size));
    std::string text;
    for (const unsigned char byte : std::span(raw).first(size))
      for (const int half : {byte >> 4, byte & 15}) text += "0123456789abcdef"[half];
    return text;
  }

 private:
  static void check(int succeeded) {
    if (succeeded != 1) throw EnvironmentError("OpenSSL computes no SHA-256");
  }

  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.digits();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  Digest digest;
  std::vector<char> block(std::size_t{1} << 20);
  while (in.read(block.data(), std::streamsize(block.size())) || in.gcount() > 0)
    digest.add({block.data(), std::size_t(in.gcount())});
  if (!in.eof()) throw InputError(file.string() + ": cannot be read");
  return digest.digits();
}

}  // namespace brdf::maps
