// Tests the executable: correct usage of the verbs, and the refusal of bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "brdf/reflectance.h"
#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Cli : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name) << content;
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  bool exists(const std::string& name) { return std::filesystem::exists(folder_.path() / name); }
  // Expects for bad input: exit code 2, one line on stderr that contains `what`, nothing on stdout, no
  // output file and no temporary file.
  void expect_refused(const std::string& arguments, const std::string& what) {
    const auto before = entries();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, StartsWith("brdf: ")) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n"
                                                                           << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(entries(), before) << arguments;
  }
  std::ptrdiff_t entries() {
    return std::distance(std::filesystem::directory_iterator(folder_.path()),
                         std::filesystem::directory_iterator());
  }
  io::TemporaryFolder folder_;
};

constexpr const char* kDirections = "theta_i,phi_i,theta_o,phi_o\n30,180,30,0\n0,0,0,0\n";
constexpr const char* kMaterial =
    R"({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["r","g","b"],
        "weights": {"kd": [0.1, 0.2, 0.3], "ks": [0.3, 0.3, 0.3]}, "shape": {"alpha_x": 0.1, "alpha_y": 0.25}})";

TEST_F(Cli, SaysItsVersionAndHelpsWithAnExample) {
  EXPECT_EQ(run("--version").out, "brdf " BRDF_VERSION "\n");
  EXPECT_EQ(run("--help").exit_code, 0);
  for (const char* verb : {"models", "eval", "albedo", "synth", "export", "convert"}) {
    const Outcome help = run(std::string(verb) + " --help");
    EXPECT_EQ(help.exit_code, 0) << verb;
    EXPECT_THAT(help.out, testing::ContainsRegex(std::string("Examples?: brdf ") + verb)) << verb;
  }
}

TEST_F(Cli, RefusesWrongUsage) {
  expect_refused("evil", "'evil' is not a verb");
  expect_refused("eval --form ward", "DIRECTIONS is required");
  expect_refused("models --jsn", "--jsn");
  expect_refused("synth --form ward", "--output is required");
  expect_refused("albedo --form ward --theta x", "--theta");
  expect_refused("export --form ward --to osll", "osll");
}

// A check that was requested and did not run must not appear to have passed.
TEST_F(Cli, RefusesOptionsWithoutEffect) {
  expect_refused("validate --numerics --form lambert --require energy",
                 "--require: has no effect on --numerics");
  expect_refused("validate --form lambert --gpu --max-theta 60", "--max-theta: has no effect on --gpu");
  expect_refused("validate --integrators --form lambert", "--form: has no effect on --integrators");
  expect_refused("validate --numerics --shader a.glsl", "--shader: has no effect on --numerics");
  expect_refused("trade --compare a.json b.json --quick", "--quick excludes --compare");
  expect_refused("export --form ward --to gltf --kernels builtin", "--kernels: applies to shaders only");
  expect_refused("export --form ward --to merl --include -o m.binary", "--include: applies to shaders only");
  expect_refused("export --form ward --to glsl --name x",
                 "--name: --to glsl of a form alone writes no material");
  expect_refused("export --form ward --to merl --name x -o m.binary", "--name: --to merl writes no name");
  expect_refused("export --form ward --set ks=0.2 --to explorer --name x",
                 "--name: --to explorer writes no name");
  expect_refused("export --form ward --to glsl --size 1M", "--size: applies to --to rgl only");
}

TEST_F(Cli, RefusesUnknownFormsAndParametersOutOfRange) {
  write("d.csv", kDirections);
  expect_refused("eval --form wurd d.csv -o o.csv",
                 "'wurd' is not the name of a form (did you mean ward? known: lambert, ");
  expect_refused("eval --form ward --set alpha=2 d.csv -o o.csv",
                 "--set alpha: 2 must be between 1e-04 and 1");
  expect_refused("eval --form ward --set rho=1 d.csv -o o.csv",
                 "--set rho: unknown parameter (known: kd, ks, alpha_x");
  expect_refused("eval --form ward --set alpha d.csv -o o.csv", "'alpha': must be name=value");
  expect_refused("eval --form ward --set alpha=x d.csv -o o.csv", "'x' is not a finite number");
  expect_refused("eval --form ward --set ks=1 --set ks=1 d.csv -o o.csv", "is set twice");
  expect_refused("eval --form ward --set ks=1,2 --set kd=1,2,3 d.csv -o o.csv", "2 values for 3 channels");
  expect_refused("eval d.csv -o o.csv", "exactly one of MATERIAL, --form and --shader");
  expect_refused("albedo --form ward --theta 91", "--theta 91: must be between 0 and 90");
  expect_refused("synth --form ward --noise 3 -o o.csv", "--noise 3: must be between 0 and 2");
  expect_refused("models wurd", "'wurd' is not the name of a form");
}

