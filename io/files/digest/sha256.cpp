#include "io/files/digest.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "io/files/content.h"
#include "io/files/error.h"

namespace brdf::io {
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
    if (succeeded != 1) throw EnvironmentError("OpenSSL cannot compute SHA-256");
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
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rbe"), &std::fclose);
  if (!in) cannot_be_read(file.string(), errno);
  Digest digest;
  std::vector<char> block(std::size_t{1} << 20);
  while (const std::size_t read = std::fread(block.data(), 1, block.size(), in.get()))
    digest.add({block.data(), read});
  if (std::ferror(in.get())) cannot_be_read(file.string(), errno);
  return digest.digits();
}

}  // namespace brdf::io
