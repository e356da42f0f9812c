// Tests the recommendation of a model for a scene, and the costs on which it is based.
#include "trade/recommend/recommend.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "brdf/forms.h"
#include "brdf/reflectance_of.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/temporary.h"
#include "trade/recommend/costs.h"

namespace brdf::trade {
namespace {

std::filesystem::path data(const std::string& name) {
  return std::filesystem::path(BRDF_SOURCE_DIR) / "data" / name;
}

// Returns whether the shipped ledger has this form. A form may be newer than the ledger.
bool in_shipped_ledger(const Reflectance& form) {
  static const Ledger ledger = read_ledger(data("ledger.json"));
  return std::any_of(ledger.rows.begin(), ledger.rows.end(),
                     [&](const LedgerRow& row) { return row.choice == info(form).name; });
}

RecommendOptions close_up() {
  RecommendOptions options;
  options.scene = data("scenes/recommend_close_up.json");
  options.reference = data("materials/glossy_grey_paper.json");
  options.tolerance = 0.05;
  return options;
}

TEST(Recommend, ACloseUpOfPaperNeedsNoAnisotropyAndNoGrazingAccuracy) {
  RecommendOptions options = close_up();
  options.ledger = data("ledger.json");  // costs that are the same on every machine
  for (const Reflectance& form : catalogue())
    if (info(form).canonical) options.models.push_back(form);
  std::erase_if(options.models, [&](const Reflectance& form) { return !in_shipped_ledger(form); });
  const Recommendation r = recommend(options);
  ASSERT_TRUE(r.chosen.has_value());
  EXPECT_LE(*shown(r).rendered_error, options.tolerance);
  EXPECT_EQ(info(r.candidates[*r.chosen].model).family, "ward");
  bool grazing = false, anisotropy = false;
  for (const std::string& s : r.unneeded) {
    grazing |= s.find("grazing accuracy is not needed") != std::string::npos;
    anisotropy |= s.find("anisotropy is not needed") != std::string::npos;
  }
  EXPECT_TRUE(grazing);
  EXPECT_TRUE(anisotropy);
  for (const Candidate& c : r.candidates) EXPECT_FALSE(c.anisotropic) << c.label();
  for (std::size_t k = 1; k < r.candidates.size(); ++k)
    EXPECT_LE(r.candidates[k - 1].cost_ns, r.candidates[k].cost_ns);
  for (const Candidate& c : r.candidates) EXPECT_FALSE(c.reason.empty()) << c.label();
}

TEST(Recommend, SaysNoneAndNamesTheBest) {
  RecommendOptions options = close_up();
  options.max_cost_ns = 1e-3;  // no form is that cheap
  options.models = {*find_form("lambert"), *find_form("ward"), *find_form("cook_torrance")};
  const Recommendation r = recommend(options);
  EXPECT_FALSE(r.chosen.has_value());
  for (const Candidate& c : r.candidates) EXPECT_GE(c.image_error, r.candidates[r.best].image_error);
  EXPECT_TRUE(to_json(r).at("chosen").is_null());
}

// This form is not in the catalogue: a plain power of the half vector's cosine.
struct plain_lobe : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "plain_lobe";
  static constexpr std::string_view family = "plain_lobe";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Exponent<S>& shape, const Geometry<G>& g) {
    return {S(1 / kPi), half_cosine_power(shape.exponent, g)};
  }
};

TEST(Recommend, TakesAReflectanceThatIsNotInTheCatalogue) {
  RecommendOptions options = close_up();
  options.models = {lambert{}, plain_lobe{}};
  options.ledger = data("ledger.json");
  const Recommendation r = recommend(options);
  ASSERT_EQ(r.candidates.size(), 2u);
  const std::size_t own = info(r.candidates[0].model).name == "plain_lobe" ? 0 : 1;
  EXPECT_EQ(r.candidates[own].label(), "plain_lobe");
  EXPECT_LT(r.candidates[own].image_error, 0.2 * r.candidates[1 - own].image_error);
  EXPECT_TRUE(r.candidates[own].cost_measured);
  EXPECT_FALSE(r.candidates[1 - own].cost_measured);
  EXPECT_NE(to_text(r).find("ledger.json lacks some costs, which were measured now: plain_lobe"),
            std::string::npos);
  EXPECT_FALSE(material_for_file(r.candidates[own]).has_value());
  EXPECT_TRUE(material_for_file(r.candidates[1 - own]).has_value());
}

TEST(Recommend, RefusesWhatCannotBeFitted) {
  RecommendOptions options = close_up();
  options.models = {ward_as_coded{}};
  EXPECT_THROW(recommend(options), InputError);
}

TEST(Costs, AreReadWhereTheLedgerHasTheRowAndMeasuredWhereNot) {
  Ledger ledger = read_ledger(data("ledger.json"));
  const std::vector<Reflectance> models = recommendable_models();
  const Costs whole = costs_of(models, ledger);
  for (std::size_t k = 0; k < models.size(); ++k)
    EXPECT_EQ(whole.measured[k], catalogue_index(models[k]) >= 0 && !in_shipped_ledger(models[k]));
  // The costs in the ledger are made ten times as high. Measured costs are given relative to the ledger, so
  // that they must rise, too.
  for (LedgerRow& row : ledger.rows) row.cost.seconds *= 10;
  std::erase_if(ledger.rows,
                [](const LedgerRow& row) { return row.choice == "ward" || row.choice == "masking dropped"; });
  const Costs costs = costs_of(models, ledger);
  for (std::size_t k = 0; k < models.size(); ++k) {
    const std::string_view name = info(models[k]).name;
    EXPECT_EQ(costs.measured[k], whole.measured[k] || name == "ward" || name == "masking dropped") << name;
    EXPECT_GT(costs.ns[k], 0) << name;
    if (whole.measured[k]) continue;  // a form newer than the ledger
    if (!costs.measured[k]) {
      EXPECT_NEAR(costs.ns[k], 10 * whole.ns[k], 1e-9 * costs.ns[k]) << name;
    } else {
      EXPECT_GT(costs.ns[k], 2 * whole.ns[k]) << name;  // only roughly: the machine differs and may be busy
    }
  }
}

TEST(Costs, OfALedgerOfAnotherVersionAreMeasured) {
  const io::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "of_tomorrow.json";
  io::write_file_atomically(path, R"({"format": "brdf-ledger", "version": 2, "rows": "otherwise"})");
  EXPECT_FALSE(read_current_ledger(path).has_value());
  EXPECT_THROW(read_ledger(path), InputError);
  RecommendOptions options = close_up();
  options.models = {lambert{}};
  options.ledger = path;
  const Recommendation r = recommend(options);
  EXPECT_TRUE(r.candidates[0].cost_measured);
  EXPECT_NE(to_text(r).find("is from another version, so all costs were measured now"), std::string::npos);
}

}  // namespace
}  // namespace brdf::trade
