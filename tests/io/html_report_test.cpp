#include "io/html_report.h"

#include <gtest/gtest.h>

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

TEST(Png, OfPixelsHasTheirSize) {
  const std::string png = png_of_pixels(3, 2, std::vector<unsigned char>(18, 128));
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[19], 3);
  EXPECT_EQ(png[23], 2);
}

}  // namespace
}  // namespace brdf::io
