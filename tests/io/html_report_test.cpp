// Tests the pages of reports and their glossary.
#include "io/page/html_report.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "io/files/base64.h"
#include "io/files/json.h"
#include "io/files/png.h"
#include "io/page/glossary.h"

namespace brdf::io {
namespace {

Plot line_plot() {
  Plot plot;
  plot.title = "albedo </script> & angle";
  plot.series = {{"a", {1, 2, 3}, {0.1, 0.0 / 0.0, 0.3}}};
  return plot;
}

TEST(HtmlReport, HoldsEverythingInOneFile) {
  HtmlReport report("a <title>");
  report.table({"check"}, {{{"energy > 1", Mark::bad}}});
  report.plot(line_plot());
  const std::string html = report.document({"1.0", "brdf validate", 3});
  EXPECT_NE(html.find("<h1>a &lt;title&gt;</h1>"), std::string::npos);
  EXPECT_NE(html.find("energy &gt; 1"), std::string::npos);
  EXPECT_NE(html.find("new Chart("), std::string::npos);
  EXPECT_EQ(html.find("src=\"http"), std::string::npos);
  EXPECT_EQ(html.find("href=\"http"), std::string::npos);
}

TEST(HtmlReport, DataCannotEndTheScript) {
  HtmlReport report("t");
  report.plot(line_plot());
  const std::string html = report.document({"1.0", "", {}});
  EXPECT_EQ(html.find("albedo </script>"), std::string::npos);
}

TEST(HtmlReport, DataHoldNoMarkupOfTheScriptElement) {
  HtmlReport report("t");
  Plot plot = line_plot();
  plot.series[0].label = "<!--<script>";
  report.plot(plot);
  const std::string html = report.document({"1.0", "", {}});
  EXPECT_EQ(html.find("<!--<"), std::string::npos);
  EXPECT_NE(html.find("\\u003c!--\\u003cscript>"), std::string::npos);
}

TEST(HtmlReport, LeavesGapsWhereThereIsNoNumber) {
  HtmlReport report("t");
  report.plot(line_plot());
  EXPECT_NE(report.document({"1.0", "", {}}).find("[0.1,null,0.3]"), std::string::npos);
}

TEST(HtmlReport, EmbedsPictures) {
  HtmlReport report("t");
  report.picture("abc", "caption");
  EXPECT_NE(report.document({"1.0", "", {}}).find("data:image/png;base64,YWJj\""), std::string::npos);
  HtmlReport padded("t");
  padded.picture("abcd", "caption");
  EXPECT_NE(padded.document({"1.0", "", {}}).find("base64,YWJjZA==\""), std::string::npos);
}

int count_of(const std::string& text, std::string_view what) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += what.size()) ++count;
  return count;
}

// Returns the page without its style and scripts.
std::string body_of(const HtmlReport& report) {
  const std::string html = report.document({"1.0", "", {}});
  const std::size_t begin = html.find("<body>");
  return html.substr(begin, html.find("<script>", begin) - begin);
}

TEST(HtmlReport, CommandsAreFolded) {
  HtmlReport report("t");
  report.command("brdf a < b");
  report.table({"x"}, {{{"1", Mark::none, false, "brdf c"}}});
  EXPECT_EQ(count_of(body_of(report), "<details class=\"commands\"><summary>command</summary><pre>brdf"), 2);
  HtmlReport none("t");
  none.command("");
  EXPECT_EQ(body_of(none).find("<details"), std::string::npos);
}

TEST(HtmlReport, FoldsEndWhatTheyBegin) {
  HtmlReport report("t");
  report.begin_fold("more <than> this");
  report.paragraph("inside");
  EXPECT_THROW(report.document({"1.0", "", {}}), std::logic_error);
  report.end_fold();
  EXPECT_THROW(report.end_fold(), std::logic_error);
  const std::string html = body_of(report);
  EXPECT_LT(html.find("<summary>more &lt;than&gt; this</summary>"), html.find("<p>inside</p>"));
  EXPECT_LT(html.find("<p>inside</p>"), html.find("</details>"));
}

TEST(HtmlReport, PicturesStandInARowWithTheirLine) {
  HtmlReport report("t");
  report.pictures(
      {{"abc", "copper", "median error 3 %", Mark::good, "copper/index.html"}, {"abcd", "plaster"}});
  const std::string html = body_of(report);
  EXPECT_EQ(count_of(html, "<div class=\"row\">"), 1);
  EXPECT_EQ(count_of(html, "<figure>"), 2);
  EXPECT_NE(html.find("<figcaption class=\"good\">median error 3 %</figcaption>"), std::string::npos);
  EXPECT_EQ(count_of(html, "<a href=\"copper/index.html\">"), 2);  // the picture and its name
}

