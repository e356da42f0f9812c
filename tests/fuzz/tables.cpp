// Sample tables, ours and other programs': one target per format, so that each has its own corpus.
#include "io/optical_constants.h"
#include "io/text.h"
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

const Registered constants("constants", [](std::string_view input) {
  const std::size_t end = input.find('\n');
  const std::string material(input.substr(0, end == input.npos ? 0 : end));
  const io::OpticalConstants read =
      io::read_optical_constants(content_of(input.substr(material.empty() ? 0 : end)), material);
  require(!read.nm.empty() && read.nm.size() == read.index.size(), "one index for each wavelength");
  for (std::size_t k = 0; k < read.nm.size(); ++k) {
    require(read.nm[k] > 0 && (k == 0 || read.nm[k] > read.nm[k - 1]), "wavelengths ascend");
    require(read.at(read.nm[k]) == read.index[k], "a row's own wavelength gives its index");
    const double f0 = read.reflectances({io::to_text(read.nm[k]) + "nm"})[0];
    require(f0 >= 0 && f0 <= 1, "a reflectance is between 0 and 1");
  }
});

const Registered directions("directions", [](std::string_view input) {
  check_samples(io::read_directions(content_of(input)), true);
});

}  // namespace
}  // namespace brdf::fuzz
