// Findings for continuous integration: accepted findings, JUnit and SARIF.
#include "validate/report/continuous.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/error.h"
#include "validate/form/checks.h"

namespace brdf::validate {
namespace {

using testing::HasSubstr;
using testing::Not;

// Two files: one is unsound in two ways, the other one is sound, with a check that had no time.
std::vector<Finding> found() {
  return {{.subject = "lib/a b.glsl",
           .check = "energy",
           .outcome = Outcome::fail,
           .statement = "directional albedo up to 1.2 <at 80>",
           .witness = Witness{{}, {}, "", "brdf albedo --shader 'lib/a b.glsl'"}},
          {.subject = "lib/a b.glsl",
           .check = "finite",
           .outcome = Outcome::fail,
           .statement = "f is no number; line 12, `x / y`: 0 / 0"},
          {.subject = "c.glsl", .check = "energy", .statement = "at most 0.9"},
          {.subject = "c.glsl", .check = "finite", .outcome = Outcome::undecided, .statement = "no time"},
          {.subject = "c.glsl", .check = "albedo", .outcome = Outcome::not_applicable, .statement = "-"}};
}

std::string message_of(const io::Json& json) {
  try {
    Baseline(json, "accepted.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(Baseline, AcceptsFindingsByFileAndCheck) {
  std::vector<Finding> findings = found();
  const Baseline accepted(Baseline().updated(findings).to_json(), "accepted.json");
  findings[0].statement = "directional albedo up to 1.3";  // the value may change
  for (const Finding& f : findings) EXPECT_FALSE(is_new(f, accepted)) << f.check;
  EXPECT_TRUE(is_new(findings[0], Baseline()));
  findings[0].subject = "lib/other.glsl";
  EXPECT_TRUE(is_new(findings[0], accepted));
}

// A finding that was not looked for again is not known to be gone.
TEST(Baseline, NamesEntriesThatNoLongerFail) {
  std::vector<Finding> findings = found();
  const Baseline accepted = Baseline().updated(findings);
  EXPECT_TRUE(accepted.obsolete(findings).empty());
  findings[0].outcome = Outcome::pass;
  EXPECT_EQ(accepted.obsolete(findings), (std::vector<Baseline::Entry>{{"lib/a b.glsl", "energy"}}));
  findings[0].outcome = Outcome::undecided;
  EXPECT_TRUE(accepted.obsolete(findings).empty());
  EXPECT_TRUE(accepted.obsolete({findings[2]}).empty());  // of another file
  const Finding unreadable{
      .subject = "lib/a b.glsl", .check = std::string(kReadable), .outcome = Outcome::fail, .statement = "?"};
  EXPECT_TRUE(accepted.obsolete({unreadable}).empty());
}

// A run over a part of the files loses no entry of the others.
TEST(Baseline, KeepsEntriesThatARunDidNotDecide) {
  std::vector<Finding> findings = found();
  const Baseline accepted = Baseline().updated(findings);
  const Finding other{.subject = "d.glsl", .check = "energy", .outcome = Outcome::fail, .statement = "1.1"};
  const Baseline more = accepted.updated({other});
  EXPECT_TRUE(more.accepts(findings[0]) && more.accepts(findings[1]) && more.accepts(other));
  findings[0].outcome = Outcome::undecided;
  findings[1].outcome = Outcome::pass;
  const Baseline less = more.updated(findings);
  EXPECT_TRUE(less.accepts(findings[0]) && less.accepts(other));
  EXPECT_FALSE(less.accepts(findings[1]));
}

TEST(Baseline, ThatIsDamagedIsRefusedWithItsPlace) {
  io::Json json = Baseline().updated(found()).to_json();
  EXPECT_EQ(message_of(json), "read");
  io::Json damaged = json;
  damaged["accepted"][1].erase("check");
  EXPECT_THAT(message_of(damaged), HasSubstr("accepted.json: $.accepted[1]: must have a file and a check"));
  damaged = json;
  damaged["version"] = 2;
  EXPECT_THAT(message_of(damaged), HasSubstr("$.version: must be 1"));
  EXPECT_THAT(message_of(io::Json::array()), HasSubstr("$.format"));
}

TEST(Junit, CountsFailuresAndSkipsWhatIsAcceptedOrUndecided) {
  const std::string all = to_junit(found(), {});
  EXPECT_THAT(
      all,
      HasSubstr(
          "<testsuites name=\"brdf check-shader\" tests=\"4\" failures=\"2\" errors=\"0\" skipped=\"1\">"));
  EXPECT_THAT(all, HasSubstr("<testsuite name=\"lib/a b.glsl\" tests=\"2\" failures=\"2\""));
  EXPECT_THAT(all, HasSubstr("<failure message=\"directional albedo up to 1.2 &lt;at 80&gt;\">"));
  EXPECT_THAT(all, HasSubstr("$ brdf albedo --shader"));
  EXPECT_THAT(all, HasSubstr("<skipped message=\"undecided: no time\"/>"));
  EXPECT_THAT(all, Not(HasSubstr("name=\"albedo\"")));
  const std::string none = to_junit(found(), Baseline().updated(found()));
  EXPECT_THAT(none, HasSubstr("tests=\"4\" failures=\"0\" errors=\"0\" skipped=\"3\">"));
  EXPECT_THAT(none, HasSubstr("<skipped message=\"accepted: directional"));
}

TEST(Sarif, HasARuleForEachCheckAndAPlaceForEachFinding) {
  std::vector<Finding> findings = found();
  const io::Json log = to_sarif(findings, Baseline().updated({findings[1]}));
  EXPECT_EQ(log["version"], "2.1.0");
  const io::Json& run = log["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), check_names().size() + 1);
  for (const io::Json& rule : run["tool"]["driver"]["rules"])
    EXPECT_FALSE(rule["shortDescription"]["text"].get<std::string>().empty()) << rule["id"];
  const io::Json& results = run["results"];
  ASSERT_EQ(results.size(), 3u);  // a passed check is no result
  const auto place = [&](int k) { return results[k]["locations"][0]["physicalLocation"]; };
  EXPECT_EQ(place(0)["artifactLocation"]["uri"], "lib/a%20b.glsl");
  EXPECT_FALSE(place(0).contains("region"));
  EXPECT_EQ(place(1)["region"]["startLine"], 12);
  findings[0].statement = "as bright as a polyline 4 degrees apart";  // names no line
  EXPECT_FALSE(
      to_sarif(findings, {})["runs"][0]["results"][0]["locations"][0]["physicalLocation"].contains("region"));
  EXPECT_EQ(results[0]["baselineState"], "new");
  EXPECT_EQ(results[1]["baselineState"], "unchanged");
  EXPECT_EQ(results[2]["kind"], "open");
  EXPECT_EQ(results[2]["level"], "none");
}

}  // namespace
}  // namespace brdf::validate
