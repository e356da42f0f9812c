#include "validate/form/against.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/material/settings.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kSame = 1e-3;  // a smaller relative difference is invisible
// Relative to a range's end: rounding in a formula moves no value out of the range.
constexpr double kRounding = 1e-12;
constexpr std::size_t kSampled = 4096;

using Named = std::vector<std::pair<std::string, double>>;

double value_of(const Named& parameters, std::string_view name) {
  for (const auto& [known, value] : parameters)
    if (known == name) return value;
  return NAN;
}

// Values of the form's mapped parameters at the subject's `parameters`, in the order of `mapped`.
std::vector<double> mapped_values(const Against& against, const Named& parameters) {
  std::vector<double> values;
  for (const MappedParameter& m : against.mapped)
    values.push_back(m.formula
                         ? m.formula->value([&](std::string_view of) { return value_of(parameters, of); })
                         : value_of(parameters, m.name));
  return values;
}

std::vector<double> mapped_at(const Subject& subject, const Against& against, std::span<const double> point) {
  return mapped_values(against, subject.parameters(subject.at(point)));
}

// Returns by how much the values lie outside the form's ranges, in widths of these ranges. 0: all values
// are within.
double outside(const Against& against, std::span<const double> values) {
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ParameterInfo& p = against.mapped[k].info;
    if (std::isnan(values[k])) return HUGE_VAL;
    const double end = std::clamp(values[k], p.min, p.max), beyond = std::abs(values[k] - end);
    if (beyond > kRounding * std::abs(end)) sum += beyond / (p.max - p.min);
  }
  return sum;
}

// The range of the values that a quantity has taken.
struct Span {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

std::string in_words(const Span& s) {
  const std::string low = io::short_number(s.low, 4), high = io::short_number(s.high, 4);
  return low == high ? low : low + " to " + high;
}

// The form with the given values, which lie within its ranges apart from rounding.
Material counterpart(const Against& against, const Material& at, std::span<const double> values) {
  Material m = make_material(against.form, at.channels);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& [name, p, formula] = against.mapped[k];
    io::apply_settings(m, {{name, {std::clamp(values[k], p.min, p.max)}}});
  }
  return m;
}

// The form's own parameters that are set by the parameter `name`.
std::vector<std::string> set_by(const ReflectanceInfo& form, const std::string& name) {
  if (!form.anisotropic() || name != form.tied_name()) return {name};
  const auto [along, across] = form.axes();
  return {std::string(form.shape[std::size_t(along)].name),
          std::string(form.shape[std::size_t(across)].name)};
}

void add_same_names(Against& against, const Named& parameters) {
  const ReflectanceInfo& form = info(against.form);
  std::vector<std::string> set;
  for (const MappedParameter& m : against.mapped)
    for (std::string& name : set_by(form, m.name)) set.push_back(std::move(name));
  for (const auto table : {form.weights, form.shape})
    for (const ParameterInfo& p : table) {
      if (std::ranges::find(set, p.name) != set.end()) continue;
      if (std::isnan(value_of(parameters, p.name)))
        against.defaults.emplace_back(p.name, p.initial);
      else
        against.mapped.push_back({std::string(p.name), p, std::nullopt});
    }
}

// Calls visit(values) for a cover of the subject's parameter domain.
template <class Visit>
void for_parameters(const Subject& subject, const Against& against, const Visit& visit) {
  const std::size_t count = subject.dimensions() == 0 ? 1 : kSampled;
  for (std::size_t k = 0; k < count; ++k)
    visit(mapped_at(subject, against, cover_point(k, subject.dimensions(), 1)));
}

// Finds the parameters that lie outside the form's ranges by the smallest amount.
Best nearest_within(const Subject& subject, const Against& against) {
  const Objective within = [&](std::span<const double> point) {
    return -outside(against, mapped_at(subject, against, point));
  };
  return maximise(within, subject.dimensions(), {.cover = kSampled});
}

// If no parameters of the subject had a counterpart, nothing would be compared, and the check would report
// agreement without any evidence.
void require_overlap(const Subject& subject, const Against& against) {
  const Best nearest = nearest_within(subject, against);
  if (nearest.value >= 0) return;
  std::vector<Span> taken(against.mapped.size());
  for_parameters(subject, against, [&](const std::vector<double>& values) {
    for (std::size_t k = 0; k < values.size(); ++k) taken[k].add(values[k]);
  });
  const std::vector<double> values = mapped_at(subject, against, nearest.point);
  std::string all;
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const ParameterInfo& p = against.mapped[k].info;
    if (p.min <= values[k] && values[k] <= p.max) continue;
    const bool none = taken[k].low > taken[k].high;
    all += (all.empty() ? "" : ", ") + against.mapped[k].name + " would be " +
           (none ? "not a number" : in_words(taken[k])) + " and must be between " + io::to_text(p.min) +
           " and " + io::to_text(p.max);
  }
  throw InputError("--against " + std::string(info(against.form).name) +
                   ": nothing can be compared, because no parameters of " + subject.name() +
                   " are within the form's ranges: " + all);
}

