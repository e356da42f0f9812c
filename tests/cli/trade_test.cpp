// Tests brdf trade and brdf recommend through the executable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kData = BRDF_SOURCE_DIR "/data/";
const std::string kCloseUp = "recommend --scene '" + kData + "scenes/recommend_close_up.json' --reference '" +
                             kData + "materials/glossy_grey_paper.json' --ledger '" + kData + "ledger.json' ";

class Trade : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  io::TemporaryFolder folder_;
};

TEST_F(Trade, WritesItsLedgerInThreeFormats) {
  const Outcome o = run("trade --quick --only 'Fresnel of glass' -o l.json -o l.csv -o l.html --json");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const io::Json json = io::Json::parse(o.out);
  ASSERT_EQ(json.at("rows").size(), 5u);
  for (const io::Json& row : json.at("rows"))
    for (const char* key : {"question", "choice", "exact", "cost_ratio", "error", "domain", "dominated_by"})
      EXPECT_TRUE(row.contains(key)) << key;
  EXPECT_EQ(json.at("fronts").size(), 1u);
  EXPECT_EQ(io::Json::parse(file_text(folder_.path() / "l.json")).at("rows").size(), 5u);
  EXPECT_THAT(file_text(folder_.path() / "l.csv"), HasSubstr("\"Fresnel of glass\",\"Schlick\""));
  EXPECT_THAT(file_text(folder_.path() / "l.html"), HasSubstr("Fresnel of glass"));
}

TEST_F(Trade, AnswersWhatIsNoQuestion) {
  const Outcome o = run("trade --quick --only nonsense");
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_THAT(o.err, HasSubstr("nonsense"));
}

TEST_F(Trade, ComparesLedgers) {
  const std::string ledger = "'" + kData + "ledger.json'";
  const Outcome same = run("trade --compare " + ledger + " " + ledger + " --json");
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_EQ(io::Json::parse(same.out).at("apart"), 0);
  io::Json other = io::Json::parse(file_text(kData + "ledger.json"));
  for (io::Json& row : other["rows"])
    if (row["question"] == "samples for a fit" && row["choice"] == "1e4 samples")
      row["cost_ratio"] = 2 * row["cost_ratio"].get<double>();
  std::ofstream(folder_.path() / "other.json") << other;
  const Outcome apart = run("trade --compare " + ledger + " other.json");
  EXPECT_EQ(apart.exit_code, 1) << apart.err;
  EXPECT_THAT(apart.out, HasSubstr("1e4 samples"));
  EXPECT_EQ(run("trade --compare " + ledger + " nowhere.json").exit_code, 2);
}

TEST_F(Trade, RecommendsAModelWithItsPictures) {
  const Outcome o = run(kCloseUp + "--tolerance 0.2 --json -o out");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const io::Json json = io::Json::parse(o.out);
  EXPECT_LE(json.at("rendered_image_error").get<double>(), 0.2);
  EXPECT_LE(json.at("chosen").at("image_error").get<double>(), 0.2);
  for (const io::Json& c : json.at("candidates")) EXPECT_FALSE(c.at("reason").get<std::string>().empty());
  for (const char* file : {"material.json", "model.png", "reference.png", "difference.png", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
  EXPECT_EQ(run("albedo --material out/material.json --theta 0").exit_code, 0);
}

TEST_F(Trade, MeasuresWhatTheLedgerLacks) {
  io::Json ledger = io::Json::parse(file_text(kData + "ledger.json"));
  io::Json rows = io::Json::array();
  for (const io::Json& row : ledger["rows"])
    if (row["choice"] != "phong") rows.push_back(row);
  ledger["rows"] = rows;
  std::ofstream(folder_.path() / "old.json") << ledger;
  const Outcome o = run("recommend --scene '" + kData + "scenes/recommend_close_up.json' --reference '" +
                        kData + "materials/glossy_grey_paper.json' --ledger old.json --json");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const io::Json json = io::Json::parse(o.out);
  const std::string now = json.at("measured_now");
  EXPECT_EQ(now.find("old.json lacks some costs, which were measured now: "), 0u) << now;
  for (const io::Json& c : json.at("candidates")) {
    const auto of_form = [&](const io::Json& row) { return row["choice"] == c.at("form"); };
    const bool kept = std::any_of(rows.begin(), rows.end(), of_form);
    EXPECT_EQ(c.at("cost_measured").get<bool>(), !kept) << c.at("form");
    const std::string word = " " + c.at("form").get<std::string>() + ",";
    EXPECT_EQ((now + ",").find(word) != now.npos, !kept) << c.at("form") << " in " << now;
  }
}

TEST_F(Trade, SaysNoneWithExitCodeOne) {
  const Outcome o = run(kCloseUp + "--tolerance 1e-9");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, StartsWith("no candidate meets the tolerance 1e-09; the best candidate is ward"));
  EXPECT_EQ(run("recommend --tolerance 0.1").exit_code, 2);
}

}  // namespace
}  // namespace brdf
