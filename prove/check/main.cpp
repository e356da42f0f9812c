// brdf_check CERTIFICATE: the check of `brdf prove --check` as a program of its own, which holds no search. Exit code 0: every
// result holds; 1: one does not; 2: bad input.
#include <cstring>
#include <iostream>

#include "io/error.h"
#include "io/text.h"
#include "prove/check/certificate.h"

namespace {

constexpr const char* kUsage = "usage: brdf_check [--help | --version] CERTIFICATE\n";
constexpr const char* kHelp =
    "\n"
    "Verifies a certificate of `brdf prove -o`: encloses every box again, and asks whether it settles what "
    "is claimed and whether\n"
    "the boxes cover the whole domain. No search is in this program.\n"
    "\n"
    "Exit code: 0 every result holds, 1 one does not, 2 bad input.\n"
    "Example: brdf prove --all -o certificate.json; brdf_check certificate.json\n";

}  // namespace

int main(int argc, char** argv) {
  const auto asked = [&](const char* word) { return argc == 2 && std::strcmp(argv[1], word) == 0; };
  if (asked("--help") || asked("-h")) {
    std::cout << kUsage << kHelp;
    return 0;
  }
  if (asked("--version")) {
    std::cout << "brdf_check " BRDF_VERSION << '\n';
    return 0;
  }
  if (argc != 2) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    const brdf::prove::Checked checked = brdf::prove::check(brdf::io::read_content(argv[1]));
    for (const std::string& fault : checked.faults) std::cout << brdf::io::printable(fault) << '\n';
    std::cout << checked.results << " results, " << checked.leaves
              << " leaves: " << (checked.faults.empty() ? "all hold" : "rejected") << '\n';
    return checked.faults.empty() ? 0 : 1;
  } catch (const brdf::InputError& error) {
    std::cerr << "brdf_check: " << brdf::io::printable(error.what()) << '\n';
    return 2;
  }
}
