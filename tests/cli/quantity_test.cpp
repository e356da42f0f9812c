// Tests how every verb that reads samples announces, converts or refuses the quantity of a table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/angle.h"
#include "io/files/json.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class QuantityCli : public testing::Test {
 protected:
  // Writes a matt surface of albedo 0.4 in the plane of incidence. `header` names the two angles and the
  // values; the values are f_r times `factor`.
  void write(const std::string& name, const std::string& header, double factor) {
    std::ofstream file(folder_.path() / name);
    file << header << '\n';
    for (const int theta_i : {10, 30, 50, 70})
      for (int theta_o = -75; theta_o <= 75; theta_o += 15)
        file << theta_i << ',' << theta_o << ',' << factor * 0.4 / kPi * (1 + 0.001 * (theta_o % 2)) << '\n';
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  double albedo_of(const std::string& arguments) {
    const Outcome outcome = run("fit --form lambert --json " + arguments);
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
    const io::Json weights =
        io::parse_json(outcome.out, "stdout")["ranking"][0]["material"]["weights"]["rho"];
    return weights.is_array() ? weights[0].get<double>() : weights.get<double>();
  }
  io::TemporaryFolder folder_;
};

TEST_F(QuantityCli, OfANamedColumnIsConvertedAndAnnouncedByFit) {
  write("brf.csv", "SZA,VZA,BRF", kPi);
  const Outcome outcome = run("fit brf.csv --form lambert");
  EXPECT_THAT(outcome.err,
              HasSubstr("brdf fit: brf.csv: column 'BRF' is a reflectance factor: divided by pi"));
  EXPECT_NEAR(albedo_of("brf.csv"), 0.4, 0.01);
  EXPECT_THAT(run("validate brf.csv").err,
              HasSubstr("brdf validate: brf.csv: column 'BRF' is a reflectance factor"));
  EXPECT_THAT(run("study brf.csv --form lambert --no-pictures -o st").err,
              HasSubstr("brdf study: brf.csv: column 'BRF' is a reflectance factor"));
}

TEST_F(QuantityCli, IsSuppliedByAnOptionToEveryVerb) {
  write("values.csv", "Incident_angle,Measure_angle,550nm", 100 * kPi);
  EXPECT_NEAR(albedo_of("values.csv --quantity 'BRF %'"), 0.4, 0.01);
  EXPECT_NEAR(albedo_of("values.csv"), 0.4 * 100 * kPi, 1);
  EXPECT_EQ(run("convert values.csv o.csv --quantity 'reflectance factor (%)'").exit_code, 0);
  const std::string text = file_text(folder_.path() / "o.csv");
  EXPECT_THAT(text, HasSubstr("# quantity: f_r\n"));
  EXPECT_NEAR(io::read_samples(folder_.path() / "o.csv").values[0][0], 0.4 / kPi, 0.001);
  for (const char* command :
       {"fit values.csv --form lambert", "validate values.csv",
        "study values.csv --form lambert --no-pictures -o st", "convert values.csv p.csv",
        "export --to merl --measured values.csv -o m.binary"}) {
    const Outcome outcome = run(std::string(command) + " --quantity 'BRF %' --mirror-side negative");
    EXPECT_LE(outcome.exit_code, 1) << command << outcome.err;
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("column '550nm' is a reflectance factor in percent: divided by 100 pi"),
                      HasSubstr("negative viewing angles are on the mirror side, as requested")))
        << command;
  }
}

TEST_F(QuantityCli, ThatContradictsTheFileIsRefusedWithBoth) {
  write("brf.csv", "SZA,VZA,BRF", kPi);
  write("stated.csv", "# quantity: f_r*cos_o\ntheta_i,theta_o,f", 1);
  for (const char* verb : {"fit --form lambert ", "validate ", "convert "}) {
    const std::string out = *verb == 'c' ? " o.csv" : "";
    const Outcome named = run(std::string(verb) + "brf.csv --quantity f_r" + out);
    EXPECT_EQ(named.exit_code, 2);
    EXPECT_THAT(named.err, AllOf(HasSubstr("column 'BRF' is a reflectance factor"),
                                 HasSubstr("--quantity gives 'f_r'")));
    const Outcome stated = run(std::string(verb) + "stated.csv --quantity BRF" + out);
    EXPECT_EQ(stated.exit_code, 2);
    EXPECT_THAT(stated.err, HasSubstr("line 1: quantity 'f_r*cos_o' contradicts --quantity 'BRF'"));
  }
  EXPECT_THAT(
      run("fit brf.csv --quantity radiance").err,
      HasSubstr("--quantity 'radiance' is a radiance, not f_r: the irradiance of the sample is missing"));
}

TEST_F(QuantityCli, HasNoEffectWhereNoSamplesAreRead) {
  EXPECT_THAT(run("validate --form ward --quantity BRF").err,
              HasSubstr("--quantity: has no effect on what is judged here"));
  EXPECT_THAT(run("export --form ward --to glsl --quantity BRF").err, HasSubstr("apply to --measured only"));
}

// The fit of a folder and the same fit planned in units must give the same messages and results.
TEST_F(QuantityCli, IsKeptByBatchesAndPlans) {
  std::filesystem::create_directory(folder_.path() / "in");
  write("in/a.csv", "theta_i,theta_o,value", kPi);
  write("in/b.csv", "theta_i,theta_o,value", 2 * kPi);
  const Outcome batch = run("fit in --form lambert --no-pictures --quantity BRF -o out");
  EXPECT_THAT(batch.err, HasSubstr("in/a.csv: column 'value' is a reflectance factor: divided by pi"));
  EXPECT_EQ(
      run("plan fit in --form lambert --no-pictures --quantity BRF --mirror-side positive -o job").exit_code,
      0);
  EXPECT_EQ(run("work job").exit_code, 0);
  EXPECT_LE(run("collect job -o again").exit_code, 1);
  const auto rho = [&](const std::string& file) {
    return io::parse_json(file_text(folder_.path() / file), file)["weights"]["rho"].dump();
  };
  EXPECT_EQ(rho("again/a.json"), rho("out/a.json"));
}

}  // namespace
}  // namespace brdf
