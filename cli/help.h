// The help's layout: folded to the terminal, verbs by what they are for, an example beside each.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace brdf::cli {

// For `columns` characters in a line. Commands go on after a backslash, so that they can be pasted.
std::shared_ptr<CLI::FormatterBase> help_layout(int columns);

// What was wrong with a command line: an option or a verb that there is not, with what was probably meant;
// else the parser's words.
std::string usage_fault(const CLI::App& app, const std::string& parsers_words, const std::string& first_word);

}  // namespace brdf::cli
