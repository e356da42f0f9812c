// Runs every file of FOLDER/<target> through its target: the corpus, and what was once found. Further arguments TARGET=FOLDER
// name folders that are seeds as they stand.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz.h"

namespace {

std::size_t run_folder(const brdf::fuzz::Target& target, const std::filesystem::path& folder) {
  std::size_t inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::fprintf(stderr, "%s\n", entry.path().c_str());
    std::ifstream file(entry.path(), std::ios::binary);
    brdf::fuzz::run(target, std::string(std::istreambuf_iterator<char>(file), {}));
    ++inputs;
  }
  return inputs;
}

}  // namespace

int main(int count, char** arguments) {
  using namespace brdf::fuzz;
  std::size_t inputs = 0;
  for (const auto& [name, target] : targets()) {
    std::size_t of_target = run_folder(target, std::filesystem::path(arguments[1]) / name);
    for (int k = 2; k < count; ++k)
      if (const std::string seeds = arguments[k]; seeds.starts_with(name + "="))
        of_target += run_folder(target, seeds.substr(name.size() + 1));
    require(of_target > 0, name + " has a corpus");
    inputs += of_target;
  }
  std::printf("%zu inputs, %zu targets\n", inputs, targets().size());
}
