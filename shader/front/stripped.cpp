#include "shader/front/stripped.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

using Part = std::pair<std::size_t, std::size_t>;

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t k = begin; k < end && k < text.size(); ++k)
    if (text[k] != '\n') text[k] = ' ';
}

// Replaces all characters outside the parts by blanks; line breaks are kept. The parts are in order.
void keep_parts(std::string& text, const std::vector<Part>& parts) {
  std::size_t at = 0;
  for (const auto& [begin, end] : parts) {
    blank(text, at, begin);
    at = std::max(at, end);
  }
  blank(text, at, text.size());
}

// The end of a comment that begins at `at` with two slashes. If `continues`, a backslash at the end of a
// line continues the comment.
std::size_t end_of_line_comment(std::string_view text, std::size_t at, bool continues) {
  for (;;) {
    const std::size_t stop = std::min(text.find('\n', at), text.size());
    if (!continues || stop == text.size() || text[stop - 1] != '\\') return stop;
    at = stop + 1;
  }
}

std::size_t end_of_block_comment(std::string_view text, std::size_t at) {
  const std::size_t stop = text.find("*/", at + 2);
  return stop == text.npos ? text.size() : stop + 2;
}

// The position of the closing quote, or of the end of the line if there is no closing quote.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (std::size_t k = at + 1; k < text.size(); ++k) {
    if (text[k] == quote || text[k] == '\n') return k;
    if (text[k] == '\\' && k + 1 < text.size()) ++k;
  }
  return text.size();
}

// Finds the template literals of a script; its other text is not part of a shader.
class Script {
 public:
  Script(const std::string& name, std::string& text) : name_(name), text_(text) {}

  std::vector<Part> literals() {
    code(0, 0);
    return std::move(parts_);
  }

 private:
  static constexpr int kDeepest = 100;

  // Returns whether a slash at this position begins a regular expression, which is the case if no value
  // precedes it.
  bool is_expression(std::size_t at) const {
    while (at > 0 && (text_[at - 1] == ' ' || text_[at - 1] == '\t' || text_[at - 1] == '\n')) --at;
    return at == 0 || std::string_view("(,=:[!&|?{};+-*%<>~^").find(text_[at - 1]) != std::string_view::npos;
  }
  std::size_t end_of_expression(std::size_t at) const {
    bool in_class = false;
    for (std::size_t k = at + 1; k < text_.size() && text_[k] != '\n'; ++k) {
      if (text_[k] == '\\')
        ++k;
      else if (text_[k] == '[')
        in_class = true;
      else if (text_[k] == ']')
        in_class = false;
      else if (text_[k] == '/' && !in_class)
        return k + 1;
    }
    return at + 1;  // it was a division
  }

  // Skips code from `at` on; inside a literal, up to the brace that closes the inserted expression. Returns
  // the position after it.
  std::size_t code(std::size_t at, int depth) {
    if (depth > kDeepest)
      throw InputError(name_ + ":" + std::to_string(io::line_of(text_, at)) +
                       ": template literals are nested too deeply");
    int braces = 0;
    while (at < text_.size()) {
      const char c = text_[at];
      if (text_.compare(at, 2, "//") == 0) {
        at = end_of_line_comment(text_, at, false);
      } else if (text_.compare(at, 2, "/*") == 0) {
        at = end_of_block_comment(text_, at);
      } else if (c == '/' && is_expression(at)) {
        at = end_of_expression(at);
      } else if (c == '"' || c == '\'') {
        at = end_of_quoted(text_, at) + 1;
      } else if (c == '`') {
        at = literal(at, depth);
      } else {
        if (c == '}' && depth > 0 && braces == 0) return at + 1;
        braces += (c == '{') - (c == '}');
        ++at;
      }
    }
    return at;
  }

  std::size_t literal(std::size_t open, int depth) {
    std::size_t at = open + 1;
    while (at < text_.size() && text_[at] != '`') {
      if (text_[at] == '\\' && at + 1 < text_.size()) {
        // A character that the script escapes appears in the shader without the backslash.
        const char next = text_[at + 1];
        if (depth == 0 && (next == '\\' || next == '`' || next == '$')) text_[at] = ' ';
        at += 2;
      } else if (text_.compare(at, 2, "${") == 0) {
        at = code(at + 2, depth + 1);
      } else {
        ++at;
      }
    }
    if (depth == 0 && at < text_.size()) parts_.emplace_back(open + 1, at);
    return at + 1;
  }

