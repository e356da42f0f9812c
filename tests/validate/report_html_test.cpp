// The page of a validation: questions of the checks, maps, verdict, and the choice of the lights that are
// shown.
#include <gtest/gtest.h>

#include "sheet/data_sheet.h"
#include "validate/report/report.h"

namespace brdf::validate {
namespace {

Finding finding(const char* subject, const char* check, Outcome outcome, const char* statement) {
  Finding f{subject, check};
  f.outcome = outcome;
  f.statement = statement;
  return f;
}

TEST(ValidatePage, EveryCheckSaysWhatItAsks) {
  for (const auto& names : {check_names(), sheet::data_sheet_names()})
    for (const std::string& name : names) EXPECT_TRUE(check_meaning(name).ends_with('.')) << name;
  EXPECT_EQ(check_meaning("unknown check"), "");
}

TEST(ValidatePage, PicturesHaveALineAndWhatDoesNotApplyIsFolded) {
  ReportContent content;
  content.subjects.push_back(
      Subject::material("/data/matt.material.json", make_material(*find_form("lambert"), {"f"})));
  content.findings = {finding("/data/matt.material.json", "energy", Outcome::pass, "reflects half"),
                      finding("/data/matt.material.json", "sampling", Outcome::not_applicable, "no sampler")};
  content.pictures = {{"pictures/matt.png", "\x89PNG"}};
  content.fits = {{"/data/matt.material.json", "median error 3 %"}};
  const std::string html = to_html(content);
  EXPECT_NE(html.find("<p class=\"title\">matt</p><figcaption class=\"good\">lambert; median error 3 %; "
                      "no violation found</figcaption>"),
            std::string::npos);
  const std::size_t fold = html.find("<summary>not applicable: 1</summary>");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_LT(html.find(">energy</button>"), fold);
  EXPECT_GT(html.find(">sampling</button>"), fold);
  EXPECT_NE(html.find("<h1>Validation of matt.material.json</h1>"), std::string::npos);
  EXPECT_NE(html.find("material: <code>/data/matt.material.json</code>"), std::string::npos);
  // Reciprocal to the last bit: a map would have a single colour, so the page has no map.
  EXPECT_NE(html.find("Reciprocity: exact."), std::string::npos);
  EXPECT_EQ(html.find("class=\"map\""), std::string::npos);
}

TEST(ValidatePage, OneFailureTurnsTheVerdict) {
  ReportContent content;
  content.subjects.push_back(Subject::material("a.json", make_material(*find_form("lambert"), {"f"})));
  content.findings = {finding("a.json", "energy", Outcome::fail, "reflects too much"),
                      finding("a.json", "sampling", Outcome::not_applicable, "no sampler")};
  EXPECT_NE(to_html(content).find("<p class=\"verdict bad\">"), std::string::npos);
  content.findings[0].outcome = Outcome::undecided;
  EXPECT_NE(to_html(content).find("<p class=\"verdict warn\">"), std::string::npos);
  content.findings[0].outcome = Outcome::pass;
  EXPECT_NE(to_html(content).find("<p class=\"verdict good\">"), std::string::npos);
}

TEST(ValidatePage, OfManyLightsEightAreShownFromTheFirstToTheLast) {
  io::SampleTable table;
  table.channels = {"f"};
  table.values.resize(1);
  table.sigma.resize(1);
  table.source = "scan.csv";
  for (int theta_i = 5; theta_i <= 80; theta_i += 5)
    for (int theta_o = 0; theta_o <= 80; theta_o += 10) {
      table.add_directions(theta_i, 0, theta_o, 180);
      table.values[0].push_back(0.2);
      table.lines.push_back(std::uint32_t(table.lines.size() + 2));
    }
  io::HtmlReport report("sheet");
  sheet::add_to_report(report, table, sheet::data_sheet(table));
  const std::string html = report.document({});
  // The page states "8 of 16 angles of incidence shown" from these; the reader switches the others on.
  EXPECT_NE(html.find("\"counted\":\"angles of incidence\",\"all\":16"), std::string::npos);
  const auto is_hidden = [&](int light) {
    const std::size_t at = html.find("incidence at " + std::to_string(light) + " degrees\"");
    EXPECT_NE(at, std::string::npos) << light;
    return html.find("\"hidden\":true", at) < html.find("\"label\"", at);
  };
  int hidden = 0;
  for (int light = 5; light <= 80; light += 5) hidden += is_hidden(light);
  EXPECT_EQ(hidden, 8);
  EXPECT_FALSE(is_hidden(5));
  EXPECT_TRUE(is_hidden(10));
  EXPECT_FALSE(is_hidden(80));
}

}  // namespace
}  // namespace brdf::validate
