// The data sheet of a table is the same for every verb that prints it, and comes before the fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "brdf/angle.h"
#include "io/csv/csv.h"
#include "io/files/json.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

class SheetCli : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }

  // Writes a seeded measurement, changed by `spoil`.
  void write(const std::string& name, const std::string& synth,
             const std::function<void(io::SampleTable&)>& spoil) {
    ASSERT_EQ(run("synth " + synth + " -o clean.csv").exit_code, 0);
    io::SampleTable t = io::read_samples(folder_.path() / "clean.csv");
    spoil(t);
    io::write_samples(folder_.path() / name, t);
  }

  io::Json findings(const std::string& file) {
    return io::Json::parse(run("validate " + file + " --json").out)["findings"];
  }

  io::TemporaryFolder folder_;
};

void multiply(io::SampleTable& t, const std::function<double(std::size_t)>& factor) {
  for (auto& values : t.values)
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= factor(k);
}

constexpr const char* kMatt =
    "--form lambert --set rho=0.7 --grid in_plane --theta-i 10,25,40,55,70 --step 3 --noise 0.01 --seed 4";
constexpr const char* kGloss =
    "--form cook_torrance --set kd=0.3 --set ks=0.4 --set alpha=0.3 --theta-i 10,30,50,70 --step 10 --noise "
    "0.02 --seed 5";

TEST_F(SheetCli, FitStudyAndValidateSayTheSameOfEveryTable) {
  write("clean_copy.csv", kMatt, [](io::SampleTable&) {});
  write("gain.csv", kGloss,
        [](io::SampleTable& t) { multiply(t, [&](std::size_t k) { return t.theta_i[k] == 50 ? 2.2 : 1; }); });
  write("azimuth.csv", kGloss, [](io::SampleTable& t) {
    for (double& phi : t.phi_o) phi += 180;
  });
  write("factor.csv", kMatt, [](io::SampleTable& t) { multiply(t, [](std::size_t) { return kPi; }); });
  for (const std::string file : {"clean_copy.csv", "gain.csv", "azimuth.csv", "factor.csv"}) {
    const io::Json sheet = findings(file);
    const io::Json fit = io::Json::parse(run("fit " + file + " --form lambert --json").out);
    EXPECT_EQ(fit["samples"]["sheet"], sheet) << file;
    run("study " + file + " --form lambert --no-pictures -o studied_" + file);
    const auto path = folder_.path() / ("studied_" + file) / "sheet.json";
    EXPECT_EQ(io::read_json(path)["findings"], sheet) << file;
    // The fit reports exactly the failed checks of the sheet, and gives no other advice about the samples.
    const std::string text = run("fit " + file + " --form lambert").out;
    for (const io::Json& f : sheet)
      EXPECT_THAT(text, f["verdict"] == "fail" ? testing::Matcher<std::string>(
                                                     HasSubstr(f["check"].get<std::string>() + " fails"))
                                               : Not(HasSubstr(f["check"].get<std::string>() + " fails")));
  }
}

TEST_F(SheetCli, OneLightsGainIsNoCosineToAnyVerb) {
  write("gain.csv", kGloss,
        [](io::SampleTable& t) { multiply(t, [&](std::size_t k) { return t.theta_i[k] == 70 ? 3 : 1; }); });
  for (const char* verb : {"validate gain.csv", "fit gain.csv --form cook_torrance"}) {
    const std::string said = run(verb).out;
    EXPECT_THAT(said, HasSubstr("values at incidence 70 degrees are")) << verb;
    EXPECT_THAT(said, Not(HasSubstr("quantity: f_r*"))) << verb;
  }
}

TEST_F(SheetCli, AFitRepeatsThatAPlaneLooksLikeABrf) {
  write("factor.csv", kMatt, [](io::SampleTable& t) { multiply(t, [](std::size_t) { return kPi; }); });
  EXPECT_THAT(run("fit factor.csv --form lambert").out,
              HasSubstr("quantity is undecided: the values look like the reflectance factor pi f_r (BRF)"));
  EXPECT_THAT(run("fit clean.csv --form lambert").out, Not(HasSubstr("BRF")));
}

TEST_F(SheetCli, RowsOfABlindedDetectorAreLeftOutUnlessTheyAreKept) {
  write("blind.csv", kMatt, [](io::SampleTable& t) {
    multiply(t, [&](std::size_t k) {
      return t.phi_o[k] == t.phi_i[k] && std::abs(t.theta_o[k] - t.theta_i[k]) < 8 ? 0 : 1;
    });
  });
  const auto rho = [&](const std::string& options) {
    return io::Json::parse(run("fit blind.csv --form lambert --metric log_relative --json" + options)
                               .out)["ranking"][0]["material"]["weights"]["rho"][0]
        .get<double>();
  };
  EXPECT_NEAR(rho(""), 0.7, 0.005);
  EXPECT_LT(rho(" --keep-fill"), 0.6);
  const Outcome fitted = run("fit blind.csv --form lambert");
  EXPECT_THAT(fitted.out, HasSubstr("fill fails: "));
  EXPECT_THAT(fitted.err, HasSubstr("rows with fill values left out"));
  EXPECT_THAT(run("convert blind.csv out.csv").err, HasSubstr("rows with fill values left out"));
  EXPECT_EQ(io::read_samples(folder_.path() / "out.csv").rows() +
                std::size_t(findings("blind.csv")[2]["value"].get<double>()),
            io::read_samples(folder_.path() / "blind.csv").rows());
  run("convert blind.csv out.csv --keep-fill");
  EXPECT_EQ(io::read_samples(folder_.path() / "out.csv").rows(),
            io::read_samples(folder_.path() / "blind.csv").rows());
}

}  // namespace
}  // namespace brdf