// A body keeps its picture for browsers without scripts, and only pages with bodies get the script.
TEST(HtmlReport, ABodyTurnsInPlaceOfItsPicture) {
  Body body{.rings = 2, .sectors = 2, .points = std::vector<Body::Point>(4, {0.5, {1, 2, 3}})};
  body.dots = {{90, -90, 1}};
  HtmlReport still("t"), turning("t");
  still.pictures({{"abc", "lobe"}});
  turning.pictures({{.png = "abc", .title = "lobe", .body = body}, {"abcd", "plaster"}});
  const std::string html = turning.document({"1.0", "", {}});
  EXPECT_EQ(count_of(html, "<figure class=\"body\">"), 1);
  EXPECT_EQ(count_of(html, "<img "), 2);
  EXPECT_EQ(count_of(html, "class Body"), 1);
  EXPECT_EQ(count_of(still.document({"1.0", "", {}}), "class Body"), 0);
  const Json json = Json::parse(body_json(body));
  EXPECT_EQ(json["points"],
            base64(std::string("\x80\x01\x02\x03\x80\x01\x02\x03\x80\x01\x02\x03\x80\x01\x02\x03", 16)));
  EXPECT_EQ(json["dots"], base64(std::string("\xff\xff\xff\xbf\xff\xff", 6)));  // azimuth 270 of 360
}

TEST(HtmlReport, AFactThatIsNotStatedSaysSo) {
  HtmlReport report("t");
  report.facts({{"date", ""}, {"operator", "A & B"}, {"", "3 channels"}});
  const std::string html = body_of(report);
  EXPECT_NE(html.find("<li>date: <i>not stated</i></li>"), std::string::npos);
  EXPECT_NE(html.find("<li>operator: <b>A &amp; B</b></li>"), std::string::npos);
  EXPECT_NE(html.find("<li><b>3 channels</b></li>"), std::string::npos);
}

// Readers without colour vision need a sign, a shape and a word that differ.
TEST(HtmlReport, MarksDifferInMoreThanTheirColour) {
  std::set<std::string_view> words, signs, shapes, colours;
  for (const Mark mark : {Mark::good, Mark::unknown, Mark::warn, Mark::bad}) {
    const MarkLook& look = look_of(mark);
    EXPECT_EQ(look.mark, mark);
    EXPECT_FALSE(look.word.empty());
    words.insert(look.word);
    signs.insert(look.sign);
    shapes.insert(look.shape);
    colours.insert(look.terminal);
    EXPECT_NE(mark_style().find("." + std::string(kNames<Mark>[std::size_t(mark)]) + "::before"),
              std::string::npos);
    EXPECT_NE(body_of(HtmlReport("t")).find(">" + std::string(look.word) + "</span>"), std::string::npos);
  }
  for (const auto& kinds : {words, signs, shapes, colours}) EXPECT_EQ(kinds.size(), 4u);
}

TEST(HtmlReport, AMatrixFoldsWhatAppliesToNoSubject) {
  HtmlReport report("t");
  report.matrix({"property",
                 {"a", "b"},
                 {{"first", {{"pass", Mark::good}, {"n/a", Mark::absent}}},
                  {"second", {{"n/a", Mark::absent}, {"n/a", Mark::absent}}}}});
  const std::string html = body_of(report);
  const std::size_t fold = html.find("<summary>not applicable: 1</summary>");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_LT(html.find(">first<"), fold);
  EXPECT_GT(html.find(">second<"), fold);
  EXPECT_EQ(count_of(html, "<th scope=\"row\">"), 2);
}

TEST(HtmlReport, AMatrixOfManySubjectsIsWrittenDownwards) {
  Matrix matrix{"property", {}, {{"first", {}}}};
  for (int k = 0; k < 9; ++k) {
    matrix.subjects.push_back("subject " + std::to_string(k));
    matrix.rows[0].cells.push_back({std::to_string(k), k ? Mark::good : Mark::absent});
  }
  HtmlReport report("t");
  report.matrix(matrix);
  EXPECT_EQ(count_of(body_of(report), "<th scope=\"row\">subject"), 9);
}

