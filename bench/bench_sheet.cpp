// Compares the time of a table's data sheet with the time to read the table. Usage: bench_sheet FILE...
#include <algorithm>
#include <chrono>
#include <iostream>
#include <vector>

#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "sheet/data_sheet.h"

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const auto milliseconds = [](auto&& work) {
    std::vector<double> times;
    for (int k = 0; k < 5; ++k) {
      const auto begin = Clock::now();
      work();
      times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
    return *std::min_element(times.begin(), times.end());
  };
  for (int k = 1; k < argc; ++k) {
    brdf::io::SampleTable table;
    const double read = milliseconds([&] { table = brdf::io::read_samples(std::filesystem::path(argv[k])); });
    const double sheet = milliseconds([&] { brdf::sheet::data_sheet(table); });
    std::cout << argv[k] << ": " << table.rows() << " rows, read in " << read << " ms, sheet in " << sheet
              << " ms, ratio " << sheet / read << '\n';
  }
}
