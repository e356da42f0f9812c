#include "cli/help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <regex>

#include "cli/options/terminal.h"
#include "cli/surface/option_table.h"
#include "cli/surface/surface.h"
#include "io/files/near_name.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

// Folds a line of a command and ends each folded line, except the last, with a backslash.
std::string folded_command(const std::string& line, int columns) {
  std::string text = folded(line, columns - 2), out;
  for (const char c : text) out += c == '\n' ? std::string(" \\\n") : std::string(1, c);
  return out;
}

// Returns the first command of a footer, for example "brdf fit samples.csv ...".
std::string first_example(const std::string& footer) {
  const std::size_t begin = footer.find("brdf ", footer.find("Example"));
  return begin == footer.npos ? "" : footer.substr(begin, footer.find('\n', begin) - begin);
}

class Layout : public CLI::Formatter {
 public:
  explicit Layout(int columns) : columns_(columns) {
    column_width(std::size_t(std::min(34, columns * 2 / 5)));
  }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    return folded(Formatter::make_usage(app, name), columns_);
  }
  std::string make_description(const CLI::App* app) const override {
    const std::string text = app->get_description();
    return text.empty() ? text : folded(text, columns_) + "\n";
  }
  std::string make_option(const CLI::Option* option, bool positional) const override {
    return folded(Formatter::make_option(option, positional), columns_);
  }
  std::string make_subcommand(const CLI::App* verb) const override {
    const std::string example = first_example(verb->get_footer());
    return folded(Formatter::make_subcommand(verb), columns_) +
           (example.empty() ? "" : folded_command("      " + example, columns_) + "\n");
  }
  // Prints the groups of a verb in the order of the table of options. The options of the program itself have
  // no row in that table and keep the parser's group.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (!app->get_parent()) return Formatter::make_help(app, name, mode);
    std::string out = make_description(app) + make_usage(app, name) + make_positionals(app);
    for (const std::string_view heading : kNames<Group>) {
      const auto options = app->get_options([&](const CLI::Option* option) {
        return option->nonpositional() && option->get_group() == heading;
      });
      if (!options.empty()) out += make_group(std::string(heading), false, options);
    }
    return out + '\n' + make_footer(app);
  }
  std::string make_footer(const CLI::App* app) const override {
    std::string out;
    const std::string text = app->get_footer();
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      out += line.find(" brdf ") == line.npos ? folded(line, columns_) : folded_command(line, columns_);
      out += '\n';
      begin = end + 1;
    }
    return out;
  }

 private:
  int columns_;
};

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const VerbSurface& verb : surface_of(app)) names.push_back(verb.name);
  return names;
}

std::vector<std::string> option_names(const CLI::App& app, const std::string& verb) {
  std::vector<std::string> names;
  for (const VerbSurface& v : surface_of(app))
    for (const OptionSurface& option : v.options)
      if (v.name == verb && !option.positional)
        names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

// "a, b or c" of "a,b,c".
std::string one_of(const std::string& list) {
  const std::string spaced = std::regex_replace(list, std::regex(","), ", ");
  const std::size_t last = spaced.rfind(", ");
  return last == spaced.npos ? spaced : spaced.substr(0, last) + " or " + spaced.substr(last + 2);
}

// The parser's sentences on a value, as the program's own: "--width: abc: must be from 1 to 16384".
std::string in_plain_words(const std::string& said) {
  static const std::regex range("(.*): Value (.*) not in range (\\S+) to (\\S+)"),
      names("(.*): (.*) not in \\{(.*)\\}");
  std::smatch found;
  if (std::regex_match(said, found, range)) {
    const auto shortest = [](const std::string& number) {
      return number.find('.') == number.npos ? number : io::to_text(std::stod(number));
    };
    const bool whole = found.str(3).find('.') == std::string::npos;
    return found.str(1) + ": " + found.str(2) + ": must be a " + (whole ? "whole " : "") + "number from " +
           shortest(found.str(3)) + " to " + shortest(found.str(4));
  }
  if (std::regex_match(said, found, names))
    return found.str(1) + ": " + found.str(2) + ": must be " + one_of(found.str(3));
  return said;
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_layout(int columns) {
  return std::make_shared<Layout>(columns);
}

std::string usage_fault(const CLI::App& app, const std::string& parsers_words,
                        const std::string& first_word) {
  if (app.get_subcommands().empty() && !first_word.empty() && first_word[0] != '-') {
    const std::string guess = io::did_you_mean(first_word, verb_names(app));
    return "'" + first_word + "' is not a verb (" + guess + "see brdf --help)";
  }
  std::string verb;
  for (const CLI::App* parsed : app.get_subcommands()) {
    verb = " " + parsed->get_name();
    for (const std::string& word : parsed->remaining()) {
      if (!word.starts_with("-") || word == "-") continue;
      const std::string name = word.substr(0, word.find('='));
      return name + " is not an option of brdf" + verb + " (" +
             io::did_you_mean(name, option_names(app, parsed->get_name())) + "see brdf" + verb + " --help)";
    }
  }
  return in_plain_words(parsers_words) + " (see brdf" + verb + " --help)";
}

}  // namespace brdf::cli
