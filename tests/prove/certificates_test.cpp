// Properties of certificates for forms and materials: verdicts are derived from the numbers, properties are
// requested by name, and the words of a certificate cannot change a verdict.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "io/files/error.h"
#include "prove/check/judge.h"
#include "prove/report.h"

namespace brdf::prove {
namespace {

using io::Json;
using testing::Contains;
using testing::HasSubstr;

std::string of_form(const char* form, std::vector<Property> properties) {
  Options options;
  options.properties = std::move(properties);
  options.search = {20000, 20};
  return to_certificate(prove(*find_form(form), options));
}

// Returns a material of a diffuse term and facets of unequal widths in two channels. The second channel
// reflects more than it receives.
Material mixed() {
  Material m{{"x", "y"}, {make_term(*find_form("lambert"), 2), make_term(*find_form("cook_torrance"), 2)}};
  m.terms[0].weights = {{0.21}, {0.93}};
  Term& facets = m.terms[1];
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k < facets.weights[c].size(); ++k)
      facets.weights[c][k] = facets.form.info().weights[k].name == "ks"   ? 0.37
                             : facets.form.info().weights[k].name == "f0" ? 0.6
                                                                          : 0.02;
  facets.shape = {{0.92, 0.81}};
  return m;
}

std::string of_mixed_material(std::vector<Property> properties) {
  Options options;
  options.properties = std::move(properties);
  options.search = {3, 5};
  const NamedMaterial named{"mixed.json", mixed()};
  return to_certificate(prove(named.material, named.file, options), std::span(&named, 1));
}

Judged judged(const std::string& text, std::vector<Property> required = {},
              std::vector<std::string> forms = {}) {
  return judge({"c", text}, {.required = std::move(required), .forms = std::move(forms)});
}
const CheckedResult& result(const Judged& j, Property property, const std::string& channel = "") {
  for (const CheckedResult& r : j.checked.results)
    if (r.property == name_of(property) && r.channel == channel) return r;
  throw std::runtime_error("no such result");
}

// Returns `text` with the first row of this property changed and the whole certificate sealed again.
std::string forged(const std::string& text, Property property, const std::function<void(Json&)>& change) {
  Json all = io::parse_json(text, "c");
  for (Json& row : all["results"])
    if (row["property"] == name_of(property)) {
      change(row);
      return sealed(all["results"], all["materials"]);
    }
  ADD_FAILURE() << "no such row";
  return text;
}
bool stands(const std::string& text) {
  try {
    return check({"c", text}).faults.empty();
  } catch (const InputError&) {  // no longer a certificate
    return false;
  }
}

TEST(AskedCertificate, OfARefutedEnergyIsNoProofOfIt) {
  const std::string text = of_form("oren_nayar", {Property::energy, Property::reciprocity});
  const Judged all = judged(text);
  EXPECT_FALSE(all.good);
  EXPECT_EQ(result(all, Property::energy).verdict, Verdict::refuted);
  EXPECT_THAT(result(all, Property::energy).statement, HasSubstr("above 1"));
  EXPECT_EQ(result(all, Property::reciprocity).verdict, Verdict::proved);
  const Judged asked = judged(text, {Property::energy});
  EXPECT_FALSE(asked.good);
  EXPECT_THAT(asked.short_of, Contains(HasSubstr("energy of oren_nayar: refuted, not proved")));
  EXPECT_TRUE(judge({"c", text}, {.properties = {Property::reciprocity}}).good);
}

// The witness is removed. The remaining certificate has only a bound above 1.
TEST(AskedCertificate, OfABoundAboveOneIsNoProofOfEnergy) {
  const std::string text = forged(of_form("oren_nayar", {Property::energy}), Property::energy,
                                  [](Json& row) { row.erase("witness"); });
  const Judged asked = judged(text, {Property::energy});
  EXPECT_TRUE(asked.checked.faults.empty());
  EXPECT_EQ(result(asked, Property::energy).verdict, Verdict::bounded);
  EXPECT_THAT(asked.short_of, Contains(HasSubstr("energy of oren_nayar: bounded, not proved")));
  EXPECT_FALSE(judged(text).good);
}

// The cover of this certificate shows an albedo of at most 1, but for equal widths only.
TEST(AskedCertificate, OfEqualWidthsIsNoProofForAllWidths) {
  const std::string text = forged(of_form("cook_torrance_schlick_ggx", {Property::energy}), Property::energy,
                                  [](Json& row) { row.erase("witness"); });
  const Judged asked = judged(text, {Property::energy});
  EXPECT_TRUE(asked.checked.faults.empty());
  EXPECT_EQ(result(asked, Property::energy).verdict, Verdict::bounded);
  EXPECT_FALSE(asked.good);
}

TEST(AskedCertificate, OfWhatIsProvedShowsIt) {
  const Judged j =
      judged(of_form("phong", {Property::energy, Property::finite}), {Property::energy, Property::finite});
  EXPECT_TRUE(j.good) << testing::PrintToString(j.short_of);
  EXPECT_THAT(result(j, Property::energy).statement, HasSubstr("the albedo is at most 1"));
}

TEST(AskedCertificate, WithoutResultsShowsNothing) {
  const std::string text = sealed(Json::array());
  EXPECT_FALSE(judged(text).good);
  EXPECT_THAT(judged(text).short_of, Contains(HasSubstr("has no result")));
  EXPECT_THAT(judged(text, {Property::energy}).short_of,
              Contains(HasSubstr("energy: the certificate has no such")));
  std::ostringstream said;
  print(said, judged(text));
  EXPECT_THAT(said.str(), testing::Not(HasSubstr("proved")));
}

TEST(AskedCertificate, NamesWhatIsAbsent) {
  const std::string text = of_form("ward", {Property::finite});
  EXPECT_THAT(judged(text, {Property::non_negative}).short_of,
              testing::ElementsAre(HasSubstr("non_negative of ward in float: the certificate has no such"),
                                   HasSubstr("non_negative of ward in double")));
  EXPECT_THAT(judged(text, {Property::finite}, {"phong"}).short_of,
              Contains(HasSubstr("finite of phong in double: the certificate has no such")));
  // One precision alone covers only half of the property.
  Json all = io::parse_json(text, "c");
  all["results"].erase(0);
  EXPECT_THAT(judged(sealed(all["results"]), {Property::finite}).short_of,
              testing::ElementsAre(HasSubstr("finite of ward in float")));
}

TEST(AskedCertificate, RefusesUnknownProperties) {
  EXPECT_THROW(properties_named("--require", {"energy", "beauty"}), InputError);
}

TEST(CertificateWords, AreDerivedAndCompared) {
  const std::string text = of_form("phong", {Property::energy, Property::finite, Property::reciprocity});
  for (const Property property : {Property::energy, Property::finite, Property::reciprocity}) {
    EXPECT_FALSE(
        stands(forged(text, property, [](Json& row) { row["arithmetic"] = "exact; f is below 1"; })));
    EXPECT_FALSE(stands(forged(
        text, property, [](Json& row) { row["scalar"] = row["scalar"] == "any" ? "double" : "any"; })));
    EXPECT_FALSE(stands(forged(text, property, [](Json& row) { row["remark"] = "approved"; })));
  }
  // A claim that holds bit for bit may not be weakened to a lesser one, either.
  EXPECT_FALSE(stands(forged(text, Property::reciprocity, [](Json& row) { row["arithmetic"] = "exact"; })));
  EXPECT_FALSE(stands(forged(text, Property::reciprocity, [](Json& row) { row["low"] = 0; })));
}

TEST(CertificateWitness, MustBeAViolationThatTheFormDeclares) {
  const std::string text = of_form("phong", {Property::energy});
  EXPECT_FALSE(stands(forged(text, Property::energy, [](Json& row) {
    row["witness"] = {{"violation", 0}, {"theta", 10}, {"phi", 0}};
  })));
  const std::string refuted = of_form("phong_unnormalised", {Property::energy});
  EXPECT_TRUE(stands(refuted));
  EXPECT_FALSE(stands(forged(refuted, Property::energy, [](Json& row) { row["witness"]["violation"] = 7; })));
}

TEST(CertificateSeal, CoversEveryByte) {
  const std::string text = of_form("lambert", {Property::finite, Property::energy});
  ASSERT_TRUE(stands(text));
  for (std::size_t k = 0; k < text.size(); k += 3) {
    std::string changed = text;
    changed[k] = changed[k] == '1' ? '2' : '1';
    if (changed == text || text[k] == '\n') continue;
    EXPECT_FALSE(stands(changed)) << "at " << k;
  }
}

TEST(CertificateVersion, OfAnotherIsRefusedAndTheFirstIsRead) {
  const std::string first =
      R"({"format":"brdf-proof","version":1,"seal":"SEAL","results":[{"form":"phong","property":"reciprocity","scalar":"double","arithmetic":"every IEEE precision, bit for bit"}]})";
  EXPECT_FALSE(stands(first));
  std::string later = first;
  later.replace(later.find("1"), 1, "3");
  EXPECT_THROW(check({"c", later}), InputError);
}

TEST(MaterialCertificate, IsOfThatMaterialAlone) {
  const std::string text = of_mixed_material({Property::finite});
  EXPECT_TRUE(
      judge({"c", text}, {.properties = {Property::finite}, .materials = {{"here.json", mixed()}}}).good);
  Material other = mixed();
  other.terms[1].shape[0][0] = 0.53;
  const Judged j =
      judge({"c", text}, {.properties = {Property::finite}, .materials = {{"here.json", other}}});
  EXPECT_FALSE(j.good);
  EXPECT_THAT(j.short_of,
              Contains(HasSubstr("here.json: the certificate has no material with these parameters")));
}

// One test, because the bound of the albedo takes seconds.
TEST(MaterialCertificate, ShowsWhatTheProofsShowedAndIsRejectedWhenForged) {
  const std::string text = of_mixed_material(Options{}.properties);
  const Judged j = judged(text);
  ASSERT_TRUE(j.checked.faults.empty()) << j.checked.faults.front();
  for (const char* channel : {"x", "y"})
    for (const Property p : {Property::finite, Property::non_negative})
      EXPECT_EQ(result(j, p, channel).verdict, Verdict::proved);
  EXPECT_EQ(result(j, Property::reciprocity).verdict, Verdict::proved);
  EXPECT_EQ(result(j, Property::energy, "x").verdict, Verdict::proved);
  EXPECT_EQ(result(j, Property::energy, "y").verdict, Verdict::refuted);
  EXPECT_FALSE(j.good);
  const Judged asked = judged(text, {Property::energy});
  EXPECT_THAT(asked.short_of, testing::ElementsAre(HasSubstr("energy of mixed.json y: refuted, not proved")));
  EXPECT_TRUE(judge({"c", text}, {.properties = {Property::finite, Property::reciprocity}}).good);

  const auto with_material = [&](const std::function<void(Json&)>& change) {
    Json all = io::parse_json(text, "c");
    change(all["materials"][0]["material"]);
    return sealed(all["results"], all["materials"]);
  };
  EXPECT_TRUE(stands(with_material([](Json&) {})));
  EXPECT_FALSE(stands(with_material([](Json& m) { m["terms"][0]["weights"]["rho"][0] = 0.2; })));
  EXPECT_FALSE(stands(with_material([](Json& m) { m["terms"][1]["shape"]["alpha_y"] = 0.4; })));
  EXPECT_FALSE(stands(with_material([](Json& m) { m["name"] = "certified paint"; })));
  const auto energy = [&](const std::function<void(Json&)>& change) {
    return forged(text, Property::energy, change);
  };
  EXPECT_FALSE(stands(energy([](Json& row) { row["high"] = row["high"].get<double>() * 0.99; })));
  EXPECT_FALSE(stands(energy([](Json& row) { row["low"] = row["low"].get<double>() * 1.01; })));
  EXPECT_FALSE(
      stands(energy([](Json& row) { row["low_at"][0] = row["low_at"][0].get<double>() / 2 + 0.3; })));
  EXPECT_FALSE(stands(energy([](Json& row) { row["cover"].erase(row["cover"].size() - 1); })));
  EXPECT_FALSE(stands(energy([](Json& row) { row["channel"] = "y"; })));
  EXPECT_FALSE(stands(energy([](Json& row) { row["cover"].back()[2] = 0.5; })));
  EXPECT_FALSE(stands(energy([](Json& row) { row["witness"] = {{"theta", 30}, {"phi", 0}}; })));
  EXPECT_FALSE(stands(forged(text, Property::finite, [](Json& row) { row["terms"].erase(1); })));
  EXPECT_FALSE(
      stands(forged(text, Property::finite, [](Json& row) { row["terms"][0]["cover"].back()[1] = 1e-3; })));
}

// Two terms with different tangents have no common axis, so their albedos may not be added view by view.
TEST(MaterialCertificate, OfTwoTangentsHasNoBoundOfTheAlbedo) {
  Material m{{"x"}, {make_term(*find_form("cook_torrance"), 1), make_term(*find_form("cook_torrance"), 1)}};
  for (Term& term : m.terms) term.shape = {{0.6, 0.3}};
  m.terms[1].tangent_phi = degrees(90);
  Options options;
  options.properties = {Property::energy};
  options.search = {20, 1};
  EXPECT_NE(prove(m, "m.json", options).front().verdict, Verdict::proved);
}

}  // namespace
}  // namespace brdf::prove
