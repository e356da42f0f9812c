#include "cli/options/next_step.h"

#include <iostream>
#include <set>

#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "io/files/numbers.h"
#include "io/files/shell.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

std::set<std::string>& missing_verbs() {
  static std::set<std::string> verbs;
  return verbs;
}

// Returns true for a name that can be printed unchanged.
bool is_plain(const std::string& name) {
  return io::printable(name) == name;
}

}  // namespace

void set_missing(const std::string& verb) {
  missing_verbs().insert(verb);
}

std::string view_command(const std::string& material, const std::string& samples) {
  if (material.empty() || is_stream(material) || !is_plain(material) || missing_verbs().contains("view"))
    return "";
  const bool has_samples = !samples.empty() && !is_stream(samples);
  if (has_samples && !is_plain(samples)) return "";
  return "brdf view " + io::shell_file(material) +
         (has_samples ? " --measured " + io::shell_file(samples) : "");
}

std::string scene_command(const std::string& scene) {
  return !is_plain(scene) || missing_verbs().contains("view") ? ""
                                                              : "brdf view --scene " + io::shell_file(scene);
}

std::string open_page(const std::string& page) {
  return page.empty() || is_stream(page) || !is_plain(page)
             ? ""
             : "open " + io::shell_file(page) + " in a browser";
}

std::string check_command(const std::string& certificate) {
  return certificate.empty() || is_stream(certificate) || !is_plain(certificate)
             ? ""
             : "brdf prove --check " + io::shell_file(certificate);
}

void print_next_step(const std::vector<std::string>& steps, TextStream stream, const std::string& purpose) {
  std::vector<std::string> left;
  for (const std::string& step : steps)
    if (!step.empty()) left.push_back(step);
  if (left.empty() || is_quiet()) return;
  erase_progress();
  (stream == TextStream::out ? std::cout : std::cerr) << purpose << ": " << io::joined(left, ", or ") << '\n';
}

}  // namespace brdf::cli
