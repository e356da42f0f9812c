// The shaders that the library writes, run by the interpreter, as an oracle that needs no third-party code.
#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "brdf/random.h"
#include "brdf/targets.h"
#include "io/material/glsl.h"
#include "io/material/shader_texts.h"
#include "shader/front/compile.h"
#include "shader/kernels.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

std::shared_ptr<const ShaderReflectance> exported(const Reflectance& form) {
  static std::map<std::string_view, std::shared_ptr<const ShaderReflectance>> known;
  auto& shader = known[form.info().name];
  if (!shader) shader = shader_of(io::glsl_source(make_material(form), {.material = false}));
  return shader;
}

std::shared_ptr<const ShaderReflectance> exported_as_hlsl(const Reflectance& form) {
  return shader_of(io::shader_text(make_material(form), io::ShaderLanguage::hlsl, false, "x"), {}, "x.hlsl");
}

struct Drawn {
  std::vector<float> weights, shape;
};
Drawn draw(const ReflectanceInfo& info, Random& random) {
  Drawn d;
  for (const ParameterInfo& p : info.weights)
    d.weights.push_back(float(random.uniform(std::max(p.min, -1.0), std::min(p.max, 1.0))));
  for (const ParameterInfo& p : info.shape)
    d.shape.push_back(float(p.log_scale && p.min > 0 ? random.log_uniform(p.min, p.usual_max)
                                                     : random.uniform(p.min, p.usual_max)));
  return d;
}

// Returns a direction with theta uniform in 0 to 92 degrees, so that some directions lie below the horizon.
Vec3<double> somewhere(Random& random) {
  return direction(degrees(random.uniform(0, 92)), degrees(random.uniform(0, 360)));
}

TEST(Exported, TwoShadersOfOneNameAreNotOneFunction) {
  const auto dim = shader_of("float brdf(vec3 L, vec3 V) { return 0.1; }", {}, "x.glsl"),
             bright = shader_of("float brdf(vec3 L, vec3 V) { return 0.2; }", {}, "x.glsl"),
             other = shader_of("float brdf(vec3 L, vec3 V) { return 0.2; }", {}, "y.glsl");
  const auto exported_with = [&](const std::shared_ptr<const ShaderReflectance>& second) {
    Material sum = dim->material(dim);
    sum.terms.push_back(second->material(second).terms.front());
    return io::glsl_source(sum);
  };
  EXPECT_NE(exported_with(dim).find("brdf_eval_x"), std::string::npos);
  EXPECT_NE(exported_with(other).find("brdf_eval_y"), std::string::npos);
  try {
    exported_with(bright);
    ADD_FAILURE() << "one of the two functions is lost";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("two terms have different functions with the name x"),
              std::string::npos)
        << e.what();
  }
}

constexpr std::size_t kPairs = 300;

// Returns pairs of directions, every second pair near the mirror direction.
DirectionArrays<float> draw_directions(Random& random) {
  DirectionArrays<float> d(kPairs);
  const auto to_float = [](const Vec3<double>& w) { return Vec3<float>{float(w.x), float(w.y), float(w.z)}; };
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Vec3<double> wi = somewhere(random),
                       wo = k % 2 ? somewhere(random)
                                  : Vec3<double>{-wi.x + random.uniform(0, 0.02), -wi.y, wi.z};
    d.set(k, to_float(wi), to_float(wo));
  }
  return d;
}

void expect_same_bits(const Reflectance& form, const ShaderReflectance& shader, int sets) {
  Random random(1);
  for (int set = 0; set < sets; ++set) {
    const Drawn p = draw(form.info(), random), first = draw(form.info(), random);
    const DirectionArrays<float> d = draw_directions(random);
    const ParameterValues<float> values{p.weights, first.weights, p.shape, 1};
    std::vector<float> library(kPairs), interpreted(kPairs), alone(kPairs);
    form->eval(values, d.view(), library.data());
    shader.eval(values, d.view(), interpreted.data());
    for (std::size_t k = 0; k < kPairs; ++k) shader.eval(values, d.view().part(k, 1), &alone[k]);
    for (std::size_t k = 0; k < kPairs; ++k) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(library[k]), std::bit_cast<std::uint32_t>(interpreted[k]))
          << form.info().name << ' ' << k;
      ASSERT_EQ(std::bit_cast<std::uint32_t>(library[k]), std::bit_cast<std::uint32_t>(alone[k]))
          << form.info().name << ' ' << k;
    }
  }
}

