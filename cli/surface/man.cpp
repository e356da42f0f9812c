#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/surface/surface.h"

namespace brdf::cli {
namespace {

// Escapes text for man(7): no character is read as a command.
std::string roff(std::string_view text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    line_start = c == '\n';
  }
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void heading(std::ostream& out, const std::string& name, const std::string& what) {
  out << ".TH " << upper(name) << " 1 \"" BRDF_RELEASE_DATE "\" \"brdf " BRDF_VERSION "\" \"User Commands\"\n"
      << ".SH NAME\n"
      << roff(name) << " \\- " << roff(what) << '\n';
}

void exit_status(std::ostream& out) {
  out << ".SH EXIT STATUS\n0: good; 1: a result that fails; 2: bad input or usage; 3: the environment lacks "
         "something; 4: undecided.\n";
}

// Writes the lines unchanged.
void verbatim(std::ostream& out, const std::string& text) {
  out << ".nf\n";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out << (line.empty() ? ".sp" : roff(line)) << '\n';
  out << ".fi\n";
}

void option(std::ostream& out, const OptionSurface& o) {
  out << ".TP\n";
  for (std::size_t k = 0; k < o.names.size(); ++k)
    out << (k == 0 ? "" : ", ") << (o.positional ? "\\fI" : "\\fB") << roff(o.names[k]) << "\\fR";
  if (!o.flag && !o.positional) out << " \\fI" << roff(o.value) << "\\fR";
  if (o.repeats) out << " ...";
  out << '\n' << roff(o.description);
  if (!o.description.empty() && o.description.back() != '.') out << '.';
  if (o.required) out << " Required.";
  if (!o.words.empty() && o.description.find(o.words.back()) == std::string::npos) {
    out << "\nOne of";
    for (std::size_t k = 0; k < o.words.size(); ++k) out << (k == 0 ? " " : ", ") << roff(o.words[k]);
    out << '.';
  }
  if (!o.initial.empty()) out << "\nDefault: " << roff(o.initial) << '.';
  out << '\n';
}

std::string page_of(const VerbSurface& verb) {
  std::ostringstream out;
  heading(out, "brdf-" + verb.name, verb.description);
  out << ".SH SYNOPSIS\n\\fBbrdf " << roff(verb.name) << "\\fR [\\fIOPTIONS\\fR]";
  for (const OptionSurface& o : verb.options)
    if (o.positional)
      out << (o.required ? " \\fI" : " [\\fI") << roff(o.names[0]) << "\\fR" << (o.repeats ? " ..." : "")
          << (o.required ? "" : "]");
  out << '\n';
  for (const bool positional : {true, false}) {
    const OptionSurface* before = nullptr;
    for (const OptionSurface& o : verb.options) {
      if (o.positional != positional) continue;
      if (!before) out << ".SH " << (positional ? "ARGUMENTS" : "OPTIONS") << '\n';
      if (!positional && (!before || before->group != o.group)) out << ".SS " << roff(o.group) << '\n';
      before = &o;
      option(out, o);
    }
  }
  if (!verb.footer.empty()) {
    out << ".SH NOTES AND EXAMPLES\n";
    verbatim(out, verb.footer);
  }
  exit_status(out);
  out << ".SH SEE ALSO\n.BR brdf (1)\n";
  return out.str();
}

}  // namespace

std::vector<Page> man_pages(const CLI::App& app) {
  const std::vector<VerbSurface> verbs = surface_of(app);
  std::ostringstream out;
  heading(out, app.get_name(), "models of surface reflection: fitted to measurements, judged, rendered");
  out << ".SH SYNOPSIS\n\\fBbrdf\\fR \\fIVERB\\fR [\\fIOPTIONS\\fR]\n.br\n\\fBbrdf \\-\\-help\\fR | "
         "\\fB\\-\\-version\\fR\n"
      << ".SH VERBS\n";
  for (const VerbSurface& verb : verbs)
    out << ".TP\n\\fB" << roff(verb.name) << "\\fR\n"
        << roff(verb.description) << ": see \\fBbrdf\\-" << roff(verb.name) << "\\fR(1)\n";
  exit_status(out);
  out << ".SH ENVIRONMENT\n.TP\n\\fBBRDF_THREADS\\fR\nMost threads that a command takes; no result depends "
         "on it.\n"
      << ".SH SEE ALSO\n";
  for (std::size_t k = 0; k < verbs.size(); ++k)
    out << ".BR brdf\\-" << roff(verbs[k].name) << " (1)" << (k + 1 < verbs.size() ? "," : "") << '\n';
  std::vector<Page> pages{{"brdf.1", out.str()}};
  for (const VerbSurface& verb : verbs) pages.push_back({"brdf-" + verb.name + ".1", page_of(verb)});
  return pages;
}

}  // namespace brdf::cli
