// ctest: cli.exported_forms label=slow timeout=7200 env=BRDF_FORMS=all needs=plain @tests@/test_cli --gtest_filter=ExportedForm.*
// Runs the verbs on the exported shaders of forms. The verdicts and worst cases must equal the results for
// the form by its name, and a fit must recover the parameters. The environment variable BRDF_FORMS replaces
// the few usual forms: names separated by blanks, or "all".
#ifdef BRDF_HAS_SHADER
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "brdf/reflectance.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

// Returns the first `few` isotropic forms that pass and the first `few` that violate a declared property,
// or the forms in BRDF_FORMS.
std::vector<Reflectance> forms(std::size_t few) {
  std::vector<Reflectance> out;
  const char* asked = std::getenv("BRDF_FORMS");
  const std::string named = asked ? " " + std::string(asked) + " " : "";
  std::size_t sound = 0, violating = 0;
  for (const Reflectance& form : catalogue()) {
    std::size_t& count = form.info().violations.empty() ? sound : violating;
    const bool wanted =
        asked ? named == " all " || named.find(" " + std::string(form.info().name) + " ") != named.npos
              : !form.info().anisotropic() && count++ < few;
    if (wanted) out.push_back(form);
  }
  return out;
}

std::map<std::string, nlohmann::json> findings(const std::string& words, const io::TemporaryFolder& folder) {
  const Outcome o = run_brdf("validate " + words + " --json", folder.path());
  std::map<std::string, nlohmann::json> out;
  const nlohmann::json parsed = nlohmann::json::parse(o.out, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << words << o.err;
  if (!parsed.is_discarded())
    for (const auto& f : parsed["findings"]) out[f["check"]] = f;
  return out;
}

TEST(ExportedForm, HasTheFormsVerdictsAndWorstCases) {
  io::TemporaryFolder folder;
  for (const Reflectance& form : forms(1)) {
    const std::string name(form.info().name);
    for (const auto& [to, file] :
         {std::pair("glsl", name + ".glsl"), std::pair("explorer", name + ".brdf")}) {
      ASSERT_EQ(run_brdf("export --form " + name + " --to " + to + " -o " + file, folder.path()).exit_code,
                0);
      const auto by_name = findings("--form " + name, folder),
                 by_shader = findings("--shader " + file, folder);
      for (const auto& [check, theirs] : by_shader) {
        if (check == "undefined") {
          EXPECT_EQ(theirs["verdict"], "pass") << file << ' ' << theirs["statement"];
        }
        if (theirs["verdict"] == "not_applicable" || check == "float" || check == "undefined") continue;
        const nlohmann::json& ours = by_name.at(check);
        EXPECT_EQ(theirs["verdict"], ours["verdict"]) << file << ' ' << check << ' ' << theirs["statement"];
        if (check != "energy" && ours["verdict"] == "pass") continue;
        const double value = ours["value"];
        EXPECT_NEAR(theirs["value"].get<double>(), value,
                    (check == "continuity" ? 5e-3 : 1e-3) * std::abs(value) + 1e-6)
            << file << ' ' << check;
      }
    }
  }
}

TEST(ExportedForm, IsFittedBack) {
  io::TemporaryFolder folder;
  for (const Reflectance& form : forms(2)) {
    if (!form.info().fittable()) continue;
    const std::string name(form.info().name);
    ASSERT_EQ(
        run_brdf("synth --form " + name + " --grid hemisphere --step 10 --noise 0 -o s.csv", folder.path())
            .exit_code,
        0);
    const Outcome truth = run_brdf("fit s.csv --form " + name + " --json", folder.path());
    ASSERT_EQ(truth.exit_code, 0) << truth.err;
    const auto ours = nlohmann::json::parse(truth.out)["ranking"][0]["material"];
    for (const auto& [to, file] :
         {std::pair("glsl", name + ".glsl"), std::pair("explorer", name + ".brdf")}) {
      ASSERT_EQ(
          run_brdf("export --form " + name + " --to " + to + " --kernels builtin -o " + file, folder.path())
              .exit_code,
          0);
      const Outcome o = run_brdf("fit s.csv --shader " + file + " --json", folder.path());
      ASSERT_EQ(o.exit_code, 0) << file << o.err;
      const auto theirs = nlohmann::json::parse(o.out)["ranking"][0]["material"];
      for (const char* table : {"weights", "shape"})
        for (const auto& [parameter, value] : ours[table].items()) {
          const auto number = [](const nlohmann::json& x) {
            return x.is_array() ? x[0].get<double>() : x.get<double>();
          };
          EXPECT_NEAR(number(theirs[table][parameter]), number(value),
                      1e-6 * std::max(1.0, std::abs(number(value))))
              << file << ' ' << parameter;
        }
    }
  }
}

}  // namespace
}  // namespace brdf
#endif
