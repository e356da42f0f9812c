// ctest: interop.refitted_traps label=slow timeout=7200 env=BRDF_REFIT=1 needs=plain @tests@/test_interop --gtest_filter=Traps.*
// Tests materials that not all programs can hold, for every program. They must be written unchanged,
// written in the surface's own frame, or refused with the reason, but never silently changed into another
// material.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "brdf/random.h"
#include "interop/programs.h"
#include "interop/wanted.h"
#include "io/material/settings.h"

namespace brdf::interop {
namespace {

using ::testing::HasSubstr;

// Returns the root mean square difference in the residual of a loss, for pairs all around the surface.
double rms_between(const Material& a, const Material& b) {
  Random random(5);
  double sum = 0;
  std::size_t count = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto anywhere = [&] {
      return direction(degrees(random.uniform(0, 80)), degrees(random.uniform(0, 360)));
    };
    const Vec3<double> wi = anywhere();
    // Half of the pairs are near the mirror direction.
    Vec3<double> wo = k % 2 ? anywhere() : Vec3<double>{0.1 * random.uniform() - wi.x, -wi.y, wi.z};
    wo = wo * (1 / std::sqrt(dot(wo, wo)));
    std::vector<double> f(a.channels.size()), g(b.channels.size());
    eval(a, wi, wo, f);
    eval(b, wi, wo, g);
    for (std::size_t c = 0; c < f.size(); ++c, ++count)
      sum += std::pow(std::log1p(f[c] * wi.z) - std::log1p(g[g.size() == 1 ? 0 : c] * wi.z), 2);
  }
  return std::sqrt(sum / double(count));
}

struct Trap {
  const char* name;
  Material material;
  std::map<std::string, const char*>
      refused;  // by program: the text of the refusal; "": by all programs that are not named
};

Material made(const std::string& form, const std::vector<std::string>& set) {
  return io::choose_material({.form = form, .set = set});
}

std::vector<Trap> traps() {
  Material per_channel = made("cook_torrance", {"kd=0.3,0.2,0.1", "ks=0.5", "f0=0.04", "alpha=0.2"});
  per_channel.terms[0].shape = {{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}};
  Material three_terms = made("cook_torrance", {"kd=0", "ks=0.3", "f0=0.5", "alpha=0.1"});
  three_terms.terms.push_back(made("cook_torrance", {"kd=0", "ks=0.3", "f0=0.5", "alpha=0.4"}).terms[0]);
  three_terms.terms.push_back(made("lambert", {"rho=0.2"}).terms[0]);
  const char *const clamped = "is above 1, the limit at which the program clamps",
                    *const mesh = "orient dp/du at 30 degrees from the surface's x axis";
  return {
      {"ks above 1",
       made("blender_glossy", {"kd=0.1", "ks=1.5,0.7,0.3", "alpha=0.3"}),
       {{"blender", clamped},
        {"mitsuba", clamped},
        {"pbrt", clamped},
        {"gltf", clamped},
        {"three", clamped},
        {"materialx", clamped},
        {"radiance", clamped}}},
      {"coloured ks", made("cook_torrance", {"kd=0.1", "ks=0.6,0.4,0.2", "f0=0.5", "alpha=0.3"}), {}},
      {"a tangent of 30 degrees",
       made("cook_torrance", {"kd=0", "ks=1", "f0=0.9", "alpha_x=0.4", "alpha_y=0.2", "tangent_phi=30"}),
       {{"mitsuba", mesh}, {"pbrt", mesh}, {"disney_principled", mesh}}},
      {"alpha_x below alpha_y",
       made("cook_torrance", {"kd=0", "ks=1", "f0=0.9", "alpha_x=0.2", "alpha_y=0.4"}),
       {{"disney_principled", "orient dp/du at 90 degrees"}}},
      {"a shape per channel", per_channel, {{"", "has widths per channel"}}},
      {"an index of refraction per channel",
       made("cook_torrance_dielectric", {"kd=0.1", "ks=0.9", "eta=1.5,1.8,2.2", "alpha=0.3"}),
       {}},
      {"31 channels",
       make_material(*find_form("ward"), std::vector<std::string>(31, "c")),
       {{"", "31 channels, but the program takes one colour or three"}}},
      {"three terms",
       three_terms,
       {{"gltf", "one lobe in addition to the diffuse part"},
        {"three", "one lobe in addition to the diffuse part"}}},
      {"ward_duer", made("ward_duer", {}), {{"", "violates continuity"}}},
      {"a matt basis", made("matt_5", {"w000=0.8", "w020=0.06", "w220=0.1", "w111=-0.15", "w222=0.1"}), {}},
      {"a basis with a negative f", made("matt_2", {"w000=0.3", "w111=0.5"}), {{"", "must not be below 0"}}},
      {"a lobe about the light", made("retro", {}), {{"", "a lobe about the direction of the light"}}}};
}

// The surface nodes of MaterialX have the limits of glTF; disney_principled has no tangent.
std::string like(const Program& program) {
  const bool node = program.title.starts_with("MaterialX") && !program.adds;
  return node ? "gltf" : std::string(program.name);
}

const char* refusal_of(const Trap& trap, const Program& program) {
  for (const std::string& name : {std::string(program.name), like(program), std::string()})
    if (const auto found = trap.refused.find(name); found != trap.refused.end()) return found->second;
  return nullptr;
}

TEST(Traps, AreCarriedAsTheyAreSaidOrRefusedWithTheReason) {
  for (const Trap& trap : traps())
    for (const Program& program : programs()) {
      SCOPED_TRACE(std::string(trap.name) + " to " + std::string(program.name));
      const char* refused = refusal_of(trap, program);
      try {
        // The material is copied, which takes no time. The environment variable BRDF_REFIT requests a refit
        // instead.
        const Exported e = export_to(program, trap.material, "thing", std::getenv("BRDF_REFIT") == nullptr);
        EXPECT_EQ(refused, nullptr) << "was not refused";
        const double said = e.loss.rms, found = rms_between(trap.material, e.carried);
        EXPECT_LE(found, 5 * said + 1e-9) << said;
        EXPECT_GE(found, e.loss.none_found() ? 0 : said / 10);
        EXPECT_LT(said, 0.15);  // still recognisable as the same material
        EXPECT_THAT(e.text, HasSubstr(e.is_same             ? ": exact"
                                      : e.loss.none_found() ? ": no difference above 1e-9 at"
                                      : e.refitted          ? "refitted: largest at least"
                                                            : "copied: largest at least"));
      } catch (const Refused& error) {
        ASSERT_NE(refused, nullptr) << error.what();
        EXPECT_THAT(error.what(), HasSubstr("--to " + std::string(program.name) + ": "));
        EXPECT_THAT(error.what(), HasSubstr(refused));
      }
    }
}

}  // namespace
}  // namespace brdf::interop
