#include "trade/questions/claims.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "brdf/forms.h"
#include "brdf/integrals.h"
#include "io/files/numbers.h"
#include "trade/questions/materials.h"

namespace brdf::trade {
namespace {

using io::short_number;

constexpr const char* kThesis = "the thesis";
constexpr const char* kLookup = "the lookup-texture article";
constexpr const char* kShading = "the pixel-shader article";

using ClaimRows = std::vector<const LedgerRow*>;

// The figure that decides a claim, and text for the evidence.
struct Found {
  double figure;
  std::string words = {};
};
using Find = Found (*)(const ClaimRows& rows, const Ledger& ledger);

struct ClaimRule {
  // Either a field of the first row, by its name below, or the result of a function.
  struct Figure {
    Figure(const char* of_row) : field(of_row) {}
    Figure(Find function) : find(function) {}
    const char* field = "";
    Find find = nullptr;
  };
  struct Verdict {
    Standing standing;
    const char* words;
  };
  struct Below {
    double bound;
    Verdict verdict;
  };
  const char *source, *claim;
  std::vector<RowName> rows;  // the first is the claim's row
  Figure figure;
  std::vector<Below> below;  // the first bound above the figure gives the verdict
  Verdict otherwise;
  // Placeholders: {figure}, {words}; for the first row {cost}, {ms}, {max}, {mean}, {image}, {where},
  // {note}; for the second row {cost 1}, ...
  const char* evidence;
};

// --- Figures that no row holds -----------------------------------------------------------------------------

// Returns f_r of a grey material. Angles are in degrees.
double value(const Material& m, double theta_i, double theta_o, double phi) {
  double f = 0;
  eval(m, direction(degrees(theta_i), {}), direction(degrees(theta_o), degrees(phi)), std::span(&f, 1));
  return f;
}

Material grey(const Reflectance& form, Role shape, double size) {
  Material m = make_material(form, {"fr"});
  set_parameter(m, shape, size);
  return m;
}

Material lobe_only(const Reflectance& form, Role shape, double size) {
  Material m = grey(form, shape, size);
  set_parameter(m, Role::diffuse, 0);
  set_parameter(m, Role::specular, 1);
  return m;
}

// Returns the width of the listing's lobe at 90 % of its value in the mirror direction: the width across the
// plane of incidence divided by the width along it.
double ward_aspect() {
  Material m = make_material(ward_as_coded{}, {"fr"});
  for (std::size_t k = 0; k < info(ward_as_coded{}).shape.size(); ++k)
    if (info(ward_as_coded{}).shape[k].map == Map::metallic) m.terms[0].shape[0][k] = 1;
  const Vec3<double> wi = direction(degrees(60), {}), mirror{-wi.x, -wi.y, wi.z};
  const Vec3<double> along{-wi.z, 0, -wi.x}, across{0, 1, 0};
  const auto f = [&](const Vec3<double>& wo) {
    double value = 0;
    eval(m, wi, wo, std::span(&value, 1));
    return value;
  };
  const auto width = [&](const Vec3<double>& axis) {
    double t = 0;
    while (t < 1.5 && f(mirror * std::cos(t) + axis * std::sin(t)) > 0.9 * f(mirror)) t += 1e-3;
    return t;
  };
  return width(across) / std::min(width(along), width(along * -1.0));
}

// Returns the mean image error of every family on the materials of the other families.
std::map<std::string, double> errors_on_others(const Ledger& ledger) {
  std::map<std::string, double> sums, counts;
  for (const LedgerRow& row : ledger.rows)
    if (row.question.starts_with(names::families("")) && row.choice != row.exact && row.image_error)
      if (const auto form = find_form(row.choice); form && info(*form).canonical)
        sums[row.choice] += *row.image_error, ++counts[row.choice];
  for (auto& [name, sum] : sums) sum /= counts[name];
  return sums;
}

// --- What decides ------------------------------------------------------------------------------------------

Found peaks(const ClaimRows&, const Ledger&) {
  const double mirror = value(lobe_only(phong{}, Role::exponent, 20), 0, 0, 180);
  const double half = value(lobe_only(blinn_phong{}, Role::exponent, 20), 0, 0, 180);
  return {half / mirror, short_number(half) + " against " + short_number(mirror)};
}
Found aspect(const ClaimRows&, const Ledger&) {
  const double ratio = ward_aspect();
  return {std::abs(ratio - 1), short_number(ratio)};
}
Found grazing_albedo(const ClaimRows&, const Ledger&) {
  Material m = grey(oren_nayar{}, Role::slope, 0.198533);
  set_parameter(m, Role::diffuse, 1);
  return {directional_albedo(m.terms[0], 0, degrees(90), {}).value};
}
Found limb_over_centre(const ClaimRows&, const Ledger&) {
  const Material m = grey(oren_nayar{}, Role::slope, 0.5);
  return {value(m, 80, 80, 0) / value(m, 0, 0, 0)};
}
Found oblique_over_frontal(const ClaimRows&, const Ledger&) {
  const Material m = lobe_only(named_form(names::kArticleForm), Role::index, 1.5);
  return {value(m, 60, 60, 180) * 0.5 / value(m, 0, 0, 180)};
}
// Returns the difference between the claimed family and the best family, on the materials of other families.
Found behind_the_best(const ClaimRows& rows, const Ledger& ledger) {
  std::map<std::string, double> errors = errors_on_others(ledger);
  std::string best = rows[0]->choice;
  for (const auto& [name, error] : errors)
    if (error < errors[best]) best = name;
  const double claimed = errors[rows[0]->choice];
  return {claimed - errors[best], rows[0]->choice + " " + short_number(claimed) + ", the best is " + best +
                                      " with " + short_number(errors[best])};
}

// --- Evidence ----------------------------------------------------------------------------------------------

double number_of(const LedgerRow& row, std::string_view name) {
  return name == "cost"   ? row.cost_ratio
         : name == "ms"   ? row.cost.seconds * 1e3
         : name == "max"  ? row.error.max
         : name == "mean" ? row.error.mean
                          : row.image_error.value_or(0);
}

std::string field_of(const LedgerRow& row, std::string_view name) {
  if (name == "where") return row.error.where;
  return name == "note" ? row.note : short_number(number_of(row, name));
}

std::string filled(std::string_view text, const ClaimRows& rows, const Found& found) {
  std::string out;
  for (std::size_t brace = text.find('{'); brace != text.npos; brace = text.find('{')) {
    const std::size_t end = text.find('}');
    const std::string_view field = text.substr(brace + 1, end - brace - 1),
                           name = field.substr(0, field.find(' '));
    const std::size_t row = name == field ? 0 : std::size_t(field.back() - '0');
    out += text.substr(0, brace);
    out += name == "figure"  ? short_number(found.figure)
           : name == "words" ? found.words
                             : field_of(*rows[row], name);
    text.remove_prefix(end + 1);
  }
  return out += text;
}

std::vector<RowName> shading_rows(int triangles) {
  std::vector<RowName> rows;
  for (const char* way : {names::kPhongAsCoded, names::kGouraud, names::kPhong})
    rows.push_back({names::kDiffuseShading, names::triangles(triangles, way)});
  return rows;
}

const std::vector<ClaimRule>& claim_rules() {
  using namespace names;
  const std::string reference(kReferenceForm), diffuse(kDiffuseForm);
  constexpr ClaimRule::Verdict kHolds{Standing::holds, "holds"}, kFails{Standing::fails, "does not hold"};
  // clang-format off
  static const std::vector<ClaimRule> rules{
      {kThesis, "the half vector is cheaper than the mirror direction", {{kMirror, kEqualHalfVector}},
       "cost", {{0.95, kHolds}, {1.05, {Standing::fails, "no difference"}}}, kFails,
       "costs {cost} times the mirror direction: the half vector must be normalised, whereas the cosine of the mirror direction needs no root"},
      {kThesis, "Blinn-Phong's highlight is dimmer than Phong's at equal n", {{kMirror, kEqualHalfVector}},
       peaks, {{1, {Standing::on_condition, "holds for normalised lobes"}}}, kFails,
       "peaks at n = 20: {words} 1/sr; as printed, without normalisation, both peaks are 1 and Blinn-Phong's highlight is wider, so brighter in total"},
      {kThesis, "Ward's highlight looks elliptical even with both constants 1", {{families("ward"), "ward"}},
       aspect, {{0.1, kFails}}, kHolds,
       "the listing's lobe at 60 degrees is {words} times as wide across the plane of incidence as along it"},
      {kThesis, "Oren-Nayar conserves energy", {{families("oren_nayar"), "oren_nayar"}},
       grazing_albedo, {{1 + 1e-6, kHolds}}, kFails,
       "albedo {figure} at rho 1, sigma 0.1985 rad, grazing light"},
      {kThesis, "Oren-Nayar brightens towards the limb", {{families("oren_nayar"), "oren_nayar"}},
       limb_over_centre, {{1.05, kFails}}, kHolds,
       "light from the viewer, sigma 0.5: f at 80 degrees is {figure} times f at normal incidence"},
      {kThesis, "Lambert or Oren-Nayar suffice where physics matters less", {{families(reference), diffuse}},
       "", {}, {Standing::on_condition, "depends on the tolerance"},
       "Lambert fitted to cook_torrance: image error {image} at {cost} of the cost"},
      {kThesis, "Cook-Torrance is the most realistic", {{families("ward"), reference}},
       behind_the_best, {{1e-12, {Standing::on_condition, "holds among the families"}}}, kFails,
       "mean image error on the other families' materials: {words}; real materials were not tested"},
      {kThesis, "parameters are fitted from goniometer samples by optimisation",
       {{kSampleCounts, kThousandSamples}},
       "mean", {{0.02, kHolds}}, kFails,
       "1000 samples with 5 % noise give f within {mean} on average in {ms} ms"},
      {kThesis, "deferred rendering allows many more lights",
       {{lights(64), kDeferred16}, {lights(1), kDeferred16}},
       "cost", {{0.95, kHolds}}, kFails,
       "a frame costs {cost} of forward's at 64 lights, {cost 1} at one"},
      {kThesis, "16-bit targets are needed for vectors", {{bits(0.05), kEightBits}, {bits(0.3), kEightBits}},
       "max", {{0.05, kFails}}, {Standing::on_condition, "holds for narrow highlights"},
       "8 bits: image error {image}, largest {max} at alpha 0.05; {image 1} at alpha 0.3"},
      {kShading, "Phong and Gouraud shading look alike", shading_rows(5120),
       "", {}, {Standing::on_condition, "holds because the normal is not renormalised"},
       "as coded: {note}; Gouraud: {note 1}; with unit normals: {note 2}"},
      {kShading, "Phong and Gouraud shading look alike", shading_rows(320),
       "", {}, {Standing::on_condition, "holds because the normal is not renormalised"},
       "as coded: {note}; Gouraud: {note 1}; with unit normals: {note 2}"},
      {kShading, "the half vector of the code is a half vector",
       {{kHighlightShading, triangles(5120, kHighlightAsCoded)}},
       "", {}, kFails,
       "the light vector has length sqrt(3), so the error of h is 7.9 degrees: largest error {max} of a highlight of 0.75"},
      {kLookup, "H = N is adequate because the lobe is strong there", {{lookup(0.3), kCollapsed}},
       "image", {{0.02, {Standing::on_condition, "holds in the picture, not at grazing angles"}}}, kFails,
       "image error {image}; largest error {max} 1/sr at {where}"},
      {kLookup, "the lookup texture is fast", {{lookup(0.3), texels(512, 8, "nearest")}},
       "cost", {{0.95, kHolds}}, {Standing::fails, "does not hold on a CPU"},
       "costs {cost} times the exact evaluation in batches"},
      {kLookup, "G is cancelled by D and meaningless",
       {{kMaskingByAlbedo, kMaskingDropped}, {kMasking, kMaskingDropped}},
       "", {}, {Standing::fails, "does not hold at grazing angles"},
       "without G the albedo is up to {max} too large ({where}); image error on the ball {image 1}"},
      {kLookup, "the reflection is weaker where the light is frontal", {{lookup(0.3), names::kExact}},
       oblique_over_frontal, {{1, kFails}}, kHolds,
       "mirror direction at 60 degrees against normal incidence: f cos_i is {figure} times as large"},
      {kLookup, "its Fresnel term, as coded", {{kFresnelOfGlass, kSlip}},
       "", {}, {Standing::fails, "wrong"},
       "up to {max} too large, image error {image}"}};
  // clang-format on
  return rules;
}

}  // namespace

std::vector<std::vector<RowName>> claim_rows() {
  std::vector<std::vector<RowName>> rows;
  for (const ClaimRule& rule : claim_rules()) rows.push_back(rule.rows);
  return rows;
}

std::vector<Claim> judge_claims(const Ledger& ledger) {
  std::vector<Claim> claims;
  for (const ClaimRule& rule : claim_rules()) {
    ClaimRows rows;
    for (const auto& [question, choice] : rule.rows) rows.push_back(ledger.find(question, choice));
    if (std::ranges::find(rows, nullptr) != rows.end()) continue;
    const Found found =
        rule.figure.find ? rule.figure.find(rows, ledger) : Found{number_of(*rows[0], rule.figure.field)};
    const auto below =
        std::ranges::find_if(rule.below, [&](const auto& b) { return found.figure < b.bound; });
    const auto [standing, words] = below == rule.below.end() ? rule.otherwise : below->verdict;
    claims.push_back({rule.source, rule.claim, standing, words, filled(rule.evidence, rows, found),
                      rule.rows[0].question, rule.rows[0].choice});
  }
  return claims;
}

}  // namespace brdf::trade
