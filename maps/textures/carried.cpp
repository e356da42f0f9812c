#include "maps/textures/carried.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "brdf/frame.h"
#include "brdf/targets/parts.h"
#include "interop/wanted.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "maps/textures/texel_loss.h"

namespace brdf::maps {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

std::string listed(const std::vector<std::string_view>& names) {
  return io::joined({names.begin(), names.end()});
}

// The target's parameters in every texel before any rounding.
class Attempt {
 public:
  Attempt(const TexelMaterials& maps, const interop::Program& program, const interop::TargetRules& rules)
      : maps_(maps),
        rules_(rules),
        textured_(*find_textured(info(rules.target).name)),
        limits_(interop::limits_of(program)),
        out_{.program = &program, .target = rules.target} {
    index_ = info(rules.target).shape_index(Role::index);
    for (const Input& input : textured_.inputs) {
      knobs_.emplace_back(rules.target, input);
      if (input.role == Role::index) index_ = -1;
    }
  }

  Carried carry(const io::Progress& progress) {
    copy_texels();
    share_index();
    for (std::size_t k = 0; k < knobs_.size(); ++k) store(k);
    store_normals();
    measure(progress);
    return std::move(out_);
  }

 private:
  std::size_t colours() const { return maps_.channels().size(); }

  // Copies the parameters of every texel. A texel that the program cannot show is left out.
  void copy_texels() {
    out_.held.assign(maps_.size(), false);
    etas_.assign(maps_.size(), 1);
    for (const Input& input : textured_.inputs)
      raw_.emplace_back(input.coloured ? colours() : 1, std::vector<double>(maps_.size(), 0.0));
    for (std::size_t texel = 0; texel < maps_.size(); ++texel) {
      if (!maps_.fitted(texel)) {
        ++out_.without_fit;
        continue;
      }
      try {
        copy_texel(texel);
        out_.held[texel] = true;
      } catch (const interop::Refused& refused) {
        if (out_.refused++ == 0) out_.reason = maps_.place(texel) + ": " + refused.what();
      }
    }
    if (std::ranges::find(out_.held, true) == out_.held.end()) throw interop::Refused(out_.reason);
  }

  void copy_texel(std::size_t texel) {
    const std::vector<interop::Wanted> parts = interop::wanted(maps_.at(texel), limits_);
    Term term = interop::copied(parts.front(), rules_.target, rules_.copy).terms[0];
    if (term.shape.size() == 1) term.shape.assign(colours(), term.shape[0]);
    hold_bounds(term);
    if (index_ >= 0) etas_[texel] = term.shape[0][std::size_t(index_)];
    for (std::size_t k = 0; k < knobs_.size(); ++k)
      for (std::size_t c = 0; c < raw_[k].size(); ++c) raw_[k][c][texel] = knobs_[k].get(term, c);
    const int width = info(rules_.target).shape_index(Role::width);
    if (const double alpha = term.shape[0][std::size_t(width)]; alpha < textured_.least_width)
      throw interop::Refused("alpha " + io::to_text(alpha) + " is below " +
                             io::to_text(textured_.least_width) + ", below which the program shows a mirror");
  }

  void hold_bounds(Term& term) const {
    for (const fit::NamedRange& range : rules_.bounds)
      if (const int k = info(rules_.target).shape_index(range.name); k >= 0)
        for (std::vector<double>& shape : term.shape)
          shape[std::size_t(k)] = std::clamp(shape[std::size_t(k)], range.low, range.high);
  }

  std::size_t place_of(Role role) const {
    const auto found = std::ranges::find(textured_.inputs, role, &Input::role);
    return std::size_t(found - textured_.inputs.begin());
  }
  bool is_dielectric(std::size_t texel) const {
    const auto metallic = std::ranges::find(textured_.inputs, true, &Input::metallic);
    return out_.held[texel] && raw_[std::size_t(metallic - textured_.inputs.begin())][0][texel] < 1;
  }