TEST_F(Cli, RefusesBadFilesWithFileLineAndColumnOrPath) {
  write("bad.csv", "theta_i,phi_i,theta_o,phi_o,fr\n1,2,3,4,5\n1,2,x,4,5\n");
  write("d.csv", kDirections);
  write("bad.json", std::string(kMaterial).replace(std::string(kMaterial).find("0.25"), 4, "7.25"));
  expect_refused("eval --form ward bad.csv -o o.csv",
                 "bad.csv, line 3: column 3 (theta_o): 'x' is not a number");
  expect_refused("eval --form ward none.csv -o o.csv", "none.csv: cannot be read");
  expect_refused("eval --material bad.json d.csv -o o.csv",
                 "bad.json: $.shape.alpha_y: 7.25 must be between 1e-04 and 1");
  expect_refused("eval --material none.json d.csv -o o.csv", "none.json: cannot be read");
  expect_refused("convert d.csv o.csv", "no value column");
  expect_refused("convert bad.csv o.xyz", "o.xyz: unknown output format");
  expect_refused("eval --form ward d.csv -o nowhere/o.csv", "nowhere/o.csv: cannot be written");
  expect_refused("synth --form ward --grid nope.csv -o o.csv", "nope.csv: cannot be read");
}

TEST_F(Cli, AFullDiskIsTheEnvironmentsFault) {
  write("d.csv", kDirections);
  const Outcome outcome = run("eval --form ward d.csv -o /dev/full");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("/dev/full: writing broke off"));
}

TEST_F(Cli, AMeasurementWithoutLightIsNotFitted) {
  for (const char* value : {"0", "-0.5"}) {
    std::string rows = "theta_i,phi_i,theta_o,phi_o,f\n";
    for (int theta = 0; theta < 80; theta += 10)
      rows += "30,180," + std::to_string(theta) + ",0," + value + "\n";
    write("dark.csv", rows);
    expect_refused("fit dark.csv -o m.json",
                   "dark.csv: all values to fit are 0 or below: the table has no usable measurement");
  }
}

TEST_F(Cli, AFitWithoutASolutionWritesNoMaterial) {
  std::string rows = "theta_i,phi_i,theta_o,phi_o,f\n";
  for (int theta = 0; theta < 80; theta += 10) rows += "30,180," + std::to_string(theta) + ",0,1e180\n";
  write("big.csv", rows);
  const Outcome outcome = run("fit big.csv --form all --metric cosine_l2 -o m.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "brdf fit: no form could be fitted: m.json is not written\n");
  EXPECT_THAT(outcome.out, HasSubstr("diverged"));
  EXPECT_FALSE(exists("m.json"));
}

TEST_F(Cli, EvalWritesTheInputsColumnsThenTheValues) {
  write("d.csv", "# sample: x\ntheta_i,phi_i,theta_o,phi_o,fr\n30,180,30,0,7\n0,0,95e-1,0,8\n");
  write("m.json", kMaterial);
  const Outcome one = run("eval --form lambert --set rho=0.25 d.csv");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("# sample: x\n"));
  EXPECT_THAT(
      one.out,
      HasSubstr("\ntheta_i,phi_i,theta_o,phi_o,fr,f\n30,180,30,0,7,0.07957747154594767\n0,0,9.5,0,8,"));
  const Outcome three = run("eval --material m.json d.csv -o o.csv");
  EXPECT_EQ(three.exit_code, 0) << three.err;
  EXPECT_EQ(three.out, "");
  EXPECT_THAT(file_text(folder_.path() / "o.csv"), HasSubstr("theta_i,phi_i,theta_o,phi_o,fr,f_r,f_g,f_b\n"));
  expect_refused("eval --material m.json o.csv -o again.csv", "has a column 'f_r' already");
}

TEST_F(Cli, EvalTimesTheCosineOfTheLight) {
  write("d.csv", "theta_i,phi_i,theta_o,phi_o\n60,180,30,0\n");
  EXPECT_THAT(run("eval --form lambert --set rho=1 --cos d.csv").out,
              HasSubstr("60,180,30,0,0.1591549430918"));
}

