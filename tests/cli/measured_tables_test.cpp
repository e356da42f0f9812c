// Tests the verbs on laboratory tables with another quantity than f_r or other channels than red, green and
// blue.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/csv/csv.h"
#include "io/files/json.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;

class MeasuredTables : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  io::SampleTable read(const std::string& name) { return io::read_samples(folder_.path() / name); }
  void write(const std::string& name, const io::SampleTable& table) {
    io::write_samples(folder_.path() / name, table);
  }
  io::TemporaryFolder folder_;
};

TEST_F(MeasuredTables, ALongTableIsReadOrNamed) {
  std::ofstream(folder_.path() / "good.csv")
      << "theta_i,phi_i,theta_o,phi_o,Wavelength_nm,f\n30,180,30,0,550,0.3\n30,180,30,0,600,0.2\n";
  const Outcome done = run("convert good.csv wide.csv");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("long format: 2 rows of 2 wavelengths, 550 to 600 nm"));
  EXPECT_EQ(read("wide.csv").channels, (std::vector<std::string>{"550nm", "600nm"}));
  std::ofstream(folder_.path() / "long.csv")
      << "theta_i,phi_i,theta_o,phi_o,Wavelength_nm,f\n30,180,30,0,550,0.3\n20,180,30,0,600,0.3\n";
  for (const char* verb : {"validate long.csv", "fit long.csv", "convert long.csv o.csv"}) {
    const Outcome refused = run(verb);
    EXPECT_EQ(refused.exit_code, 2) << verb;
    EXPECT_THAT(refused.err, HasSubstr("line 2: these directions have no value at 600 nm")) << verb;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

TEST_F(MeasuredTables, PolarisedAndRepeatedRowsBecomeWhatIsAskedFor) {
  std::ofstream(folder_.path() / "p.csv") << "theta_i,phi_i,theta_o,phi_o,fr_s,fr_p\n30,180,30,0,0.4,0.2\n30,"
                                             "180,30,0,0.5,0.3\n40,180,30,0,0.4,0.3\n";
  const Outcome done = run("convert p.csv mean.csv --polarisation average --repeats average");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr("polarisation average: fr_s, fr_p became fr"));
  EXPECT_THAT(done.err, HasSubstr("repeats: 3 rows are 2 pairs of directions, averaged"));
  const io::SampleTable mean = read("mean.csv");
  EXPECT_EQ(mean.channels, std::vector<std::string>{"fr"});
  EXPECT_NEAR(mean.values[0][0], .35, 1e-15);
  EXPECT_TRUE(mean.has_sigma(0));
  ASSERT_EQ(run("convert p.csv kept.csv").exit_code, 0);
  EXPECT_EQ(read("kept.csv").rows(), 3u);
  for (const char* verb : {"fit p.csv --form lambert", "convert p.csv o.csv"}) {
    const Outcome refused = run(std::string(verb) + " --polarisation pp");
    EXPECT_EQ(refused.exit_code, 2) << verb;
    EXPECT_THAT(refused.err,
                HasSubstr("p.csv: --polarisation pp: cannot be computed from the channels of 'fr': s, p"));
  }
}

TEST_F(MeasuredTables, StartFromATableOfRefractiveIndices) {
  ASSERT_EQ(run("synth --form cook_torrance --set f0=0.9 --grid in_plane -o s.csv").exit_code, 0);
  io::SampleTable table = read("s.csv");
  table.channels = {"550nm"};
  write("s.csv", table);
  std::ofstream(folder_.path() / "nk.csv") << "wavelength (nm),n,k\n500,0.2,3\n600,0.1,3.5\n";
  const Outcome held = run("fit s.csv --form cook_torrance --fix f0=nk.csv --json");
  EXPECT_LE(held.exit_code, 1) << held.err;
  const io::Json f0 = io::Json::parse(held.out)["ranking"][0]["material"]["weights"]["f0"];
  EXPECT_NEAR((f0.is_array() ? f0[0] : f0).get<double>(),
              (.85 * .85 + 3.25 * 3.25) / (1.15 * 1.15 + 3.25 * 3.25), 1e-12);
  EXPECT_EQ(run("fit s.csv --form cook_torrance --start f0=nk.csv").exit_code, 0);
  for (const auto& [option, said] :
       {std::pair{"--start f0=none.yml", "none.yml is neither a number nor a file"},
        std::pair{"--start kd=nk.csv", "gives values of f0, n and k only"},
        std::pair{"--start f0=s.csv", "s.csv, line "}}) {
    const Outcome refused = run(std::string("fit s.csv --form cook_torrance ") + option);
    EXPECT_EQ(refused.exit_code, 2) << option;
    EXPECT_THAT(refused.err, HasSubstr(said));
  }
}

TEST_F(MeasuredTables, AreWrittenInOtherProgramsFormats) {
  ASSERT_EQ(run("synth --form ward --grid in_plane -o s.csv").exit_code, 0);
  EXPECT_EQ(run("convert s.csv s.astm").exit_code, 0);
  EXPECT_EQ(read("s.astm").values, read("s.csv").values);
  const Outcome lens = run("convert s.csv s.zemax");
  EXPECT_EQ(lens.exit_code, 0) << lens.err;
  EXPECT_EQ(read("s.zemax").rows(), read("s.csv").rows());
  EXPECT_EQ(run("convert s.csv s.xyz").exit_code, 2);
}

