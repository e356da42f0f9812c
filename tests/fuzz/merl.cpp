#include "io/formats/merl.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "io/formats/read.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

constexpr std::size_t kHeader = 12, kBytes = kHeader + 3 * io::merl::kCells * sizeof(double);

// Creates a file of full size without a valid cell, in memory.
int empty_file() {
  const int memory = memfd_create("merl", 0);
  std::vector<double> cells(3 * io::merl::kCells, -1.0);
  const std::int32_t sizes[3] = {io::merl::kThetaHalf, io::merl::kThetaDifference, io::merl::kPhiDifference};
  require(pwrite(memory, sizes, kHeader, 0) == ssize_t(kHeader) &&
              pwrite(memory, cells.data(), kBytes - kHeader, kHeader) == ssize_t(kBytes - kHeader),
          "memory can be written");
  return memory;
}

struct Change {
  std::uint32_t place;
  double value;
};
constexpr std::size_t kChange = sizeof(std::uint32_t) + sizeof(double);

// The input changes single values of the file. Each change consists of a position, modulo the number of
// values, and eight bytes. The number of remaining bytes is cut from the end of the file.
const Registered merl("merl", [](std::string_view input) {
  static const int memory = empty_file();
  std::vector<Change> changes;
  for (; input.size() >= kChange; input.remove_prefix(kChange)) {
    Change& change = changes.emplace_back();
    std::memcpy(&change.place, input.data(), sizeof change.place);
    std::memcpy(&change.value, input.data() + sizeof change.place, sizeof change.value);
    change.place %= 3 * io::merl::kCells;
  }
  const auto write = [](const Change& change, double value) {
    require(
        pwrite(memory, &value, sizeof value, off_t(kHeader + change.place * sizeof value)) == sizeof value,
        "memory can be written");
  };
  for (const Change& change : changes) write(change, change.value);
  require(ftruncate(memory, off_t(kBytes - input.size())) == 0, "memory can be cut");
  const auto restore = [&] {
    constexpr double kEnd[2] = {-1, -1};
    const char* const cut = reinterpret_cast<const char*>(kEnd + 2) - input.size();
    require(pwrite(memory, cut, input.size(), off_t(kBytes - input.size())) == ssize_t(input.size()),
            "memory can be written");
    for (const Change& change : changes) write(change, -1);
  };
  io::SampleTable table;
  try {
    table = io::read_samples("/proc/self/fd/" + std::to_string(memory));
  } catch (...) {
    restore();
    throw;
  }
  restore();
  check_samples(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const io::merl::CellDirections centre = io::merl::cell_directions(
        io::merl::find_cell(table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]));
    require(centre.theta_i == table.theta_i[k] && centre.phi_i == table.phi_i[k] &&
                centre.theta_o == table.theta_o[k] && centre.phi_o == table.phi_o[k],
            "a cell's centre lies in the cell");
  }
});

}  // namespace
}  // namespace brdf::fuzz