TEST_F(Cli, SettingsApplyToAMaterialFileAndTangentsAreDegrees) {
  write("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,180,40,10\n");
  write("m.json", kMaterial);
  const auto last = [](const std::string& text) { return text.substr(text.rfind('\n', text.size() - 2)); };
  const std::string set = last(run("eval --material m.json --set alpha=0.2 --set kd=0 d.csv").out);
  const std::string same =
      last(run("eval --form ward --set alpha=0.2 --set kd=0,0,0 --set ks=0.3 d.csv").out);
  EXPECT_EQ(set, same);
  const std::string turned = last(run("eval --material m.json --set tangent_phi=90 d.csv").out);
  const std::string swapped =
      last(run("eval --material m.json --set alpha_x=0.25 --set alpha_y=0.1 d.csv").out);
  EXPECT_EQ(turned.substr(0, 24), swapped.substr(0, 24));
}

TEST_F(Cli, ModelsListsEveryFormWithItsParameters) {
  const io::Json json = io::parse_json(run("models --json").out, "stdout");
  std::size_t k = 0;
  for (const Reflectance& form : catalogue()) {
    const io::Json& entry = json["forms"].at(k++);
    EXPECT_EQ(entry["form"], form.info().name);
    EXPECT_EQ(entry["family"], form.info().family);
    EXPECT_EQ(entry["known_violations"].size(), form.info().violations.size());
    for (const io::Json& p : entry["parameters"]) {
      EXPECT_LE(p["min"].get<double>(), p["default"].get<double>());
      EXPECT_LE(p["default"].get<double>(), p["max"].get<double>());
      EXPECT_TRUE(p["kind"] == "weight" || p["kind"] == "shape");
      EXPECT_FALSE(p["doc"].get<std::string>().empty());
    }
  }
  EXPECT_EQ(json["forms"].size(), k);
  EXPECT_THAT(run("models ward").out, HasSubstr("alpha_y"));
}

