#include "cli/options/old_spelling.h"

#include <algorithm>

#include "cli/options/terminal.h"

namespace brdf::cli {
namespace {

struct OldMode {
  const char* option;
  const char* verb;
  std::vector<std::string> instead;  // words that replace the option
};

}  // namespace

std::vector<std::string> in_new_spelling(std::vector<std::string> words) {
  static const OldMode kModes[] = {{"--parity", "parity", {}},
                                   {"--lookup-pictures", "maps", {"lookup"}},
                                   {"--maps", "maps", {}},
                                   {"--lobe3d", "lobes", {"--body"}},
                                   {"--lobes", "lobes", {}}};
  if (words.empty()) return words;
  if (words == std::vector<std::string>{"version"}) return {"--version"};
  if (words.front() == "help" && words.size() == 2) return {words[1], "--help"};
  if (words == std::vector<std::string>{"help"}) return {"--help"};
  if (words.front() != "render") return words;
  for (const OldMode& mode : kModes) {
    const auto at = std::ranges::find(words, mode.option);
    if (at == words.end()) continue;
    words.insert(words.erase(at), mode.instead.begin(), mode.instead.end());
    words.front() = mode.verb;
    Note() << "brdf render " << mode.option << ": is `brdf " << mode.verb << (mode.instead.empty() ? "" : " ")
           << (mode.instead.empty() ? "" : mode.instead.front()) << "` now; the old spelling goes with 0.3";
    return words;
  }
  return words;
}

}  // namespace brdf::cli
