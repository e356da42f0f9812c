// Tests data/synthetic: the command of each set reproduces the set, and its fit agrees with the table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/files/content.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/material/material_json.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(BRDF_SOURCE_DIR) / "data" / "synthetic";

struct Set {
  std::string file, command, fit;
  double within;  // NaN: no parameters to recover
  int exit_code;
  friend void PrintTo(const Set& set, std::ostream* out) { *out << set.file; }
};

// Reads the rows of the README's table.
std::vector<Set> sets() {
  std::vector<Set> all;
  const io::Content readme = io::read_content(kFolder / "README.md");
  io::LineReader reader(readme);
  std::string_view line;
  std::vector<std::string_view> cells;
  const auto code = [](std::string_view cell) {
    std::string text(cell);
    std::erase(text, '`');
    return text;
  };
  while (reader.next(line)) {
    io::split(line, '|', cells);
    if (cells.size() != 8 || !cells[1].ends_with(".csv")) continue;
    Set set{std::string(cells[1]), code(cells[3]), code(cells[4]), std::nan(""),
            std::stoi(std::string(cells[6]))};
    io::parse_number(cells[5], set.within);
    all.push_back(set);
  }
  return all;
}

// Returns the largest relative difference of any parameter (for tangent_phi the absolute difference in
// radians). The terms must be in the same order.
double largest_error(const Material& fitted, const Material& truth) {
  double worst = 0;
  const auto compare = [&](double a, double b) {
    worst = std::max(worst, b == 0 ? std::abs(a) : std::abs(a / b - 1));
  };
  for (std::size_t t = 0; t < truth.terms.size(); ++t) {
    const Term &a = fitted.terms.at(t), &b = truth.terms[t];
    for (std::size_t c = 0; c < truth.channels.size(); ++c) {
      for (std::size_t k = 0; k < b.weights[c].size(); ++k) compare(a.weights.at(c).at(k), b.weights[c][k]);
      for (std::size_t k = 0; k < b.shape_of(c).size(); ++k) compare(a.shape_of(c)[k], b.shape_of(c)[k]);
    }
    worst = std::max(worst, std::abs(std::remainder((a.tangent_phi - b.tangent_phi).radians(), kPi)));
  }
  return worst;
}

class Synthetic : public testing::TestWithParam<Set> {
 protected:
  void SetUp() override {
    for (const auto& entry : fs::directory_iterator(kFolder))
      if (entry.path().extension() == ".json") fs::copy(entry.path(), folder_.path());
  }
  io::TemporaryFolder folder_;
};

TEST_P(Synthetic, IsRegeneratedBitForBit) {
  const Outcome made = run_brdf("synth " + GetParam().command + " -o " + GetParam().file, folder_.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string bytes = file_text(folder_.path() / GetParam().file);
  EXPECT_TRUE(bytes == file_text(kFolder / GetParam().file)) << "brdf synth " << GetParam().command;
  EXPECT_LT(bytes.size(), 200000u);
}

TEST_P(Synthetic, FitsAsItsTableSays) {
  const Set& set = GetParam();
  const Outcome fitted =
      run_brdf("fit '" + (kFolder / set.file).string() + "' " + set.fit + " -o m.json", folder_.path());
  EXPECT_EQ(fitted.exit_code, set.exit_code) << fitted.out << fitted.err;
  if (std::isnan(set.within)) return;
  const io::SampleTable table = io::read_samples(kFolder / set.file);
  const io::Json json = io::parse_json(table.find_metadata("truth").value(), set.file);
  const Material truth = io::material_from_json(io::JsonPlace(json, set.file)).material;
  const double error = largest_error(io::read_material(folder_.path() / "m.json"), truth);
  EXPECT_LE(error, set.within) << fitted.out;
  RecordProperty("error", io::to_text(error));
}

INSTANTIATE_TEST_SUITE_P(Data, Synthetic, testing::ValuesIn(sets()),
                         [](const auto& set) { return set.param.file.substr(0, set.param.file.find('.')); });

TEST(SyntheticFolder, HoldsEverySetOfTheTableAndNoOther) {
  std::set<std::string> listed, present;
  for (const Set& set : sets()) listed.insert(set.file);
  for (const auto& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == ".csv") present.insert(entry.path().filename());
  EXPECT_EQ(listed, present);
  EXPECT_GE(listed.size(), 12u);
}

TEST(SyntheticFolder, WithoutItsApertureTheSharpLobeFitsTooWide) {
  const io::TemporaryFolder folder;
  const std::string fit = "fit '" + (kFolder / "aperture.csv").string() + "' --form ward";
  const auto alpha = [&](const std::string& options) {
    const Outcome outcome = run_brdf(fit + options + " -o m.json", folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return io::read_material(folder.path() / "m.json").terms[0].shape[0][0];
  };
  EXPECT_GT(alpha(""), 1.15 * 0.004);
  EXPECT_NEAR(alpha(" --aperture 1"), 0.004, 0.03 * 0.004);
}

TEST(SyntheticFolder, CoversAllSixFamilies) {
  std::string commands;
  for (const Set& set : sets()) commands += set.command + '\n';
  for (const char* form : {"lambert", "oren_nayar", "phong", "blinn_phong", "ward", "cook_torrance"})
    EXPECT_THAT(commands, testing::HasSubstr(std::string("--form ") + form + " "));
}

}  // namespace
}  // namespace brdf
