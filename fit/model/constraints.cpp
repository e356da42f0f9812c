#include "fit/model/constraints.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

// One option, for example --fix, as applied to all parameters that it names.
struct Given {
  std::string option, name;
  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(option + " " + name + ": " + reason);
  }
  void check_range(double value, double low, double high) const {
    if (!(value >= low && value <= high))
      refuse(io::to_text(value) + " is outside " + io::to_text(low) + " to " + io::to_text(high));
  }
};

// The argument of an option that ties a parameter to one value for all channels.
struct Tied {};

// A parameter to which a name refers.
struct Target {
  Constraint* constraint;
  const ParameterInfo* info;
  bool per_channel;  // may differ between channels
};

bool all_diffuse(const ReflectanceInfo& info) {
  return info.basis ||
         std::ranges::all_of(info.weights, [](const ParameterInfo& p) { return p.role == Role::diffuse; });
}

// Returns the constraint of the table. A parameter with a range of a single value is held there.
Constraint constraint_of(const ParameterInfo& p) {
  if (p.min < p.max) return {{}, {}, p.min, p.max, false, {}};
  return {{p.min}, {}, p.min, p.max, false, "has one value only, " + io::to_text(p.min)};
}

class Resolver {
 public:
  Resolver(std::span<const Reflectance> forms, std::span<const std::string> channels,
           const FitOptions& options)
      : forms_(forms),
        names_(channels.begin(), channels.end()),
        channels_(channels.size()),
        options_(options) {
    for (const Reflectance& form : forms) add_term(form.info());
    out_.tangent.low = kTangentInfo.min;
    out_.tangent.high = kTangentInfo.max;
    if (!options.anisotropic) out_.tangent.idle = "has an effect only with --anisotropic";
  }

  Constraints run() {
    for (const NamedValues& fix : options_.fix) apply({"--fix", fix.name}, fix);
    said_.clear();
    hold_whole_numbers();
    keep_one_diffuse_part();
    for (const std::string& name : options_.tie) apply({"--tie", name}, Tied{});
    said_.clear();
    for (const NamedRange& bounds : options_.bounds) apply({"--bounds", bounds.name}, bounds);
    said_.clear();
    for (const NamedValues& start : options_.start) apply({"--start", start.name}, start);
    return std::move(out_);
  }

 private:
  void add_term(const ReflectanceInfo& info) {
    TermConstraints term;
    for (const ParameterInfo& p : info.shape) term.shape.push_back(constraint_of(p));
    for (const ParameterInfo& p : info.weights) term.weights.push_back(constraint_of(p));
    if (info.anisotropic() && !options_.anisotropic)
      term.shape[std::size_t(info.axes().across)].idle =
          "has an effect only with --anisotropic; otherwise the value equals that of " +
          std::string(info.shape[std::size_t(info.axes().along)].name);
    out_.terms.push_back(std::move(term));
  }

  // Holds whole-number parameters: they have no derivative and are not searched.
  void hold_whole_numbers() {
    for (std::size_t t = 0; t < forms_.size(); ++t)
      for (std::size_t k = 0; k < forms_[t].info().shape.size(); ++k) {
        const ParameterInfo& p = forms_[t].info().shape[k];
        Constraint& c = out_.terms[t].shape[k];
        if (!p.whole || c.is_fixed()) continue;
        c.fixed = {p.initial};
        c.idle = "takes whole numbers only, so it is not fitted but held at " + io::to_text(p.initial) +
                 "; use --fix for another value";
      }
  }

  // Two diffuse terms of a sum would be collinear. The term of a purely diffuse form stays, otherwise the
  // first one.
  void keep_one_diffuse_part() {
    for (std::size_t t = 0; t < forms_.size(); ++t) {
      const ReflectanceInfo& info = forms_[t].info();
      const int diffuse = info.weight_index(Role::diffuse);
      if (diffuse < 0 || all_diffuse(info)) continue;
      bool elsewhere = false;
      for (std::size_t s = 0; s < forms_.size(); ++s) {
        const ReflectanceInfo& other = forms_[s].info();
        elsewhere =
            elsewhere || (s != t && all_diffuse(other)) || (s < t && other.weight_index(Role::diffuse) >= 0);
      }
      Constraint& c = out_.terms[t].weights[std::size_t(diffuse)];
      if (!elsewhere || c.is_fixed()) continue;
      c.fixed = {0};
      c.idle = "is held at 0, because another term of the sum has the diffuse part";
    }
  }

