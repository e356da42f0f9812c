// What of a file's bytes is a shader's text, and that text without what no compiler reads.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::shader {

// The bytes as text: UTF-16 becomes UTF-8, byte order marks are taken away, every line ends with LF alone.
// Throws InputError where a NUL byte remains.
std::string text_of_bytes(const std::string& name, std::string bytes);

struct Stripped {
  std::string text;                     // as long as the whole, and its lines stay
  std::vector<std::size_t> line_notes;  // where a `//` begins that nothing but blanks stands before
};
// Blanks in the place of comments and of what stands in quotes. A backslash at a line's end continues a
// comment, as compilers have it.
Stripped stripped(std::string_view text);

// Scripts are told by their suffix alone (.js, .ts and their like): of one what stands in its template
// literals is kept, whatever its comments and quotes hold; of one without any, all. Throws InputError where
// literals are nested too deeply.
bool is_script(std::string_view suffix);
void keep_template_literals(const std::string& name, std::string& text);

// Of Unity's ShaderLab (.shader) what stands between CGPROGRAM and ENDCG or their like is kept, outside
// comments and quotes.
bool is_unity(std::string_view suffix);
void keep_programs(std::string& text);
// Whether a line holds such a word and nothing else, outside comments and quotes; `bare` is stripped.
bool holds_program(std::string_view bare);

}  // namespace brdf::shader
