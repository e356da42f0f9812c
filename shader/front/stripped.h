// Extracts a shader's text from the bytes of a file, and removes the parts that no compiler reads.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::shader {

// Converts the bytes to text: UTF-16 becomes UTF-8, byte order marks are removed, every line ends with LF
// alone. Throws InputError if the bytes are SPIR-V or if a NUL byte remains.
std::string text_of_bytes(const std::string& name, std::string bytes);

struct Stripped {
  std::string text;                     // same length and same lines as the input
  std::vector<std::size_t> line_notes;  // positions of `//` that only blanks precede in their line
};
// Returns the text with blanks in place of comments and of the contents of quotes. A backslash at the end
// of a line continues a comment, as in compilers.
Stripped stripped(std::string_view text);

// Scripts are detected from their suffix alone (.js, .ts and similar). keep_template_literals() keeps only
// the contents of the template literals, whatever comments and quotes the literals contain; a script
// without template literals is kept completely. Throws InputError if literals are nested too deeply.
bool is_script(std::string_view suffix);
void keep_template_literals(const std::string& name, std::string& text);

// In Unity's ShaderLab (.shader) only the text between CGPROGRAM and ENDCG, or similar words, is kept,
// unless these words are in comments or quotes.
bool is_unity(std::string_view suffix);
void keep_programs(std::string& text);
// Returns whether a line consists of such a word alone, outside comments and quotes; `bare` is stripped.
bool holds_program(std::string_view bare);

}  // namespace brdf::shader