  // Chooses one index for all texels. If the target has a tint, the index is the largest and the tints of the
  // texels carry the smaller reflectances; otherwise the index is the median. A texel that reflects nothing
  // along the normal has the index 1.
  void share_index() {
    if (index_ < 0) return;
    std::vector<double> indices;
    for (std::size_t texel = 0; texel < maps_.size(); ++texel)
      if (is_dielectric(texel) && etas_[texel] > 1) indices.push_back(etas_[texel]);
    const ParameterInfo& p = info(rules_.target).shape[std::size_t(index_)];
    const std::size_t tint = place_of(Role::tint);
    const bool has_tint = tint < textured_.inputs.size();
    out_.index = indices.empty() ? p.initial : has_tint ? std::ranges::max(indices) : io::median(indices);
    for (std::size_t texel = 0; has_tint && texel < maps_.size(); ++texel)
      for (std::size_t c = 0; is_dielectric(texel) && c < colours(); ++c)
        raw_[tint][c][texel] *= f0_of_index(etas_[texel]) / f0_of_index(*out_.index);
  }

  // Chooses the factors of an input and rounds its numbers.
  void store(std::size_t k) {
    InputMap& map = out_.inputs.emplace_back();
    map.input = textured_.inputs[k];
    for (const std::vector<double>& values : raw_[k]) {
      double least = HUGE_VAL, most = 0;
      for (std::size_t texel = 0; texel < maps_.size(); ++texel)
        if (out_.held[texel]) {
          const double number = map.input.scale.written(values[texel]);
          least = std::min(least, number);
          most = std::max(most, number);
        }
      map.constant = map.constant && least == most;
      map.factors.push_back(most);
    }
    for (std::size_t c = 0; c < raw_[k].size(); ++c) {
      if (map.input.storage == Storage::real && !map.constant) map.factors[c] = 1;
      std::vector<double>& shares = map.shares.emplace_back(maps_.size(), 0.0);
      for (std::size_t texel = 0; texel < maps_.size(); ++texel)
        if (out_.held[texel] && map.factors[c] > 0)
          shares[texel] = map.constant ? 1
                                       : rounded(map.input.storage,
                                                 map.input.scale.written(raw_[k][c][texel]) / map.factors[c]);
    }
  }

  void store_normals() {
    out_.has_normals = maps_.has_normals();
    out_.normals.assign(maps_.size(), {0, 0, 1});
    const Storage storage =
        textured_.inputs[0].storage == Storage::real ? Storage::real : Storage::linear_byte;
    const auto held = [&](double x) { return 2 * rounded(storage, 0.5 + 0.5 * x) - 1; };
    for (std::size_t texel = 0; out_.has_normals && texel < maps_.size(); ++texel)
      if (out_.held[texel]) {
        const Vec3<double> n = maps_.normal(texel);
        out_.normals[texel] = {held(n.x), held(n.y), held(n.z)};
      }
  }

  Material material_of(std::size_t texel) const {
    Material out = empty_target(maps_, out_);
    for (std::size_t k = 0; k < knobs_.size(); ++k)
      for (std::size_t c = 0; c < colours(); ++c)
        knobs_[k].set(out.terms[0], c, raw_[k][raw_[k].size() == 1 ? 0 : c][texel]);
    return out;
  }

  void measure(const io::Progress& progress) {
    TexelLosses& losses = out_.losses;
    for (auto* plane : {&losses.rms, &losses.of_formula, &losses.largest, &losses.turned})
      plane->assign(maps_.size(), kUnknown);
    std::mutex mutex;
    int done = 0;
    io::parallel_for(maps_.height(), [&](std::size_t row) {
      for (std::size_t x = 0; x < maps_.width(); ++x)
        if (const std::size_t texel = row * maps_.width() + x; out_.held[texel]) measure_texel(texel);
      const std::lock_guard lock(mutex);
      if (progress) progress(++done, int(maps_.height()));
    });
  }