TEST(HtmlReport, WordsOfTheGlossaryExplainThemselves) {
  HtmlReport report("t");
  report.table({"BIC", "colour"}, {});
  report.paragraph("The angle theta_h, and theta_h again; the front of the house.");
  report.explain("colour", "what the eye sees");
  report.table({"colour"}, {});
  const std::string html = body_of(report);
  EXPECT_EQ(count_of(html, "<button type=\"button\" class=\"term\""),
            3);  // not "front": a word in running text
  EXPECT_EQ(count_of(html, ">theta_h</button>"), 1);
  EXPECT_EQ(count_of(html, "<div popover id=\"term"), 3);
  EXPECT_NE(html.find("<dt>colour</dt><dd>what the eye sees</dd>"), std::string::npos);
  EXPECT_EQ(count_of(html, "popovertarget=\"term2\""), 1);
}

TEST(HtmlReport, WhatIsExactStandsAtTheEdgeOfALogarithmicAxis) {
  HtmlReport report("t");
  Plot plot = line_plot();
  plot.series = {{"", {1, 2, 3}, {0, 1e-17, 3e-4}, Series::Style::points}};
  plot.log_y = true;
  plot.bottom_edge = BottomEdge{"exact"};
  report.plot(plot);
  const std::string html = report.document({"1.0", "", {}});
  const std::size_t begin = html.find("const plots = [") + 15;
  const Json json = parse_json(html.substr(begin, html.find("\n];") - begin), "plots");
  EXPECT_NEAR(double(json["series"][0]["y"][0]), 1e-5, 1e-12);
  EXPECT_NEAR(double(json["series"][0]["y"][1]), 1e-5, 1e-12);
  EXPECT_NEAR(double(json["series"][0]["y"][2]), 3e-4, 1e-12);
  EXPECT_EQ(json["bottom_edge"]["label"], "exact");
  EXPECT_NEAR(double(json["bottom_edge"]["at"]), 1e-5, 1e-12);
}

TEST(HtmlReport, TakesBlocksOfOnesOwn) {
  HtmlReport report("t");
  report.raw("<canvas id=\"own\"></canvas>");
  report.style("#own { width: 9rem }");
  report.script("draw();");
  report.footnote("samples", "/data/a <b>.csv");
  const std::string html = report.document({"1.0", "", {}});
  EXPECT_NE(html.find("<canvas id=\"own\"></canvas>"), std::string::npos);
  EXPECT_LT(html.find("#own { width"), html.find("</style>"));
  EXPECT_GT(html.find("draw();"), html.find("</footer>"));
  EXPECT_NE(html.find("samples: <code>/data/a &lt;b&gt;.csv</code>"), std::string::npos);
}

TEST(HtmlReport, CellsLinkShowAndSort) {
  HtmlReport report("t");
  Cell cell{"copper"};
  cell.link = "copper/index.html";
  cell.png = "abc";
  cell.sorted_by = 0.25;
  report.table({"sample"}, {{cell}}, true);
  const std::string html = body_of(report);
  EXPECT_NE(html.find("<table class=\"sortable\">"), std::string::npos);
  EXPECT_NE(html.find("<td data-value=\"0.25\">"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"copper/index.html\">copper</a>"), std::string::npos);
}

TEST(HtmlReport, ATitleShowsAFilesNameWithoutItsPath) {
  EXPECT_EQ(file_name("/data/measured/copper.csv"), "copper.csv");
  EXPECT_EQ(file_name("copper.csv"), "copper.csv");
  EXPECT_EQ(file_name("folder/"), "folder/");
}

TEST(Glossary, ExplainsTheParametersOfEveryForm) {
  for (const Reflectance& form : catalogue())
    for (const auto& table : {form.info().shape, form.info().weights})
      for (const ParameterInfo& p : table) {
        ASSERT_NE(glossary_term(p.name), nullptr) << p.name;
        EXPECT_GT(plain_name(form.info(), p).size(), 3u) << p.name;
      }
}

TEST(Glossary, ListsNoWordTwiceAndEndsItsSentences) {
  std::set<std::string> words;
  for (const GlossaryTerm& t : glossary()) {
    EXPECT_TRUE(words.insert(t.term).second) << t.term;
    EXPECT_TRUE(t.meaning.ends_with('.')) << t.meaning;
  }
}

TEST(Png, OfPixelsHasTheirSize) {
  const std::string png = png_of_pixels(3, 2, std::vector<unsigned char>(18, 128));
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[19], 3);
  EXPECT_EQ(png[23], 2);
  EXPECT_EQ(png[25], 2);                                                       // RGB
  EXPECT_EQ(png_of_pixels(3, 2, std::vector<unsigned char>(24, 128))[25], 6);  // RGBA
}

}  // namespace
}  // namespace brdf::io
