#include "shader/front/module_file.h"

#include <cstring>
#include <glslang/SPIRV/spirv.hpp>

#include "io/files/error.h"

#if __has_include(<spirv-tools/libspirv.hpp>)
#include <spirv-tools/libspirv.hpp>
#define BRDF_CHECKS_MODULES 1
#endif

namespace brdf::shader {
namespace {

constexpr std::string_view kLittle = "\x03\x02\x23\x07", kBig = "\x07\x23\x02\x03";

// Sets the language of the source to unknown. It has no effect on a module's meaning, but SPIRV-Tools refuse
// languages that are younger than themselves: Slang, WGSL, Rust.
void forget_language(std::vector<std::uint32_t>& words) {
  constexpr std::size_t kHeader = 5;
  for (std::size_t at = kHeader; at + 1 < words.size();) {
    const std::size_t count = words[at] >> spv::WordCountShift;
    if ((words[at] & spv::OpCodeMask) == spv::OpSource && count > 1)
      words[at + 1] = spv::SourceLanguageUnknown;
    if (count == 0) return;
    at += count;
  }
}

}  // namespace

bool is_module(std::string_view bytes) {
  return bytes.starts_with(kLittle) || bytes.starts_with(kBig);
}

std::vector<std::uint32_t> module_words(const std::string& name, std::string_view bytes) {
  if (bytes.size() > kLargestModule)
    throw InputError(name + ": is larger than " + std::to_string(kLargestModule >> 20) + " MiB");
  if (bytes.size() % sizeof(std::uint32_t) != 0)
    throw InputError(name + ": is SPIR-V that ends within a word: write the file again");
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  if (!words.empty() && words[0] != spv::MagicNumber)
    for (std::uint32_t& word : words) word = __builtin_bswap32(word);
  return words;
}

Translated checked_module(const Source& source, Places) {
  Translated out;
  out.spirv = source.module;
  forget_language(out.spirv);
#ifdef BRDF_CHECKS_MODULES
  spvtools::SpirvTools tools(SPV_ENV_UNIVERSAL_1_6);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
        if (out.messages.empty())
          out.messages =
              source.name + ": is not valid SPIR-V (word " + std::to_string(position.index) + "): " + message;
      });
  if (!tools.Validate(out.spirv)) {
    if (out.messages.empty()) out.messages = source.name + ": is not valid SPIR-V";
    out.spirv.clear();
    return out;
  }
#else
  out.note = "the module was not checked by the rules of SPIR-V, because this build has no SPIRV-Tools";
#endif
  return out;
}

}  // namespace brdf::shader
