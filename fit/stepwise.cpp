#include "fit/stepwise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "fit/assess/paired.h"
#include "fit/assess/select.h"
#include "fit/candidates.h"
#include "fit/fit.h"
#include "fit/model/constraints.h"
#include "fit/model/model.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr double kSignificant = 0.05;
constexpr double kLeastGain = 0.01;  // relative to the held-out value; less is not worth a parameter
constexpr int kStartsOfSums = 6;

using Forms = std::vector<Reflectance>;

bool is_sound(const ReflectanceInfo& f) {
  return f.violations.empty();
}

template <class Is>
Forms fittable_forms(Is&& is) {
  Forms out;
  for (const Reflectance& form : catalogue())
    if (info(form).fittable() && is(info(form))) out.push_back(form);
  return out;
}

bool has_lobe(const ReflectanceInfo& f) {
  return f.weight_index(Role::specular) >= 0;
}

// Returns the canonical forms without a lobe, the simplest first.
Forms diffuse_forms() {
  Forms out = fittable_forms([](const ReflectanceInfo& f) { return f.canonical && !has_lobe(f); });
  std::ranges::stable_sort(out, {}, [](const Reflectance& form) { return info(form).shape.size(); });
  return out;
}

// The candidates of a step to replace the current model.
struct Stage {
  const char* adds;
  std::vector<Forms> candidates;
  std::vector<NamedValues> start = {};  // of one of its starts, unless the user gives starts
  // For special surfaces: unless it is kept, the result is that of the other steps alone.
  bool is_special = false;
};

// Returns whether the slope distribution of the microfacets has a parameter in addition to its widths.
bool shapes_its_tail(const ReflectanceInfo& f) {
  return is_sound(f) && f.facets && f.weight_index(Role::f0) >= 0 && f.shape_index(Role::other) >= 0;
}

Forms lobes() {
  return fittable_forms(
      [](const ReflectanceInfo& f) { return has_lobe(f) && (f.canonical || shapes_its_tail(f)); });
}

Stage one_lobe() {
  Stage stage{"a lobe", {}};
  for (const Reflectance& form : lobes()) stage.candidates.push_back({form});
  return stage;
}

// Proposes better diffuse terms. A sum has one diffuse term, that of its first form, which replaces the
// diffuse term of the lobe's form. If the model has no lobe, the diffuse form is used alone.
Stage better_diffuse_term(const Forms& model) {
  Stage stage{"a diffuse term with a shape", {}};
  for (const Reflectance& form : diffuse_forms()) {
    if (info(form).shape.empty()) continue;
    stage.candidates.push_back({form});
    if (has_lobe(info(model.back()))) stage.candidates.back().push_back(model.back());
  }
  return stage;
}

Stage second_lobe(const Forms& model) {
  Stage stage{"a second lobe", {}};
  for (const Reflectance& form : lobes()) {
    if (!is_sound(info(form))) continue;
    Forms sum = model;
    sum.push_back(form);
    stage.candidates.push_back(std::move(sum));
  }
  return stage;
}

// Returns the forms of a basis with as many weights as this many lights can decide: with three or four lights
// five weights, with five eight, with six fourteen. Fewer lights decide none. Many channels leave out the
// longer ones, because the time of a fit grows with the square of all weights.
Forms bases(std::size_t lights, std::size_t channels) {
  constexpr std::size_t kMostWeights = 200;
  if (lights < 3) return {};
  const int most = lights <= 4 ? 2 : lights == 5 ? 3 : lights < 8 ? 4 : 5;
  return fittable_forms([&](const ReflectanceInfo& f) {
    return f.basis && f.basis->order <= most && f.weights.size() * channels <= kMostWeights;
  });
}

Stage matt_surface(std::size_t lights, std::size_t channels) {
  Stage stage{"a matt basis", {}, {}, true};
  for (const Reflectance& form : bases(lights, channels)) stage.candidates.push_back({form});
  return stage;
}

