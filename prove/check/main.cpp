// brdf_check CERTIFICATE: the check of `brdf prove --check` as a program of its own, which holds no search. Exit code 0: every
// result holds; 1: one does not; 2: bad input.
#include <iostream>

#include "io/error.h"
#include "prove/check/certificate.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: brdf_check CERTIFICATE\n";
    return 2;
  }
  try {
    const brdf::prove::Checked checked = brdf::prove::check(brdf::io::read_content(argv[1]));
    for (const std::string& fault : checked.faults) std::cout << fault << '\n';
    std::cout << checked.results << " results, " << checked.leaves
              << " leaves: " << (checked.faults.empty() ? "all hold" : "rejected") << '\n';
    return checked.faults.empty() ? 0 : 1;
  } catch (const brdf::InputError& error) {
    std::cerr << "brdf_check: " << error.what() << '\n';
    return 2;
  }
}