  void measure_texel(std::size_t texel) {
    const TexelComparison own(interop::sum_of(interop::wanted(maps_.at(texel), limits_)));
    const Vec3<double> stored = out_.normals[texel];
    const Vec3<double> turned =
        out_.has_normals ? in_frame_of(maps_.normal(texel), stored * (1 / std::sqrt(dot(stored, stored))))
                         : Vec3<double>{0, 0, 1};
    const auto figures = own.figures_of(carried_material(out_, maps_, texel), turned);
    TexelLosses& losses = out_.losses;
    losses.rms[texel] = float(figures.rms);
    losses.largest[texel] = float(figures.largest);
    losses.of_formula[texel] = float(own.figures_of(material_of(texel), {0, 0, 1}).rms);
    losses.turned[texel] = float(radians(std::atan2(std::hypot(turned.x, turned.y), turned.z)).degrees());
  }

 public:
  // Returns the target with one shape for each channel and the index of all texels.
  static Material empty_target(const TexelMaterials& maps, const Carried& carried) {
    Material out =
        make_material(carried.target, maps.channels().size() == 1 ? std::vector<std::string>{"value"}
                                                                  : std::vector<std::string>{"r", "g", "b"});
    Term& term = out.terms[0];
    term.shape.assign(out.channels.size(), term.shape[0]);
    if (carried.index)
      for (std::vector<double>& shape : term.shape)
        shape[std::size_t(info(carried.target).shape_index(Role::index))] = *carried.index;
    return out;
  }

 private:
  const TexelMaterials& maps_;
  const interop::TargetRules& rules_;
  const TexturedTarget& textured_;
  interop::Limits limits_;
  std::vector<Knob> knobs_;
  int index_ = -1;  // of the target's index of refraction, if no input drives it
  std::vector<std::vector<std::vector<double>>> raw_;  // [input][colour][texel], parameters of the target
  std::vector<double> etas_;
  Carried out_;
};

}  // namespace

const InputMap& Carried::input(std::string_view name) const {
  for (const InputMap& map : inputs)
    if (map.input.name == name) return map;
  throw std::logic_error("no input " + std::string(name));
}

Material carried_material(const Carried& carried, const TexelMaterials& maps, std::size_t texel) {
  Material out = Attempt::empty_target(maps, carried);
  for (const InputMap& map : carried.inputs) {
    const Knob knob(carried.target, map.input);
    for (std::size_t c = 0; c < out.channels.size(); ++c) {
      const std::size_t from = map.factors.size() == 1 ? 0 : c;
      knob.set(out.terms[0], c, map.input.scale.read(map.factors[from] * map.shares[from][texel]));
    }
  }
  return out;
}

TexelLoss summary_of(const std::vector<float>& losses) {
  std::vector<double> known;
  TexelLoss out;
  for (std::size_t k = 0; k < losses.size(); ++k) {
    if (std::isnan(losses[k])) continue;
    if (known.empty() || double(losses[k]) > out.largest) out.largest = double(losses[k]), out.where = k;
    known.push_back(double(losses[k]));
  }
  out.median = io::median(known);
  out.most = io::quantile(known, 0.95);
  return out;
}

Carried carry(const TexelMaterials& maps, const interop::Program& program, const io::Progress& progress) {
  std::optional<Carried> best;
  for (const interop::TargetRules& rules : program.targets) {
    if (!find_textured(info(rules.target).name)) continue;
    Carried tried = Attempt(maps, program, rules).carry(progress);
    if (!best || summary_of(tried.losses.rms).median < summary_of(best->losses.rms).median)
      best = std::move(tried);
  }
  if (!best)
    throw interop::Refused("--to " + std::string(program.name) +
                           ": no textures are written for this program; --maps works with " +
                           listed(textured_programs()));
  return std::move(*best);
}

}  // namespace brdf::maps
