#include <gtest/gtest.h>

#include <set>

#include "trade/recommend/recommend.h"

namespace brdf::trade {
namespace {

const std::filesystem::path kData = std::filesystem::path(BRDF_SOURCE_DIR) / "data";

TEST(ShippedScenes, TolerancesAreMetAndSmallerOnesAreNeverCheaper) {
  const struct {
    const char *scene, *reference;
  } cases[] = {{"recommend_close_up", "glossy_grey_paper"},
               {"recommend_grazing", "rolled_brass"},
               {"recommend_distant", "article_glass"}};
  std::set<std::string> answers;
  for (const auto& c : cases) {
    double cost = 1e300;
    for (double tolerance : {0.01, 0.05, 0.2}) {
      RecommendOptions options;
      options.scene = kData / "scenes" / (std::string(c.scene) + ".json");
      options.reference = kData / "materials" / (std::string(c.reference) + ".json");
      options.ledger = kData / "ledger.json";
      options.tolerance = tolerance;
      const Recommendation r = recommend(options);
      if (!r.chosen) {
        answers.insert("none");
        continue;
      }
      const Candidate& chosen = r.candidates[*r.chosen];
      answers.insert(chosen.label());
      EXPECT_LE(*shown(r).rendered_error, tolerance) << c.scene;
      EXPECT_LE(chosen.cost_ns, cost) << c.scene;
      cost = chosen.cost_ns;
    }
  }
  EXPECT_GE(answers.size(), 3u);
}

TEST(ShippedScenes, TheScenesWeightingWinsAtHeldOutPositions) {
  int better = 0;
  const auto rows =
      compare_held_out(kData / "scenes", kData / "materials", [](double, const std::string&) {});
  for (const HeldOut& row : rows) better += row.scene_weighted < row.hemisphere_wide;
  EXPECT_EQ(rows.size(), 10u);
  EXPECT_GE(better, 8);
}

}  // namespace
}  // namespace brdf::trade