  const std::string& name_;
  std::string& text_;
  std::vector<Part> parts_;
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPrograms{
    {{"HLSLPROGRAM", "ENDHLSL"}, {"HLSLINCLUDE", "ENDHLSL"}, {"CGPROGRAM", "ENDCG"}, {"CGINCLUDE", "ENDCG"}}};

// The position of the separate word, at or after `at`.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t at) {
  for (at = text.find(word, at); at != text.npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_word(text[at - 1])) &&
        (at + word.size() == text.size() || !is_word(text[at + word.size()])))
      return at;
  return text.npos;
}

}  // namespace

std::string text_of_bytes(const std::string& name, std::string bytes) {
  if (bytes.starts_with("\x03\x02\x23\x07") || bytes.starts_with("\x07\x23\x02\x03"))
    throw InputError(name + ": is SPIR-V, and a text is needed here: give the source text instead");
  io::Content content{name, std::move(bytes)};
  if (content.bytes.find('\0') != content.bytes.npos) io::make_utf8(content);
  const std::string& text = content.bytes;
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string out;
  out.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k)
    if (text.compare(k, kMark.size(), kMark) == 0)
      k += kMark.size() - 1;
    else if (text[k] != '\r')
      out += text[k];
    else if (k + 1 == text.size() || text[k + 1] != '\n')
      out += '\n';
  return out;
}

Stripped stripped(std::string_view text) {
  Stripped out{std::string(text), {}};
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (text.compare(at, 2, "//") == 0) {
      if (line_begins) out.line_notes.push_back(at);
      end = end_of_line_comment(text, at, true);
      blank(out.text, at, end);
    } else if (text.compare(at, 2, "/*") == 0) {
      end = end_of_block_comment(text, at);
      blank(out.text, at, end);
    } else if (text[at] == '"') {
      const std::size_t stop = end_of_quoted(text, at);
      blank(out.text, at + 1, stop);
      end = stop < text.size() && text[stop] == '"' ? stop + 1 : stop;
      line_begins = false;
    } else {
      line_begins = text[at] == '\n' || (line_begins && (text[at] == ' ' || text[at] == '\t'));
    }
    at = end;
  }
  return out;
}

bool is_script(std::string_view suffix) {
  constexpr std::array<std::string_view, 7> kSuffixes{".js", ".mjs", ".cjs", ".jsx", ".ts", ".mts", ".tsx"};
  return std::ranges::find(kSuffixes, suffix) != kSuffixes.end();
}

void keep_template_literals(const std::string& name, std::string& text) {
  const std::vector<Part> literals = Script(name, text).literals();
  if (!literals.empty()) keep_parts(text, literals);
}

bool is_unity(std::string_view suffix) {
  return suffix == ".shader";
}

void keep_programs(std::string& text) {
  const std::string bare = stripped(text).text;
  std::vector<Part> parts;
  for (const auto& [begin, end] : kPrograms)
    for (std::size_t open = find_word(bare, begin, 0); open != bare.npos;
         open = find_word(bare, begin, open + 1)) {
      const std::size_t first = open + begin.size(), close = find_word(bare, end, first);
      if (close != bare.npos) parts.emplace_back(first, close);
    }
  std::ranges::sort(parts);
  if (!parts.empty()) keep_parts(text, parts);
}

bool holds_program(std::string_view bare) {
  for (const auto& [begin, end] : kPrograms)
    for (std::size_t at = find_word(bare, begin, 0); at != bare.npos; at = find_word(bare, begin, at + 1)) {
      const std::size_t line = at == 0 ? 0 : bare.rfind('\n', at - 1) + 1;
      if (io::trimmed(bare.substr(line, bare.find('\n', at) - line)) == begin) return true;
    }
  return false;
}

}  // namespace brdf::shader
