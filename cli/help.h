// Layout of the help: folded to the terminal's width, verbs grouped by purpose, with an example for each
// verb.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace brdf::cli {

// Returns a layout for lines of `columns` characters. Folded commands end with a backslash so that they can
// be pasted.
std::shared_ptr<CLI::FormatterBase> help_layout(int columns);

// Returns a message about a faulty command line. For an unknown option or verb the message names the likely
// intention; otherwise the message is the parser's.
std::string usage_fault(const CLI::App& app, const std::string& parsers_words, const std::string& first_word);

}  // namespace brdf::cli
