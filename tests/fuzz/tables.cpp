// Sample tables of this project and of other programs. Each format has a target and thus a corpus of its
// own.
#include "io/files/content.h"
#include "io/files/json.h"
#include "io/files/text.h"
#include "io/formats/astm.h"
#include "io/formats/describe_table.h"
#include "io/formats/exr_table.h"
#include "io/formats/optical_constants.h"
#include "io/formats/read.h"
#include "io/formats/zemax.h"
#include "io/samples/arrange.h"
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
    alta("alta", read_table), tensor("tensor", read_table), fred("fred", read_table),
    cornell("cornell", read_table), openmaterial("openmaterial", read_table), bird("bird", read_table),
    speos("speos", read_table), klems("klems", read_table), aspecular("aspecular", read_table);

// The conversions of a table that a user can request.
const Registered arranged("arranged", [](std::string_view input) {
  io::SampleTable table = io::read_samples(content_of(input));
  io::arrange(table, {.repeats = io::Repeats::average});
  check_samples(table);
  io::arrange(table, {.polarisation = io::Polarisation::average});
  check_samples(table);
});

// Tables as OpenEXR files. Values are rounded only once.
const Registered exr_tables("exr_table", [](std::string_view input) {
  const io::SampleTable table = io::read_samples(content_of(input));
  check_samples(table);
  if (table.format != "exr") return;
  const std::filesystem::path path = output();
  io::write_exr_table(path, table);
  const io::SampleTable again = io::read_samples(path);
  require(again.channels == table.channels && again.metadata == table.metadata,
          "OpenEXR keeps names and comments");
  require(again.theta_i == table.theta_i && again.phi_i == table.phi_i && again.theta_o == table.theta_o &&
              again.phi_o == table.phi_o && again.values == table.values && again.sigma == table.sigma,
          "floats come back as they were");
});

// Formats of other programs: a table that is written must read back to the same numbers.
const Registered written("written", [](std::string_view input) {
  const io::SampleTable table = io::read_samples(content_of(input));
  const std::filesystem::path path = output();
  io::astm::write(path, table);
  const io::SampleTable again = io::read_samples(path);
  require(again.format == "astm_e1392" && again.channels == table.channels, "ASTM E1392 keeps the channels");
  require(again.theta_i == table.theta_i && again.phi_i == table.phi_i && again.theta_o == table.theta_o &&
              again.phi_o == table.phi_o && again.values == table.values,
          "ASTM E1392 keeps angles and values");
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    require(
        again.has_sigma(c) == table.has_sigma(c) && (!table.has_sigma(c) || again.sigma[c] == table.sigma[c]),
        "ASTM E1392 keeps standard deviations");
  io::zemax::write(path, table);
  const io::SampleTable grid = io::read_samples(path);
  require(grid.format == "zemax" && grid.rows() <= table.rows(),
          "lens-design text has no more rows than the table");
});

// A layout, a line "---", and the table that it describes.
const Registered layouts("layout", [](std::string_view input) {
  constexpr std::string_view kCut = "\n---\n";
  const std::size_t end = input.find(kCut);
  if (end == input.npos || !input.starts_with('{')) return;
  const std::string table(input.substr(end + kCut.size()));
  check_samples(io::read_samples(io::Content{"input", table}, {.layout = std::string(input.substr(0, end))}));
});

// A table that is read alone is read to the same rows by the layout that is proposed for it.
const Registered proposals("proposal", [](std::string_view input) {
  const io::TableProposal proposal = io::propose_layout(content_of(input));
  if (!proposal.alone || proposal.open > 0) return;
  const io::SampleTable& alone = *proposal.alone;
  const io::SampleTable again = io::read_samples(content_of(input), {.layout = io::to_line(proposal.layout)});
  require(again.theta_i == alone.theta_i && again.phi_i == alone.phi_i && again.theta_o == alone.theta_o &&
              again.phi_o == alone.phi_o,
          "a proposal keeps the directions");
  require(again.channels == alone.channels && again.values == alone.values && again.sigma == alone.sigma,
          "a proposal keeps the values");
});

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
