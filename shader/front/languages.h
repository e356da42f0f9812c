// Which language a text is in: the two that are read, and those that look like them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::shader {

enum class Language { glsl, hlsl };

// A word, a number or one other character, outside preprocessor lines.
struct Token {
  std::string_view text;  // of what it was read from
  std::uint32_t line = 1;
  bool first = false;  // in its line
  bool is(std::string_view word) const { return text == word; }
};
// `bare` is stripped; it must outlive the tokens. `directives`: those of preprocessor lines, too.
std::vector<Token> tokens_of(std::string_view bare, bool directives = false);

// By the words of one language alone, else by the file's suffix (small letters): engines call both kinds .fx,
// .shader or .txt.
Language language_of(std::string_view bare, std::string_view suffix);

// What of another language stands in a text that neither GLSL's nor HLSL's compiler takes.
struct Foreign {
  std::string language, construct;  // "Slang", "import scene;"
  std::uint32_t line = 0;
  bool newer = false;  // HLSL's newer version: what compiles as the older one means the same
};
// To be asked of a text that does not compile, with the compiler's message: any of these words may be a name
// in GLSL or HLSL.
// `suffix`: of the file, in small letters, which decides where nothing else does.
std::optional<Foreign> foreign_language(std::string_view bare, std::string_view message,
                                        std::string_view suffix = "");
// The sentence that refuses it, without its place: "is Slang (`import scene;`), which is not read: ...".
std::string refusal_of(const Foreign& foreign);

}  // namespace brdf::shader