// Points for the search's grid. They are the corners of the parameter cube, each approached from an
// interior point as far as the form's ranges permit, and a cover of the part within the ranges.
std::vector<std::vector<double>> points_within(const Subject& subject, const Against& against,
                                               const CheckOptions& options) {
  const auto inside = [&](std::span<const double> point) {
    return outside(against, mapped_at(subject, against, point)) == 0;
  };
  const std::size_t dimensions = subject.dimensions();
  const std::vector<double> known = nearest_within(subject, against).point;
  std::vector<std::vector<double>> points{};
  for (const std::vector<double>& corner : cube_corners(dimensions, 5)) {
    std::vector<double> point = known;
    for (std::size_t d = 0; d < dimensions; ++d) {
      double good = point[d], far = corner[d];
      point[d] = far;
      for (int step = 0; step < 50 && !inside(point); ++step) {
        point[d] = good + 0.5 * (far - good);
        (inside(point) ? good : far) = point[d];
        point[d] = far;
      }
      if (!inside(point)) point[d] = good;
    }
    points.push_back(std::move(point));
  }
  std::size_t left = dimensions > 0 ? parameter_cover(options) : 0;
  for (std::size_t k = 0; left > 0 && k < kSampled; ++k) {
    std::vector<double> point = cover_point(k, dimensions, options.seed);
    if (!inside(point)) continue;
    points.push_back(std::move(point));
    --left;
  }
  return points;
}

// The parameter values that the search compared.
class Compared {
 public:
  Compared(const Subject& subject, const Against& against)
      : against_(against), taken_(against.mapped.size()) {
    std::size_t all = 0, left_out = 0;
    for_parameters(subject, against, [&](const std::vector<double>& values) {
      ++all;
      left_out += outside(against, values) > 0;
    });
    left_out_ = double(left_out) / double(all);
  }

  void add(std::span<const double> values) {
    for (std::size_t k = 0; k < values.size(); ++k) taken_[k].add(values[k]);
  }

  std::string in_words() const {
    std::string words;
    for (std::size_t k = 0; k < taken_.size(); ++k)
      words +=
          (k == 0 ? "; compared for " : ", ") + against_.mapped[k].name + " " + validate::in_words(taken_[k]);
    if (left_out_ > 0.99)
      words += " (nearly all parameters are outside the form's ranges and are left out)";
    else if (left_out_ > 0)
      words += " (" + io::percent(left_out_, 2) +
               " of the parameters are outside the form's ranges and are left out)";
    for (std::size_t k = 0; k < against_.defaults.size(); ++k)
      words += (k == 0 ? "; the form's defaults: " : ", ") + against_.defaults[k].first + " = " +
               io::short_number(against_.defaults[k].second, 4);
    return words;
  }

 private:
  const Against& against_;
  std::vector<Span> taken_;
  double left_out_ = 0;
};

}  // namespace

Against parse_against(const Subject& subject, const std::string& form, const std::vector<std::string>& maps) {
  Against out{io::require_form(form), {}, {}};
  const Material sample = make_material(out.form, {"fr"});
  const Named parameters = subject.parameters(subject.own());
  for (const std::string& text : maps) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw InputError("--map '" + text + "': must be NAME=FORMULA, such as alpha=roughness*roughness");
    const std::string name = text.substr(0, equals);
    const ParameterInfo p = io::parameter_named(sample, name, "--map");
    io::Expression formula(text.substr(equals + 1), "--map");
    for (const std::string& of : formula.names())
      if (std::isnan(value_of(parameters, of))) {
        std::vector<std::string> known;
        for (const auto& [of_subject, value] : parameters) known.push_back(of_subject);
        throw InputError("--map '" + text + "': " + of + " is not a parameter of " + subject.name() +
                         " (known: " + io::joined(known) + ")");
      }
    out.mapped.push_back({name, p, std::move(formula)});
  }
  add_same_names(out, parameters);
  require_overlap(subject, out);
  return out;
}

Finding check_against(const Subject& subject, const Against& against, const CheckOptions& options) {
  Compared compared(subject, against);
  const PairMeasure measure = [&](const Material& at, const Pair& p) {
    const std::vector<double> values = mapped_values(against, subject.parameters(at));
    if (const double far = outside(against, values); far > 0) return -far;
    compared.add(values);
    std::vector<double> a(at.channels.size()), b(a.size());
    eval(at, p.wi, p.wo, a);
    eval(counterpart(against, at, values), p.wi, p.wo, b);
    double worst = 0;
    for (std::size_t c = 0; c < a.size(); ++c)
      worst = std::max(worst, std::isfinite(a[c]) ? difference(a[c], b[c], kFaintest) : 1);
    return worst;
  };
  const Best best = worst_pair(subject, measure, options, points_within(subject, against, options));
  const Material at = subject.at(best.point);
  const Pair pair = pair_of(subject, best.point);
  const std::vector<double> values = mapped_values(against, subject.parameters(at));
  Finding finding{subject.name(), "against"};
  finding.value = best.value;
  finding.bound = kSame;
  finding.evaluations = 2 * best.calls;
  const std::string name(info(against.form).name);
  if (best.value < 0) {
    finding.value = 0;
    finding.outcome = Outcome::undecided;
    finding.statement = "the search found no parameters within the ranges of " + name;
    return finding;
  }
  std::vector<double> a(at.channels.size()), b(a.size());
  eval(at, pair.wi, pair.wo, a);
  eval(counterpart(against, at, values), pair.wi, pair.wo, b);
  finding.witness = pair_witness(subject, at, pair);
  std::string with;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (against.mapped[k].formula)
      with += (with.empty() ? " with " : ", ") + against.mapped[k].name + " = " + io::short_number(values[k]);
  const std::string what = compared.in_words();
  finding.conclude(!(best.value > kSame), "equals " + name + " to " + io::percent(best.value, 2) + what,
                   "differs from " + name + with + " by " + io::percent(best.value, 3) + " of the larger: " +
                       io::short_number(a[0], 5) + " against " + io::short_number(b[0], 5) + " /sr" + what);
  return finding;
}

}  // namespace brdf::validate
