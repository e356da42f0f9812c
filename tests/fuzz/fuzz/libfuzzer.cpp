// The entry of libFuzzer. The name of the program selects the target: tests/fuzz/run makes a link for each
// target.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/mutate.h"

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

// If the target has a mutator of its own, it changes three of four inputs. Otherwise half of the texts are
// changed by words and lines. libFuzzer changes all other inputs.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const bool by_words = !mutator && seed % 2 == 0 && brdf::fuzz::is_text(input);
  if (by_words || (mutator && seed % 4 != 0)) {
    const std::string changed = (mutator ? mutator : brdf::fuzz::mutate_text)(input, seed / 4);
    if (!changed.empty() && changed.size() <= most) {
      std::copy(changed.begin(), changed.end(), reinterpret_cast<char*>(data));
      return changed.size();
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  brdf::fuzz::run(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
