// Sample tables, ours and other programs': one target per format, so that each has its own corpus.
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

io::Content content_of(std::string_view input) {
  return {"input", std::string(input)};
}

void read_table(std::string_view input) {
  check_samples(io::read_samples(content_of(input)));
}

const Registered csv("csv", read_table), astm("astm", read_table), lens("lens", read_table),
    alta("alta", read_table), tensor("tensor", read_table);

const Registered directions("directions", [](std::string_view input) {
  check_samples(io::read_directions(content_of(input)), true);
});

}  // namespace
}  // namespace brdf::fuzz