// Proposes a basis as the body under the lobes of the model or, if the model is a basis, a lobe on it.
Stage matt_body(const Forms& model, std::size_t lights, std::size_t channels) {
  Stage stage{"a matt body", {}, {}, true};
  if (info(model.front()).basis) {
    stage.adds = "a lobe on a matt body";
    for (const Reflectance& form : lobes())
      if (is_sound(info(form))) stage.candidates.push_back({model.front(), form});
    return stage;
  }
  Forms sum;
  for (const Reflectance& form : model)
    if (has_lobe(info(form))) sum.push_back(form);
  if (sum.empty()) return stage;
  for (const Reflectance& form : bases(lights, channels)) {
    stage.candidates.push_back({form});
    stage.candidates.back().insert(stage.candidates.back().end(), sum.begin(), sum.end());
  }
  return stage;
}

// Proposes a lobe about the light, alone or together with a first lobe about its mirror image.
Stage retroreflective_lobe(const Forms& model) {
  Stage stage{"a retroreflective lobe", {}, {}, true};
  for (const Reflectance& back : fittable_forms([](const ReflectanceInfo& f) { return f.about_light; })) {
    Forms sum = model;
    sum.push_back(back);
    stage.candidates.push_back(std::move(sum));
    if (has_lobe(info(model.back()))) continue;
    for (const Reflectance& form : lobes())
      if (is_sound(info(form))) stage.candidates.push_back({form, back});
  }
  return stage;
}

// Returns the options for a stage. f0 is one value for all channels, as for a dielectric; colours of f0
// that differ from lobe to lobe cannot be identified. Every start of a sum is tried again with each lobe at
// every width, so a few starts suffice, while a grid would take minutes.
FitOptions options_for(const Stage& stage, std::size_t channels, const FitOptions& options) {
  const Forms& model = stage.candidates.front();
  FitOptions out = options;
  if (model.size() < 2) return out;
  out.grid_starts = false;
  if (out.start.empty()) out.start = stage.start;
  out.random_starts = std::max(options.random_starts, kStartsOfSums - int(!out.start.empty()));
  if (channels < 2 || !options.tie.empty()) return out;
  for (const Reflectance& form : model) {
    const int f0 = info(form).weight_index(Role::f0);
    if (f0 < 0) continue;
    const std::string_view name = info(form).weights[std::size_t(f0)].name;
    if (std::ranges::none_of(options.fix, [&](const NamedValues& held) { return held.name.ends_with(name); }))
      out.tie = {std::string(name)};
    return out;
  }
  return out;
}

// Returns the shapes of the fit as starts of a sum that has the same forms from `first` on, each of them
// `later` places later.
std::vector<NamedValues> starts_at(const FormFit& found, const Forms& forms, const FitOptions& options,
                                   std::size_t first = 0, std::size_t later = 0) {
  const Model model(forms, found.material.channels, options);
  std::vector<NamedValues> out;
  for (const Slot& slot : model.slots()) {
    const bool once = slot.node == 0 && slot.in_group(0);
    if (slot.kind != Slot::Kind::shape || !once || slot.term < first) continue;
    const ReflectanceInfo& form = info(forms[slot.term]);
    const bool tied = slot.members.size() > 1;
    NamedValues& start = out.emplace_back();
    start.name =
        name_in_sum(2, slot.term + later, tied ? form.tied_name() : form.shape[slot.members[0]].name);
    const bool shared = slot.group == kEveryGroup && slot.nodes == 1;
    for (std::size_t group = 0; group < (shared ? 1 : model.groups()); ++group)
      start.values.push_back(found.material.terms[slot.term].shape[group][slot.members[0]]);
  }
  return out;
}

class Stepwise {
 public:
  Stepwise(const Prepared& prepared, const Progress& progress)
      : prepared_(prepared), options_(prepared.options), progress_(progress) {}

