#include "prove/shader/self_test.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "io/files/numbers.h"
#include "prove/shader/on_box.h"
#include "prove/shader/random_program.h"
#include "prove/shader/shader_proof.h"
#include "shader/undefined.h"

namespace brdf::prove {
namespace {

using Model = std::shared_ptr<const shader::ShaderReflectance>;

double within(std::mt19937_64& e, Bounds range) {
  const std::uint64_t kind = e() % 8;
  if (kind == 0) return range.lo;
  if (kind == 1) return range.hi;
  return std::clamp(range.lo + (range.hi - range.lo) * double(e() >> 11) * 0x1p-53, range.lo, range.hi);
}

// Returns a part of the range: a point, a sliver or the whole range.
Bounds part_of(std::mt19937_64& e, Bounds range) {
  const double a = within(e, range), b = within(e, range);
  const double share = std::pow(10, -8 * double(e() >> 11) * 0x1p-53);
  const double other = e() % 4 == 0 ? b : std::clamp(a + (b - a) * share, range.lo, range.hi);
  return {std::min(a, other), std::max(a, other)};
}

// Returns the direction of this cosine and turn, rotated about the normal by `by` radians and rounded to T.
template <class T>
Vec3<T> direction_at(double cosine, double turn, double by) {
  const double x = 1 - std::fabs(turn), y = std::fabs(turn) <= 1 ? turn : turn > 0 ? 2 - turn : -2 - turn;
  const double s = std::sqrt((1 - cosine) * (1 + cosine)) / std::hypot(x, y), c = std::cos(by),
               d = std::sin(by);
  return {T(s * (c * x - d * y)), T(s * (d * x + c * y)), T(cosine)};
}

class Attack {
 public:
  Attack(const SelfTestOptions& options, const io::Progress& progress)
      : options_(options), progress_(progress), random_(options.seed) {}

  SelfTest run() {
    const long programs = options_.planted + options_.sound;
    for (long k = 0; k < programs; ++k) {
      const bool sound = k % (programs / std::max(options_.sound, 1L)) == 0 && found_.sound < options_.sound;
      const RandomProgram program = sound ? sound_program(random_) : planted_program(random_);
      ++(sound ? found_.sound : found_.planted);
      const Model model = std::make_shared<const shader::ShaderReflectance>(
          shader::make_function(shader::parse_source("random.glsl", program.text), {}, compiler_));
      judge(program, model);
      const long share = options_.samples / programs + 1;
      sample<float>(program, model->function(), share, found_.samples_float);
      sample<double>(program, model->function(), share, found_.samples_double);
      if (progress_) progress_(int(k + 1), int(programs));
    }
    return std::move(found_);
  }

 private:
  void judge(const RandomProgram& program, const Model& model) {
    Options options;
    options.search = {4000, options_.seconds};
    options.properties = {Property::finite, Property::non_negative};
    bool all = true;
    for (const Proof& p : prove(*model, model->material(model), " --shader random.glsl", options)) {
      const bool proved = p.verdict == Verdict::proved;
      all = all && proved;
      if (!proved || !contradicts(program, p.claim.property, p.claim.precision)) continue;
      if (found_.falsely_proved++ == 0)
        found_.faults.push_back("proved " + std::string(name_of(p.claim.property)) + " in " +
                                std::string(name_of(p.claim.precision)) + " for a shader with a planted " +
                                program.where + ":\n" + program.text);
    }
    if (program.planted == Planted::nothing) found_.sound_proved += all;
  }

  template <class T>
  void sample(const RandomProgram& program, const shader::Function& f, long samples, long& count) {
    const bool turns = f.turning<T>().isotropic;
    shader::Runner<T, 1> runner(f);
    constexpr long kOfABox = 25;
    for (const long last = count + samples; count < last;) {
      ShaderInputs in;
      for (const shader::Parameter& p : f.parameters) in.values.push_back(part_of(random_, {p.min, p.max}));
      in.cos_i = part_of(random_, {kLeastShaderCosine, 1});
      in.cos_o = part_of(random_, {kLeastShaderCosine, 1});
      in.turn_i = turns ? Bounds{0, 0} : part_of(random_, {-2, 2});
      in.turn_o = part_of(random_, {-2, 2});
      const Bounds bounds = shader_on_box<T>(f, in).value;
      count += kOfABox;
      if (!std::isfinite(bounds.lo)) continue;
      for (long k = 0; k < kOfABox; ++k) look(program, f, runner, in, bounds, turns);
    }
  }

  template <class T>
  void look(const RandomProgram& program, const shader::Function& f, shader::Runner<T, 1>& runner,
            const ShaderInputs& in, Bounds bounds, bool turns) {
    std::vector<T> values;
    std::vector<double> wide;
    for (const Bounds& v : in.values) {
      values.push_back(T(within(random_, v)));
      wide.push_back(double(values.back()));
      if (!(v.lo <= wide.back() && wide.back() <= v.hi)) return;  // rounded out of the box
    }
    const double by = turns ? 2 * kPi * double(random_() >> 11) * 0x1p-53 : 0;
    const Vec3<T> wi = direction_at<T>(within(random_, in.cos_i), within(random_, in.turn_i), by),
                  wo = direction_at<T>(within(random_, in.cos_o), within(random_, in.turn_o), by);
    const double value = double(shader::evaluate<T>(f, runner, values, wi, wo, 0));
    if (!(bounds.lo <= value && value <= bounds.hi) && found_.outside++ == 0)
      found_.faults.push_back(io::short_number(value, 17) + " is outside " + io::short_number(bounds.lo, 17) +
                              " .. " + io::short_number(bounds.hi, 17) + ":\n" + program.text);
    const auto convert = [](const Vec3<T>& w) { return Vec3<double>{w.x, w.y, w.z}; };
    const auto undefined = shader::undefined_value<T>(f, wide, convert(wi), convert(wo));
    if (undefined && found_.undefined_inside++ == 0)
      found_.faults.push_back("a value is undefined although the enclosure is finite, " +
                              to_text(f, *undefined) + ":\n" + program.text);
  }

  const SelfTestOptions& options_;
  const io::Progress& progress_;
  std::mt19937_64 random_;
  shader::Compiler compiler_;
  SelfTest found_;
};

}  // namespace

SelfTest self_test(const SelfTestOptions& options, const io::Progress& progress) {
  return Attack(options, progress).run();
}

}  // namespace brdf::prove