  std::vector<Target> targets(const std::string& name) {
    std::vector<Target> found;
    for (std::size_t t = 0; t < forms_.size(); ++t) {
      const ReflectanceInfo& info = forms_[t].info();
      std::string_view own = name;
      if (const std::string prefix = name_in_sum(2, t, ""); own.starts_with(prefix))
        own.remove_prefix(prefix.size());
      const auto [along, across] = info.axes();
      for (std::size_t k = 0; k < info.shape.size(); ++k)
        if (own == info.shape[k].name || (own == info.tied_name() && (int(k) == along || int(k) == across)))
          found.push_back({&out_.terms[t].shape[k], &info.shape[k], options_.shapes_differ()});
      for (std::size_t k = 0; k < info.weights.size(); ++k)
        if (own == info.weights[k].name) found.push_back({&out_.terms[t].weights[k], &info.weights[k], true});
    }
    const bool turns =
        std::ranges::any_of(forms_, [](const Reflectance& form) { return form.info().anisotropic(); });
    if (turns && name == kTangentInfo.name) found.push_back({&out_.tangent, &kTangentInfo, false});
    return found;
  }

  template <class Said>
  void apply(const Given& given, const Said& said) {
    std::string reason;
    bool effective = false;
    for (const Target& target : targets(given.name)) {
      if (!said_.insert(target.constraint).second) given.refuse("is given twice");
      if (!target.constraint->idle.empty()) {
        if (reason.empty()) reason = target.constraint->idle;
        continue;
      }
      set(given, target, said);
      effective = true;
    }
    if (!effective)
      given.refuse(reason.empty() ? name_of_sum(forms_) + " has no parameter of this name" : reason);
  }

  // Returns the values of a parameter from a table of refractive indices: one per channel, or the mean if
  // one value serves all channels.
  NamedValues from_constants(const Given& given, const Target& target, const NamedValues& said) const {
    const Role role = target.info->role;
    if (role != Role::f0 && role != Role::index && role != Role::extinction)
      given.refuse("a table of refractive indices gives values of f0, n and k only");
    NamedValues out{said.name, {}};
    if (role == Role::f0)
      out.values = said.constants->reflectances(names_);
    else
      for (const io::Index& index : said.constants->indices(names_))
        out.values.push_back(role == Role::index ? index.n : index.k);
    if (!target.per_channel || target.constraint->tied)
      out.values = {std::accumulate(out.values.begin(), out.values.end(), 0.0) / double(channels_)};
    return out;
  }

  void set(const Given& given, const Target& target, const NamedValues& said) {
    if (said.constants) return set(given, target, from_constants(given, target, said));
    if (said.values.size() != 1 && said.values.size() != channels_)
      given.refuse(io::plural(said.values.size(), "value") + " for " + io::plural(channels_, "channel"));
    if (said.values.size() > 1 && !target.per_channel)
      given.refuse(target.constraint == &out_.tangent
                       ? "takes one value"
                       : "a value for every channel has an effect only with --per-channel");
    Constraint& c = *target.constraint;
    if (said.values.size() > 1 && c.tied) given.refuse("takes a single value with --tie");
    for (const double value : said.values) {
      given.check_range(value, c.low, c.high);
      if (nearest_value(*target.info, value) != value)
        given.refuse(io::to_text(value) + " is not a whole number");
    }
    if (given.option == "--start") {
      c.start = said.values;
    } else {
      c.fixed = said.values;
      c.idle = "has no effect, because --fix holds this parameter";
    }
  }

  void set(const Given& given, const Target& target, const NamedRange& said) {
    Constraint& c = *target.constraint;
    if (&c == &out_.tangent)
      given.refuse("has no effect: use --fix to hold it, or --start to begin at a value");
    given.check_range(said.low, c.low, c.high);
    given.check_range(said.high, said.low, c.high);
    c.low = said.low;
    c.high = said.high;
  }

  void set(const Given& given, const Target& target, Tied) {
    if (channels_ == 1) given.refuse("has no effect: the samples have one channel");
    if (!target.per_channel)
      given.refuse(target.constraint == &out_.tangent ? "always has one value for all channels"
                                                      : "has an effect only with --per-channel");
    target.constraint->tied = true;
  }

  std::span<const Reflectance> forms_;
  std::vector<std::string> names_;
  std::size_t channels_;
  const FitOptions& options_;
  Constraints out_;
  std::set<const Constraint*> said_;  // constraints already set by the option that is being applied
};

}  // namespace

Constraints resolve(std::span<const Reflectance> forms, std::span<const std::string> channels,
                    const FitOptions& options) {
  return Resolver(forms, channels, options).run();
}

std::string name_of_sum(std::span<const Reflectance> forms) {
  std::string name;
  for (const Reflectance& form : forms) (name += name.empty() ? "" : "+") += form.info().name;
  return name;
}

std::string name_in_sum(std::size_t terms, std::size_t term, std::string_view parameter) {
  if (terms == 1) return std::string(parameter);
  return "terms[" + std::to_string(term) + "]." + std::string(parameter);
}

}  // namespace brdf::fit