  FitResult run() {
    const Forms diffuse = diffuse_forms();
    if (diffuse.empty())
      throw InputError("--form auto: no canonical form without a lobe is available to start from");
    // The lobes and the simplest diffuse form are fitted together. A robust loss is then judged with one
    // scale, which the sums use too.
    Stage first = one_lobe();
    first.candidates.push_back({diffuse.front()});
    std::vector<Solved> tried = try_all(first);
    if (tried.size() < first.candidates.size()) return finished(std::move(tried));
    model_ = std::move(first.candidates.back());
    solved_.emplace(std::move(tried.back()));
    first.candidates.pop_back();
    tried.pop_back();
    if (!comparable(chosen()) && options_.stop()) return finished(std::move(tried));
    if (!comparable(chosen()))
      throw InputError(
          "--form auto: compares forms by held-out error and needs measurements at several directions");
    result_.steps.push_back({"a diffuse term", chosen().form, chosen().left_out->value, 0, 0, 1, 1, true});
    decide(first, std::move(tried));
    step(better_diffuse_term(model_));
    if (has_lobe(info(model_.back()))) {
      Stage second = second_lobe(model_);
      second.start = starts_at(chosen(), model_, options_);
      step(second);
    }
    if (is_too_dark_about_the_light()) {
      Stage back = retroreflective_lobe(model_);
      if (has_lobe(info(model_.back()))) back.start = starts_at(chosen(), model_, options_);
      step(back);
    }
    step(matt_surface(lights(), result_.channels.size()));
    Stage body = matt_body(model_, lights(), result_.channels.size());
    // The basis takes the place of a first form without a lobe; otherwise every lobe comes one place later.
    const bool has_body = !has_lobe(info(model_.front()));
    if (!body.candidates.empty() && !info(model_.front()).basis)
      body.start = starts_at(chosen(), model_, options_, has_body ? 1 : 0, has_body ? 0 : 1);
    step(body);
    return finished({});
  }

 private:
  const std::vector<RowGroup>& groups() const { return result_.groups.groups; }

  const FormFit& chosen() const { return solved_->fit; }

  // Returns the number of angles of incidence, to whole degrees.
  std::size_t lights() const {
    std::set<long> angles;
    for (const double z : prepared_.data.wi_z)
      angles.insert(std::lround(radians(std::acos(std::clamp(z, 0.0, 1.0))).degrees()));
    return angles.size();
  }