TEST_F(MeasuredTables, AreExportedAsATableAndNotAsAShader) {
  ASSERT_EQ(run("synth --form ward --set kd=0.3,0.2,0.1 --grid hemisphere -o s.csv").exit_code, 0);
  const Outcome shader = run("export --measured s.csv --to glsl -o m.glsl");
  EXPECT_EQ(shader.exit_code, 2);
  EXPECT_THAT(shader.err, HasSubstr("samples have no formula"));
  EXPECT_THAT(run("export --form ward --set alpha_x=0.2 --to merl -o m.binary").err,
              HasSubstr("MERL files are isotropic"));
  EXPECT_THAT(run("export --measured s.csv --to merl").err, HasSubstr("needs -o FILE"));
  const Outcome done = run("export --measured s.csv --to merl -o m.binary");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, HasSubstr(" of 1458000 cells to m.binary; -1 where nothing was measured"));
  const io::SampleTable back = read("m.binary");
  EXPECT_GT(back.rows(), 100000u);
  EXPECT_GT(back.values[0][0], back.values[2][0]);  // red remains red
}

TEST_F(MeasuredTables, AnUndecidedCheckFailsOnlyWhereItIsRequired) {
  ASSERT_EQ(run("synth --form lambert --grid in_plane -o s.csv").exit_code, 0);
  const Outcome all = run("validate s.csv --json");
  EXPECT_EQ(all.exit_code, 0) << all.out;
  EXPECT_THAT(all.out, HasSubstr("\"undecided\""));
  EXPECT_EQ(run("validate s.csv --require energy").exit_code, 1);
  EXPECT_EQ(run("validate s.csv --require duplicates").exit_code, 0);
  for (const char* report : {"r.md", "r.html"}) {
    ASSERT_EQ(run(std::string("validate s.csv -o ") + report).exit_code, 0);
    EXPECT_THAT(file_text(folder_.path() / report), HasSubstr("undecided"));
  }
}

TEST_F(MeasuredTables, FitRepeatsACosineThatTheSheetFinds) {
  ASSERT_EQ(run("synth --form oren_nayar --set sigma=0.4 --noise 0.02 -o s.csv").exit_code, 0);
  io::SampleTable table = read("s.csv");
  const std::string found = "values behave as f_r times cos_o";
  EXPECT_THAT(run("fit s.csv --form oren_nayar").out, testing::Not(HasSubstr(found)));
  for (auto& values : table.values)
    for (std::size_t k = 0; k < table.rows(); ++k) values[k] *= std::cos(degrees(table.theta_o[k]).radians());
  write("c.csv", table);
  EXPECT_THAT(run("fit c.csv --form oren_nayar").out,
              HasSubstr("the measurements: cosine_factor fails: " + found));
  const io::Json json = io::Json::parse(run("fit c.csv --form oren_nayar --json").out);
  EXPECT_THAT(json["samples"]["fault"].get<std::string>(), HasSubstr(found));
  EXPECT_THAT(run("validate c.csv").out, HasSubstr(found));
}

TEST_F(MeasuredTables, CountsAreFittedOnAScaleOfTheirOwn) {
  ASSERT_EQ(
      run("synth --form cook_torrance --set alpha=0.2 --set kd=0.4 --set ks=0.8 --set f0=0.1 --noise 0.01 "
          "-o s.csv")
          .exit_code,
      0);
  io::SampleTable table = read("s.csv");
  for (double& v : table.values[0]) v = std::round(30000 * v);
  write("counts.csv", table);
  const Outcome sheet = run("validate counts.csv");
  EXPECT_EQ(sheet.exit_code, 1);
  EXPECT_THAT(sheet.out, testing::AllOf(HasSubstr("uncalibrated"), HasSubstr("--free-scale")));
  const auto fitted = [&](const std::string& arguments) {
    return io::Json::parse(
        run("fit " + arguments + " --form cook_torrance --metric log_relative --json").out);
  };
  const io::Json truth = fitted("s.csv"), free = fitted("counts.csv --free-scale");
  EXPECT_FALSE(truth["samples"].contains("scale"));
  const double scale = free["samples"]["scale"].get<double>();
  const io::Json a = truth["ranking"][0]["material"], b = free["ranking"][0]["material"];
  const auto shape = [](const io::Json& m) { return m["shape"]["alpha_x"].get<double>(); };
  const auto diffuse = [](const io::Json& m) { return m["weights"]["kd"][0].get<double>(); };
  EXPECT_NEAR(shape(a), 0.2, 0.01);
  EXPECT_NEAR(shape(b), 0.2, 0.01);
  EXPECT_NEAR(diffuse(b) * scale / 30000, 0.4, 0.02);
  EXPECT_GT(diffuse(b), 0.1);
  EXPECT_LT(diffuse(b), 2);
  EXPECT_THAT(run("fit counts.csv --free-scale --form lambert").out,
              HasSubstr("values divided by the scale"));
}

TEST_F(MeasuredTables, ATableByWavelengthBecomesAMerlFileWithRedInRed) {
  ASSERT_EQ(run("synth --form lambert --set rho=0.1,0.2,0.3 -o s.csv").exit_code, 0);
  io::SampleTable table = read("s.csv");
  table.channels = {"465nm", "525nm", "630nm"};
  write("w.csv", table);
  const Outcome converted = run("convert w.csv w.binary");
  ASSERT_EQ(converted.exit_code, 0);
  EXPECT_THAT(converted.err, HasSubstr("channels 630nm, 525nm, 465nm are used as red, green, blue"));
  EXPECT_NEAR(read("w.binary").values[0][0], 0.3 / kPi, 1e-6);
  table.channels = {"x", "y", "z"};
  write("x.csv", table);
  EXPECT_THAT(run("convert x.csv x.binary").err, HasSubstr("by their position"));
}

}  // namespace
}  // namespace brdf
