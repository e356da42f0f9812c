#include "tests/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"
#include "io/material/material_json.h"
#include "io/samples/degrees.h"

namespace brdf::fuzz {
namespace {

// The folder with a link for every requested suffix to the one file in memory.
const std::filesystem::path& folder() {
  static const io::TemporaryFolder folder;
  return folder.path();
}

bool finite(const std::vector<double>& values) {
  for (const double x : values)
    if (!std::isfinite(x)) return false;
  return true;
}

void check_columns(const io::SampleTable& table) {
  const std::size_t rows = table.rows();
  require(rows > 0, "a table has rows");
  require(table.lines.empty() || table.lines.size() == rows, "every row has its line, or none");
  for (const auto* theta : {&table.theta_i, &table.theta_o}) {
    require(theta->size() == rows, "columns are of one length");
    for (const double x : *theta) require(x >= 0 && x <= 90, "polar angles lie in [0, 90]");
  }
  for (const auto* phi : {&table.phi_i, &table.phi_o})
    require(phi->size() == rows && finite(*phi), "azimuths are finite");
  require(table.values.size() == table.channels.size(), "every channel has its values");
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    require(table.values[c].size() == rows && finite(table.values[c]), "values are finite");
    if (!table.has_sigma(c)) continue;
    require(table.sigma[c].size() == rows && finite(table.sigma[c]), "deviations are finite");
    for (const double sigma : table.sigma[c]) require(sigma > 0, "deviations are above 0");
  }
}

// Keeps at most 100 rows. Writing treats every row alike, so that these are enough.
void cut(io::SampleTable& table) {
  const std::size_t rows = std::min<std::size_t>(table.rows(), 100);
  for (auto* angle : {&table.theta_i, &table.phi_i, &table.theta_o, &table.phi_o}) angle->resize(rows);
  for (auto* columns : {&table.values, &table.sigma})
    for (auto& column : *columns) column.resize(std::min(column.size(), rows));
}

std::string text_of(const io::SampleTable& table) {
  std::ostringstream text;
  io::write_samples(text, table);
  return text.str();
}

}  // namespace

std::map<std::string, Target, std::less<>>& targets() {
  static std::map<std::string, Target, std::less<>> all;
  return all;
}

std::map<std::string, Mutator, std::less<>>& mutators() {
  static std::map<std::string, Mutator, std::less<>> all;
  return all;
}

void run(Target target, std::string_view input) {
  try {
    target(input);
  } catch (const InputError& error) {
    require(*error.what(), "a refusal says why");
  }
}

void require(bool holds, std::string_view rule) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n", int(rule.size()), rule.data());
  std::abort();
}

std::filesystem::path as_file(std::string_view bytes, const std::string& suffix) {
  static const int memory = memfd_create("input", 0);
  const bool written =
      ftruncate(memory, 0) == 0 && pwrite(memory, bytes.data(), bytes.size(), 0) == ssize_t(bytes.size());
  require(written, "memory can be written");
  const std::filesystem::path plain = "/proc/self/fd/" + std::to_string(memory);
  if (suffix.empty()) return plain;
  const std::filesystem::path link = folder() / ("input" + suffix);
  if (!std::filesystem::is_symlink(link)) std::filesystem::create_symlink(plain, link);
  return link;
}

std::filesystem::path folder_with(const std::string& name, const std::string& file, std::string_view bytes) {
  const std::filesystem::path path = folder() / name;
  std::filesystem::create_directories((path / file).parent_path());
  if (!file.empty())
    require(bool(std::ofstream(path / file, std::ios::binary) << bytes), "files can be written");
  return path;
}

std::filesystem::path output() {
  return folder() / "output";
}

void check_samples(io::SampleTable table, bool directions_only) {
  check_columns(table);
  cut(table);
  const DirectionArrays<double> directions = io::unit_directions(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Vec3<double> wi = directions.view().wi(k), wo = directions.view().wo(k);
    require(std::abs(dot(wi, wi) - 1) < 1e-9 && std::abs(dot(wo, wo) - 1) < 1e-9, "directions have length 1");
  }
  const std::string text = text_of(table);
  io::Content file{"written", text};
  io::SampleTable again;
  try {
    again = directions_only ? io::read_directions(std::move(file)) : io::read_samples(std::move(file));
  } catch (const InputError& error) {
    require(false, std::string("what is written can be read: ") + error.what());
  }
  require(again.format == "csv", "what is written is recognised as our own table");
  require(again.channels == table.channels && again.metadata == table.metadata,
          "names and comments read back as they were written");
  require(again.theta_i == table.theta_i && again.phi_i == table.phi_i && again.theta_o == table.theta_o &&
              again.phi_o == table.phi_o,
          "angles read back as they were written");
  require(again.values == table.values, "values read back as they were written");
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    require(
        again.has_sigma(c) == table.has_sigma(c) && (!table.has_sigma(c) || again.sigma[c] == table.sigma[c]),
        "deviations read back as they were written");
  require(text_of(again) == text, "writing again gives the same text");
}

void check_material(const Material& material) {
  std::vector<double> out(material.channels.size());
  for (const double theta : {0.0, 40.0, 89.9}) {
    eval(material, io::unit_vector(40, 200), io::unit_vector(theta, 30), out);
    require(finite(out), "a material's values are finite");
  }
  const std::string text = io::to_text(io::to_json(material));
  const io::Json json = io::parse_json(text, "memory");
  Material again;
  try {
    again = io::material_from_json({json, "memory"}).material;
  } catch (const InputError& error) {
    require(false, std::string("a material that is written can be read: ") + error.what());
  }
  require(io::to_text(io::to_json(again)) == text, "a material reads back as it was written");
}

}  // namespace brdf::fuzz