  // Returns whether the samples about the direction of the light are well above the model.
  bool is_too_dark_about_the_light() const {
    constexpr double kNearLight = 0.985, kTooDark = 1.25;  // a cosine of 10 degrees
    constexpr std::size_t kFewestRatios = 4;
    const FitData& data = prepared_.data;
    std::vector<double> ratios, f(data.channels.size());
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const Vec3<double> wi{data.wi_x[k], data.wi_y[k], data.wi_z[k]},
          wo{data.wo_x[k], data.wo_y[k], data.wo_z[k]};
      if (dot(wi, wo) < kNearLight || wi.z > kNearLight)
        continue;  // near the normal it is the mirror direction too
      eval(chosen().material, wi, wo, f);
      for (std::size_t c = 0; c < f.size(); ++c)
        if (f[c] > 0) ratios.push_back(data.values[c][k] / f[c]);
    }
    return ratios.size() >= kFewestRatios && io::median(std::move(ratios)) > kTooDark;
  }

  // Returns the solutions in the order of the candidates; fewer if the run was interrupted.
  std::vector<Solved> try_all(const Stage& stage) {
    if (progress_) progress_("trying " + std::string(stage.adds));
    FitOptions options = options_for(stage, result_.channels.size(), options_);
    if (options.loss != Loss::none && options.loss_scale == 0) options.loss_scale = loss_scale_;
    Candidates found = solve_candidates(prepared_, stage.candidates, options);
    for (const Solved& s : found.all)
      if (s.fit.solved() && (loss_scale_ == 0 || s.fit.loss_scale < loss_scale_))
        loss_scale_ = s.fit.loss_scale;
    if (!found.about.refuted_noise.empty()) {
      result_.noise_floor = found.about.noise_floor;
      result_.refuted_noise = found.about.refuted_noise;
    }
    if (result_.channels.empty()) result_ = std::move(found.about);
    return std::move(found.all);
  }

  bool comparable(const FormFit& f) const {
    return f.solved() && f.left_out && std::isfinite(f.left_out->value);
  }
  // Values below the rounding error count as equal.
  double value(const FormFit& f) const { return std::max(f.left_out->value, result_.left_out_rounding); }

  // Returns the probability that the values of b are this far below the values of a if b is no better.
  double chance(const FormFit& a, const FormFit& b) const {
    return paired_ratio_test(a.left_out->by_group, b.left_out->by_group, result_.left_out_rounding);
  }

  // Returns the candidate with the fewest parameters that is as good as the best, or null if no candidate
  // was solved.
  Solved* simplest_of(std::vector<Solved>& tried) const {
    Solved *best = nullptr, *simplest = nullptr;
    for (Solved& s : tried)
      if (comparable(s.fit) && (!best || value(s.fit) < value(best->fit))) best = &s;
    for (Solved& s : tried) {
      const FormFit& f = s.fit;
      if (!comparable(f) || value(f) > kAsGood * value(best->fit)) continue;
      if (&s != best && chance(f, best->fit) < kSignificant) continue;
      if (!simplest || f.parameters < simplest->fit.parameters ||
          (f.parameters == simplest->fit.parameters && value(f) < value(simplest->fit)))
        simplest = &s;
    }
    return simplest;
  }

  void step(const Stage& stage) {
    if (!options_.stop() && !stage.candidates.empty()) decide(stage, try_all(stage));
  }

  void decide(const Stage& stage, std::vector<Solved> tried) {
    Solved* const simplest = simplest_of(tried);
    if (stage.is_special && !simplest) return;
    if (simplest) {
      const FormFit& next = simplest->fit;
      const double p = std::min(1.0, chance(chosen(), next) * double(tried.size()));
      const double error =
          paired_test(groups(), chosen().left_out->by_group, next.left_out->by_group).standard_error;
      const bool kept = value(next) < (1 - kLeastGain) * value(chosen()) && p < kSignificant;
      if (stage.is_special && !kept) return;
      result_.steps.push_back({stage.adds, next.form, next.left_out->value,
                               chosen().left_out->value - next.left_out->value, error, p, tried.size(),
                               kept});
      if (kept) {
        model_ = stage.candidates[std::size_t(simplest - tried.data())];
        std::swap(*solved_, *simplest);
      }
    }
    for (Solved& s : tried) others_.push_back(std::move(s.fit));
  }

  // Returns the result: the chosen model first, then the others by their held-out values.
  FitResult finished(std::vector<Solved> more) {
    for (Solved& s : more) others_.push_back(std::move(s.fit));
    std::ranges::stable_sort(others_, {}, [&](const FormFit& f) {
      return comparable(f) ? f.left_out->value : std::numeric_limits<double>::infinity();
    });
    if (solved_) {
      profile_intervals(prepared_.data, options_, progress_, *solved_);
      result_.ranking.push_back(std::move(solved_->fit));
    }
    for (FormFit& f : others_) result_.ranking.push_back(std::move(f));
    result_.recommended = 0;
    result_.interrupted = options_.stop();
    return std::move(result_);
  }

  const Prepared& prepared_;
  const FitOptions& options_;
  const Progress& progress_;
  FitResult result_;
  double loss_scale_ = 0;
  Forms model_;
  std::optional<Solved> solved_;  // the current model
  std::vector<FormFit> others_;
};

}  // namespace

FitResult fit_stepwise(const Prepared& prepared, const Progress& progress) {
  return Stepwise(prepared, progress).run();
}

}  // namespace brdf::fit
