// Tests material files: every material round-trips, and invalid files are refused with the place of the
// error.
#include "io/material/material_json.h"
#include "brdf/forms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "io/files/error.h"
#include "io/files/temporary.h"

namespace brdf::io {
namespace {

using testing::HasSubstr;

// Returns a material of this form with every parameter drawn from its range.
Material random_material(const Reflectance& form, std::size_t channels, bool shared_shape,
                         std::mt19937_64& random) {
  Material material;
  for (std::size_t c = 0; c < channels; ++c) material.channels.push_back("c" + std::to_string(c));
  Term term = make_term(form, channels);
  if (!shared_shape) term.shape.resize(channels, term.shape[0]);
  const auto draw = [&](const ParameterInfo& p) {
    return p.min + (p.max - p.min) * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  for (auto& set : term.shape)
    for (std::size_t k = 0; k < set.size(); ++k) set[k] = draw(info(form).shape[k]);
  for (auto& set : term.weights)
    for (std::size_t k = 0; k < set.size(); ++k) set[k] = draw(info(form).weights[k]);
  material.terms.push_back(term);
  return material;
}

TEST(MaterialJson, RoundTripsExactlyForEveryFormAndAnyChannels) {
  const io::TemporaryFolder folder;
  std::mt19937_64 random(3);
  for (const Reflectance& form : catalogue()) {
    for (const std::size_t channels : {1u, 3u, 31u}) {
      for (const bool shared : {true, false}) {
        if (!shared && form.info().shape.empty()) continue;
        const Material material = random_material(form, channels, shared, random);
        const auto path = folder.path() / "m.json";
        write_material_file(path, {material, {}});
        EXPECT_EQ(read_material(path), material) << form.info().name;
      }
    }
  }
}

TEST(MaterialJson, SumsAndTheFitBlockRoundTrip) {
  const io::TemporaryFolder folder;
  std::mt19937_64 random(4);
  MaterialFile file{random_material(oren_nayar{}, 3, true, random),
                    parse_json(R"({"b": 1, "a": [1.5, null]})", "x")};
  file.material.terms.push_back(random_material(ward{}, 3, false, random).terms[0]);
  file.material.terms.push_back(random_material(ward{}, 3, true, random).terms[0]);
  write_material_file(folder.path() / "m.json", file);
  const MaterialFile back = read_material_file(folder.path() / "m.json");
  EXPECT_EQ(back.material, file.material);
  EXPECT_EQ(back.fit.dump(), file.fit.dump());
}

TEST(MaterialJson, ANameAndASourceRoundTripAndAreNoneWhereTheFileHasNone) {
  const io::TemporaryFolder folder;
  const auto path = folder.path() / "m.json";
  const MaterialFile plain{make_material(ward{}, {"fr"}), nullptr};
  EXPECT_FALSE(to_json(plain).contains("name") || to_json(plain).contains("source"));
  write_material_file(path, {plain.material, nullptr, "rolled brass", "Ward 1992, table 1"});
  const MaterialFile back = read_material_file(path);
  EXPECT_EQ(back.material, plain.material);
  EXPECT_EQ(back.name, "rolled brass");
  EXPECT_EQ(back.source, "Ward 1992, table 1");
  Json wrong = to_json(back);
  wrong["name"] = 3;
  EXPECT_THROW(material_from_json(JsonPlace(wrong, "m")), InputError);
}

TEST(MaterialJson, AnyTangentInWholeDegreesOrDecimalsReadsAndWritesTheSame) {
  for (int tenths = -1800; tenths <= 1800; ++tenths) {
    const double degrees = tenths / 10.0;
    Json json = to_json(make_material(ward{}, {"fr"}));
    json["tangent_phi"] = degrees;
    const Material material = material_from_json(JsonPlace(json, "m")).material;
    EXPECT_DOUBLE_EQ(material.terms[0].tangent_phi.radians(), degrees * kPi / 180);
    EXPECT_EQ(to_json(material)["tangent_phi"].get<double>(), degrees);
  }
}

class Refused : public testing::Test {
 protected:
  // Returns the error message for the Ward material in which the text `from` is replaced by `to`.
  std::string message(const std::string& from, const std::string& to) {
    std::string text =
        R"({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["r", "g"],)"
        R"( "weights": {"kd": [0.1, 0.2], "ks": [0.3, 0.4]}, "shape": {"alpha_x": 0.1, "alpha_y": 0.25},)"
        R"( "tangent_phi": 20})";
    const std::size_t where = text.find(from);
    EXPECT_NE(where, text.npos) << from;
    text.replace(where, from.size(), to);
    const auto path = folder_.path() / "m.json";
    std::ofstream(path) << text;
    try {
      read_material(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  io::TemporaryFolder folder_;
};

TEST_F(Refused, NothingOfTheDocumentedShape) {
  EXPECT_EQ(message("20", "-20"), "accepted");
}

TEST_F(Refused, UnknownKeysWithTheirPlace) {
  EXPECT_THAT(message("\"tangent_phi\"", "\"tangent\""),
              HasSubstr("m.json: $: unknown key \"tangent\" (known: "));
  EXPECT_THAT(message("\"kd\"", "\"rho\""), HasSubstr("$.weights: unknown key \"rho\" (known: kd, ks)"));
  EXPECT_THAT(message("\"alpha_x\"", "\"alpha\""), HasSubstr("$.shape: unknown key \"alpha\""));
}

TEST_F(Refused, ValuesOutOfRangeWithPlaceValueAndRule) {
  EXPECT_THAT(message("0.25", "1.5"), HasSubstr("m.json: $.shape.alpha_y: 1.5 must be between 1e-04 and 1"));
  EXPECT_THAT(message("0.4", "-0.4"), HasSubstr("$.weights.ks[1]: -0.4 must be between 0 and 1000"));
  EXPECT_THAT(message("20", "200"), HasSubstr("$.tangent_phi: 200 must be between -180 and 180"));
}

TEST_F(Refused, WrongTypesAndCounts) {
  EXPECT_THAT(message("[0.1, 0.2]", "[0.1]"),
              HasSubstr("$.weights.kd: [0.1] must have one value per channel (2)"));
  EXPECT_THAT(message("0.25", "\"x\""), HasSubstr("$.shape.alpha_y: \"x\" must be an array"));
  EXPECT_THAT(message("0.25", "[0.2, null]"), HasSubstr("$.shape.alpha_y[1]: null must be a number"));
  EXPECT_THAT(message("[\"r\", \"g\"]", "[\"r\", \"r\"]"),
              HasSubstr("$.channels: channel 'r' is named twice"));
  EXPECT_THAT(message("[\"r\", \"g\"]", "[]"), HasSubstr("$.channels: [] must name at least one channel"));
}

TEST_F(Refused, MissingAndRepeatedKeysOtherFormatsAndBadSyntax) {
  EXPECT_THAT(message(", \"alpha_y\": 0.25", ""), HasSubstr("$.shape: key \"alpha_y\" is missing"));
  EXPECT_THAT(message("\"alpha_y\"", "\"alpha_x\""),
              HasSubstr("m.json: $.shape: key \"alpha_x\" is given twice"));
  EXPECT_THAT(message("brdf-material", "brdf-scene"),
              HasSubstr("$.format: \"brdf-scene\" must be \"brdf-material\""));
  EXPECT_THAT(message("\"version\": 1", "\"version\": 2"), HasSubstr("$.version: 2 must be 1"));
  EXPECT_THAT(
      message("\"ward\"", "\"wurd\""),
      HasSubstr("$.form: \"wurd\" is not the name of a form (did you mean ward? known: sum, lambert"));
  EXPECT_THAT(message("\"channels\"", "channels"), HasSubstr("m.json: parse error at line 1, column 59"));
}

TEST_F(Refused, OutOfRangeMaterialsAreNeverWritten) {
  Material material = make_material(ward{}, {"fr"});
  material.terms[0].weights[0][0] = std::nan("");
  EXPECT_THROW(write_material_file(folder_.path() / "n.json", {material, {}}), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "n.json"));
}

}  // namespace
}  // namespace brdf::io
