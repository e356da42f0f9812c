// Sample tables, ours and other programs': one target per format, so that each has its own corpus.
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

void read_table(std::string_view input) {
  check_table(io::read_samples(as_file(input)));
}

const Registered csv("csv", read_table), astm("astm", read_table), lens("lens", read_table),
    tensor("tensor", read_table);

const Registered directions("directions", [](std::string_view input) {
  check_table(io::read_directions(as_file(input)), true);
});

}  // namespace
}  // namespace brdf::fuzz