TEST_F(Cli, AlbedoOfAWhiteRoughMirrorIsOneMinusLogTwo) {
  const Outcome outcome =
      run("albedo --form cook_torrance --set kd=0 --set ks=1 --set f0=1 --set alpha=1 --theta 0 --tolerance "
          "1e-10 --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const io::Json row = io::parse_json(outcome.out, "stdout")["results"].at(0);
  const double error = std::abs(row["value"].get<double>() - 0.306852819440055);
  EXPECT_LT(error, 1e-10);
  EXPECT_LE(error, row["error_bound"].get<double>() + 1e-15);  // the digits of the oracle
  EXPECT_TRUE(row["converged"].get<bool>());
  EXPECT_EQ(row["fixed"], "i");
}

TEST_F(Cli, AlbedoHasOneRowPerAngleAndChannel) {
  const Outcome outcome = run("albedo --form lambert --set rho=0.1,0.2,0.3 --theta 0,45,90 --json");
  const io::Json results = io::parse_json(outcome.out, "stdout")["results"];
  ASSERT_EQ(results.size(), 9u);
  for (std::size_t k = 0; k < 9; ++k) {
    const double rho = 0.1 * static_cast<double>(k % 3 + 1);
    EXPECT_NEAR(results[k]["value"].get<double>(), rho, 1e-6 * rho);
  }
}

TEST_F(Cli, ExportWritesShaderSource) {
  write("m.json", kMaterial);
  const Outcome form = run("export --form cook_torrance --to glsl");
  EXPECT_THAT(
      form.out,
      HasSubstr("vec3 brdf_eval_cook_torrance(vec3 wi, vec3 wo, float alpha_x, float alpha_y, vec3 kd"));
  EXPECT_THAT(form.out, testing::Not(HasSubstr("brdf_material")));
  EXPECT_THAT(form.out, HasSubstr("#version 450\n"));
  EXPECT_THAT(form.out, HasSubstr("void main() {}\n"));
  const Outcome snippet = run("export --form cook_torrance --to glsl --include");
  EXPECT_THAT(snippet.out, testing::Not(HasSubstr("#version")));
  EXPECT_THAT(snippet.out, testing::Not(HasSubstr("main()")));
  EXPECT_THAT(run("export --material m.json --to glsl --include").out,
              HasSubstr("vec3 brdf_material_m(vec3 wi, vec3 wo) {"));
  EXPECT_THAT(run("export --material m.json --to glsl --name 'a b'").out,
              HasSubstr("vec3 brdf_material_a_b(vec3 wi, vec3 wo) {"));
  EXPECT_EQ(run("export --material m.json --to glsl -o m.glsl").exit_code, 0);
  EXPECT_THAT(file_text(folder_.path() / "m.glsl"),
              HasSubstr("f += brdf_eval_ward(wi, wo, 0.10000000149011612, 0.25, vec3(0.10000000149011612"));
}

TEST_F(Cli, ConvertSaysWhatIsLostAndReadsItsOwnFiles) {
  write("m.json", kMaterial);
  const Outcome to_merl = run("convert m.json m.binary");
  EXPECT_EQ(to_merl.exit_code, 0) << to_merl.err;
  EXPECT_THAT(to_merl.err, HasSubstr("lost: "));
  const Outcome to_exr = run("convert m.binary m.exr");
  EXPECT_EQ(to_exr.exit_code, 0) << to_exr.err;
  EXPECT_THAT(to_exr.err, HasSubstr("lost: digits beyond 32-bit float"));
  EXPECT_EQ(file_text(folder_.path() / "m.exr").substr(0, 4), "\x76\x2f\x31\x01");
  write("s.csv", "# quantity: f_r\ntheta_i,phi_i,theta_o,phi_o,fr\n30,180,30,0,7\n");
  EXPECT_EQ(run("convert s.csv t.csv").exit_code, 0);
  EXPECT_EQ(file_text(folder_.path() / "t.csv"), file_text(folder_.path() / "s.csv"));
  EXPECT_EQ(run("convert s.csv s.exr").exit_code, 0);
  EXPECT_EQ(run("convert s.exr u.csv").exit_code, 0);
  EXPECT_EQ(file_text(folder_.path() / "u.csv"), file_text(folder_.path() / "s.csv"));
}

TEST_F(Cli, SynthIsReproducibleAndNamesItsCommand) {
  const std::string command = "synth --form ward --set alpha=0.1 --grid in_plane --noise 0.05 --seed 3 -o ";
  EXPECT_EQ(run(command + "a.csv").exit_code, 0);
  EXPECT_EQ(run(command + "b.csv").exit_code, 0);
  const std::string a = file_text(folder_.path() / "a.csv");
  EXPECT_EQ(a, file_text(folder_.path() / "b.csv"));
  EXPECT_THAT(
      a,
      HasSubstr("# command: brdf synth --form ward --set alpha=0.1 --grid in_plane --noise 0.05 --seed 3\n"));
  EXPECT_THAT(run("synth --form ward --set alpha=0.004 --aperture 2 --grid in_plane -o c.csv").err,
              HasSubstr("warning: the lobe is narrower than the aperture"));
}

// The lobe is narrow and only the mirror side is scanned. If the noise were estimated only among the values
// under one light, the shape of the lobe would count as noise.
TEST_F(Cli, AMisfitIsOneWhicheverOfLightAndViewerWasScanned) {
  std::string still_viewer = "theta_i,phi_i,theta_o,phi_o\n", still_light = still_viewer;
  for (const int still : {15, 20, 30, 40, 45, 50, 60, 70, 80})
    for (int moved = 1; moved <= 80; ++moved) {
      still_viewer += std::to_string(moved) + ",180," + std::to_string(still) + ",0\n";
      still_light += std::to_string(still) + ",180," + std::to_string(moved) + ",0\n";
    }
  write("viewer.csv", still_viewer);
  write("light.csv", still_light);
  for (const std::string name : {"viewer", "light"}) {
    ASSERT_EQ(run("synth --form cook_torrance --set kd=0.02 --set ks=0.9 --set f0=0.9 --set alpha=0.02 "
                  "--noise 0.02 "
                  "--grid " +
                  name + ".csv -o s.csv")
                  .exit_code,
              0);
    const Outcome wrong = run("fit s.csv --form lambert --json");
    EXPECT_EQ(wrong.exit_code, 1) << name;
    const io::Json json = io::Json::parse(wrong.out);
    EXPECT_EQ(json.at("ranking").at(0).at("verdict"), "misfit") << name;
    EXPECT_GT(json.at("samples").at("noise_floor").get<double>(), 0.02 / 1.5) << name;
    EXPECT_LT(json.at("samples").at("noise_floor").get<double>(), 0.02 * 1.5) << name;
    const io::Json sheet = io::Json::parse(run("validate s.csv --json").out);
    for (const io::Json& finding : sheet.at("findings"))
      if (finding.at("check") == "noise_floor") {
        EXPECT_NEAR(finding.at("value").get<double>(), 0.02, 0.008) << name;
        EXPECT_NEAR(finding.at("channels").begin()->get<double>(), 0.02, 0.008) << name;
      }
    const Outcome right = run("fit s.csv --form cook_torrance");
    EXPECT_EQ(right.exit_code, 0) << right.out;
    EXPECT_THAT(right.out, HasSubstr("(chosen: its noise is the most uniform"));
    EXPECT_THAT(run("fit s.csv --form lambert --metric log").out, Not(HasSubstr("(chosen: ")));
  }
}

}  // namespace
}  // namespace brdf
