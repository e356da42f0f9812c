// Runs every file of FOLDER/<target> through its target: the corpus, and what was once found.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz.h"

int main(int, char** arguments) {
  using namespace brdf::fuzz;
  std::size_t inputs = 0;
  for (const auto& [name, target] : targets()) {
    const std::size_t before = inputs;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(arguments[1]) / name)) {
      std::fprintf(stderr, "%s\n", entry.path().c_str());
      std::ifstream file(entry.path(), std::ios::binary);
      run(target, std::string(std::istreambuf_iterator<char>(file), {}));
      ++inputs;
    }
    require(inputs > before, name + " has a corpus");
  }
  std::printf("%zu inputs, %zu targets\n", inputs, targets().size());
}
