// The entry of libFuzzer. The program's own name says the target: tests/fuzz/run makes a link for each.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz.h"

namespace {
brdf::fuzz::Target target = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  const auto found = brdf::fuzz::targets().find(std::filesystem::path(**arguments).filename().string());
  if (found == brdf::fuzz::targets().end()) {
    for (const auto& [name, run] : brdf::fuzz::targets()) std::puts(name.c_str());
    std::exit(0);
  }
  target = found->second;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  brdf::fuzz::run(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
