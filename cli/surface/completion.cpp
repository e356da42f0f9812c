#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/surface/surface.h"

namespace brdf::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// Returns the words offered for an option's value: its own words, or names of forms and parameters.
std::vector<std::string> words_for(const OptionSurface& o) {
  return o.words.empty() ? names_for(o.takes) : o.words;
}

std::string bash_files(const OptionSurface& o) {
  return "_brdf_files '" + (o.takes == Value::folder ? "/" : joined(suffixes_of(o.takes), "|")) + "'";
}

// Returns the bash code that offers values.
std::string bash_offer(const OptionSurface& o) {
  if (const auto words = words_for(o); !words.empty()) {
    const std::string offer = "_brdf_words '" + joined(words, " ") + "'";
    if (is_file(o.takes)) return offer + "; " + bash_files(o);
    return o.takes == Value::parameter ? offer + "; compopt -o nospace 2>/dev/null" : offer;
  }
  return is_file(o.takes) ? bash_files(o) : ":";
}

// Escapes a word for zsh's _arguments, in which colons and brackets are special.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') out += '\\';
    out += c == '\'' ? std::string("'\\''") : c == '\n' ? std::string(" ") : std::string(1, c);
  }
  return out;
}

std::string zsh_files(const OptionSurface& o) {
  if (o.takes == Value::folder) return "_files -/";
  const auto suffixes = suffixes_of(o.takes);
  return suffixes.empty() ? "_files" : "_files -g \"*.(" + joined(suffixes, "|") + ")(-.)\"";
}

std::string zsh_action(const OptionSurface& o) {
  if (o.takes == Value::parameter) return "compadd -S \"\" -- " + joined(names_for(o.takes), " ");
  const std::string words = joined(words_for(o), " ");
  if (!is_file(o.takes)) return words.empty() ? " " : "(" + words + ")";
  return words.empty() ? zsh_files(o) : "{compadd -- " + words + "; " + zsh_files(o) + "}";
}

std::string zsh_spec(const OptionSurface& o) {
  const std::string value = ":" + zsh_text(o.value) + ":" + zsh_action(o);
  if (o.positional) return "'" + std::string(o.repeats ? "*" : o.required ? "" : ":") + value + "'";
  const std::string rest = "[" + zsh_text(o.description) + "]" + (o.flag ? "" : value) + "'";
  const std::string star = o.repeats ? "*" : "";
  if (o.names.size() == 1) return "'" + star + o.names[0] + rest;
  return (o.repeats ? "\\*" : "'(" + joined(o.names, " ") + ")'") + "{" + joined(o.names, ",") + "}'" + rest;
}

// Quotes a text for fish.
std::string fish_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\\' || c == '\'') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

// Returns the arguments of fish's complete for the values of an option. A file is offered by fish itself.
std::string fish_values(const OptionSurface& o) {
  std::string out;
  if (const auto words = words_for(o); !words.empty()) out += " -a " + fish_text(joined(words, " "));
  if (o.takes == Value::folder) return out + " -a '(__fish_complete_directories)'";
  if (!is_file(o.takes)) return out + " -f";
  std::string patterns;
  for (const std::string_view suffix : suffixes_of(o.takes))
    patterns += " (__fish_complete_suffix ." + std::string(suffix) + ")";
  return out + (patterns.empty() ? " -F" : " -k -a '" + patterns.substr(1) + "'");
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::ostringstream out, verbs;
  std::vector<std::string> names;
  for (const VerbSurface& verb : surface_of(app)) {
    names.push_back(verb.name);
    std::vector<std::string> options;
    std::string positional = ":";
    verbs << "    '" << verb.name << " '*)\n      case $before in\n";
    for (const OptionSurface& o : verb.options) {
      if (o.positional) {
        if (positional == ":") positional = bash_offer(o);
        continue;
      }
      options.insert(options.end(), o.names.begin(), o.names.end());
      if (!o.flag) verbs << "        " << joined(o.names, "|") << ") " << bash_offer(o) << "; return ;;\n";
    }
    verbs << "      esac\n      if [[ $now == -* ]]; then _brdf_words '" << joined(options, " ")
          << "'\n      else " << positional << "\n      fi ;;\n";
  }
  out << "# bash completion of brdf " BRDF_VERSION ", written by `brdf describe bash`\n"
      << R"(_brdf_words() { COMPREPLY=($(compgen -W "$1" -- "$now")); }
# Folders, and files of these suffixes: 'a|b'; '': any, /: none.
_brdf_files() {
  local file
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if [[ -d $file || -z $1 || ( $1 != / && $file =~ \.($1)$ ) ]]; then COMPREPLY+=("$file"); fi
  done < <(compgen -f -- "$now")
}
_brdf() {
  local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb=
  COMPREPLY=()
  ((COMP_CWORD > 1)) && verb=${COMP_WORDS[1]}
  case "$verb " in
    ' ') _brdf_words ')"
      << joined(names, " ") << " --help --version' ;;\n"
      << verbs.str() << "  esac\n}\ncomplete -F _brdf brdf\n";
  return out.str();
}

std::string zsh_completion(const CLI::App& app) {
  std::ostringstream out;
  out << "#compdef brdf\n# zsh completion of brdf " BRDF_VERSION ", written by `brdf describe zsh`\n"
      << "local -a verbs\nverbs=(\n";
  const std::vector<VerbSurface> verbs = surface_of(app);
  for (const VerbSurface& verb : verbs)
    out << "  '" << verb.name << ":" << zsh_text(verb.description) << "'\n";
  out << ")\nif ((CURRENT == 2)); then\n  _describe verb verbs\n  return\nfi\nshift words\n((CURRENT--))\n"
      << "case $words[1] in\n";
  for (const VerbSurface& verb : verbs) {
    out << "  " << verb.name << ")\n    _arguments";
    for (const OptionSurface& o : verb.options) out << " \\\n      " << zsh_spec(o);
    out << " ;;\n";
  }
  out << "esac\n";
  return out.str();
}

std::string fish_completion(const CLI::App& app) {
  std::ostringstream out;
  out << "# fish completion of brdf " BRDF_VERSION ", written by `brdf describe fish`\ncomplete -c brdf -f\n";
  for (const VerbSurface& verb : surface_of(app)) {
    out << "complete -c brdf -n __fish_use_subcommand -a " << verb.name << " -d "
        << fish_text(verb.description) << '\n';
    for (const OptionSurface& o : verb.options) {
      out << "complete -c brdf -n '__fish_seen_subcommand_from " << verb.name << "'";
      for (const std::string& name : o.names)
        if (!o.positional)
          out << (name.starts_with("--") ? " -l " : " -s ") << name.substr(name.find_first_not_of('-'));
      if (!o.flag) out << (o.positional ? "" : " -r") << fish_values(o);
      if (!o.positional) out << " -d " << fish_text(o.description);
      out << '\n';
    }
  }
  return out.str();
}

}  // namespace brdf::cli
