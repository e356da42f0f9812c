// Detects the language of a text: the two supported languages, and languages that resemble them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::shader {

enum class Language { glsl, hlsl };

// A word, a number or one other character.
struct Token {
  std::string_view text;  // part of the text that was read
  std::uint32_t line = 1;
  bool first = false;  // first token of its line
  bool is(std::string_view word) const { return text == word; }
};
// Splits a text into tokens. `bare` is a stripped text and must outlive the tokens. `directives`: also
// return the tokens of preprocessor lines.
std::vector<Token> tokens_of(std::string_view bare, bool directives = false);

// Suffixes of shaders' files, in lower case. The suffix decides the language only if no word does.
inline constexpr std::string_view kHlslSuffixes[] = {".hlsl", ".hlsli", ".fx",   ".fxh",
                                                     ".usf",  ".ush",   ".cginc"};
inline constexpr std::string_view kOtherSuffixes[] = {".glsl", ".frag", ".vert",   ".comp", ".fs",
                                                      ".vs",   ".brdf", ".shader", ".spv"};

// Detects the language from words that only one of the two languages has, otherwise from the file's suffix
// (lower case). Engines use .fx, .shader or .txt for both languages.
Language language_of(std::string_view bare, std::string_view suffix);

// A construct of another language in a text that neither the GLSL nor the HLSL compiler accepts.
struct Foreign {
  std::string language, construct;  // "Slang", "import scene;"
  std::uint32_t line = 0;
  // A newer version of HLSL. Text that also compiles as the older version has the same meaning.
  bool newer = false;
};
// Detects another language; std::nullopt if the language is not recognised. Call this only for a text that
// does not compile, because any of these words may be a name in GLSL or HLSL. `message`: the compiler's
// message. `suffix`: of the file, in lower case; it decides if nothing else does.
std::optional<Foreign> foreign_language(std::string_view bare, std::string_view message,
                                        std::string_view suffix = "");
// Returns the sentence that rejects the text, without its place: "is Slang (`import scene;`), which is not
// read: ...".
std::string refusal_of(const Foreign& foreign);

}  // namespace brdf::shader
