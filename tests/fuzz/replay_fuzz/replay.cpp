// ctest: fuzz.corpus label=fuzz needs=replay_fuzz @build@/tests/replay_fuzz @source@/tests/fuzz/corpus shader=@source@/data/shaders
// Passes every file of FOLDER/<target> to its target: the corpus, and earlier findings. Then it passes
// changes of these files, the same changes in every run. Further arguments TARGET=FOLDER name folders with
// additional seeds.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/mutate.h"

namespace {

using namespace brdf::fuzz;

std::vector<std::string> inputs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files(std::filesystem::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return inputs;
}

// Returns the number of changes that take about one or two seconds.
std::size_t count_changes(const std::string& target) {
  if (target == "merl") return 10;
  return target.starts_with("exr") || target == "mesh" || target == "shader" ? 100 : 1000;
}

std::string changed(const std::string& target, const std::string& input, std::uint32_t seed) {
  if (seed % 4 == 0) return mutate_bytes(input, seed);
  const auto own = mutators().find(target);
  return own == mutators().end() ? mutate_text(input, seed) : own->second(input, seed);
}

}  // namespace

int main(int count, char** arguments) {
  std::size_t seeds = 0, changes = 0;
  for (const auto& [name, target] : targets()) {
    std::vector<std::string> inputs = inputs_in(std::filesystem::path(arguments[1]) / name);
    for (int k = 2; k < count; ++k)
      if (const std::string named = arguments[k]; named.starts_with(name + "="))
        for (std::string& input : inputs_in(named.substr(name.size() + 1)))
          inputs.push_back(std::move(input));
    require(!inputs.empty(), name + " has a corpus");
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      std::fprintf(stderr, "%s, seed %zu\n", name.c_str(), k);
      run(target, inputs[k]);
    }
    for (std::size_t k = 0; k < count_changes(name); ++k) {
      std::fprintf(stderr, "%s, change %zu\n", name.c_str(), k);
      run(target, changed(name, inputs[k % inputs.size()], std::uint32_t(k)));
    }
    seeds += inputs.size();
    changes += count_changes(name);
  }
  std::printf("%zu inputs and %zu changes of them, %zu targets\n", seeds, changes, targets().size());
}