TEST(ExportedForm, IsTheFloatLibraryBitForBit) {
  for (const Reflectance& form : catalogue()) expect_same_bits(form, *exported(form), 6);
}

TEST(ExportedForm, IsTheFloatLibraryBitForBitInHlsl) {
  for (const auto list : {catalogue(), targets()})
    for (const Reflectance& form : list) expect_same_bits(form, *exported_as_hlsl(form), 2);
}

TEST(ExportedForm, HasTheFormsTablesAndLobes) {
  for (const Reflectance& form : catalogue()) {
    const auto shader = exported(form);
    const ReflectanceInfo &f = form.info(), &s = shader->info();
    const auto same = [&](std::span<const ParameterInfo> a, std::span<const ParameterInfo> b) {
      ASSERT_EQ(a.size(), b.size()) << f.name;
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].name, b[k].name) << f.name;
        EXPECT_EQ(a[k].min, b[k].min) << f.name;
        EXPECT_EQ(a[k].max, b[k].max) << f.name;
        EXPECT_EQ(a[k].role, b[k].role) << f.name;
      }
    };
    same(f.weights, s.weights);
    same(f.shape, s.shape);
    if (!f.fittable()) continue;
    ASSERT_EQ(f.lobes.size(), s.lobes.size()) << f.name;
    for (std::size_t k = 0; k < f.lobes.size(); ++k) {
      EXPECT_EQ(f.lobes[k].weight, s.lobes[k].weight) << f.name;
      EXPECT_EQ(f.lobes[k].factor, s.lobes[k].factor) << f.name;
    }
  }
}

// In double the constants are the numbers of the text, which have nine digits.
TEST(ExportedForm, HasTheFormsDerivatives) {
  for (const Reflectance& form : catalogue()) {
    if (!form.info().fittable()) continue;
    const auto shader = exported(form);
    Random random(2);
    for (int set = 0; set < 8; ++set) {
      const Drawn drawn = draw(form.info(), random);
      const std::vector<double> w(drawn.weights.begin(), drawn.weights.end()),
          s(drawn.shape.begin(), drawn.shape.end());
      const Vec3<double> wi = direction(degrees(random.uniform(2, 70)), degrees(20)),
                         wo = direction(degrees(random.uniform(2, 70)), degrees(190));
      const std::size_t rows = 1 + w.size() + s.size();
      std::vector<double> ours(rows), theirs(rows);
      form->gradient({w, w, s}, one_pair(wi, wo), {ours.data(), 1});
      shader->gradient({w, w, s}, one_pair(wi, wo), {theirs.data(), 1});
      for (std::size_t k = 0; k < rows; ++k)
        EXPECT_NEAR(theirs[k], ours[k], 2e-5 * (std::abs(ours[k]) + std::abs(ours[0]) + 1e-3))
            << form.info().name << ' ' << k;
    }
  }
}

std::size_t kernels_in(const char* name, const std::string& text) {
  return library_kernels(spirv::parse(compile(parse_source(name, text)).spirv, name)).size();
}

// A function of a kernel's name that differs from the kernel at a few values was taken for the kernel,
// because values were compared at samples of its domain.
TEST(ExportedForm, AKernelIsKnownByItsOperations) {
  const Material material = make_material(*find_form("lambert"));
  const std::string text = io::glsl_source(material);
  EXPECT_EQ(kernels_in("x.glsl", text), 5u);
  EXPECT_EQ(kernels_in("x.glsl", io::glsl_source(material, {.dialect = GlslDialect::es})), 5u);
  EXPECT_EQ(kernels_in("x.hlsl", io::shader_text(material, io::ShaderLanguage::hlsl, true, "x")), 5u);
  const std::string own = "float brdf_exp(";
  std::string other = text;
  const std::size_t at = other.find(own);
  ASSERT_NE(at, other.npos);
  other.replace(at, own.size(), "float inner(");
  const std::size_t next = other.find("float brdf_log(");
  other.insert(next, "float brdf_exp(float x) { return x < -14.5 ? -2.0 : inner(x); }\n");
  EXPECT_EQ(kernels_in("x.glsl", other), 4u);
  EXPECT_EQ(kernels_in("x.glsl",
                       "float brdf_log(float x) { return dFdx(x); }\n"  // nothing calls it
                       "float brdf(vec3 L, vec3 V, vec3 N) { return 0.1; }\n"),
            0u);
}

}  // namespace
}  // namespace brdf::shader
