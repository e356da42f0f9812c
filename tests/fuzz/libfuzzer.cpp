// The entry of libFuzzer. The program's own name says the target: tests/fuzz/run makes a link for each.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz.h"

namespace {
brdf::fuzz::Target target = nullptr;
brdf::fuzz::Mutator mutator = nullptr;
}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  const auto found = brdf::fuzz::targets().find(std::filesystem::path(**arguments).filename().string());
  if (found == brdf::fuzz::targets().end()) {
    for (const auto& [name, run] : brdf::fuzz::targets()) std::puts(name.c_str());
    std::exit(0);
  }
  target = found->second;
  const auto own = brdf::fuzz::mutators().find(found->first);
  if (own != brdf::fuzz::mutators().end()) mutator = own->second;
  return 0;
}

// Three of four inputs by the target's own way of changing them.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  if (!mutator || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string changed = mutator({reinterpret_cast<const char*>(data), size}, seed / 4);
  if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(changed.begin(), changed.end(), reinterpret_cast<char*>(data));
  return changed.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  brdf::fuzz::run(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
