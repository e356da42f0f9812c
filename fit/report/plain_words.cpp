#include "fit/report/plain_words.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/reported.h"
#include "fit/model/constraints.h"
#include "fit/report/report.h"
#include "fit/report/states.h"
#include "io/files/numbers.h"
#include "io/page/glossary.h"

namespace brdf::fit {
namespace {

using io::Mark;

constexpr double kWideFactor = 4;    // for a parameter on a logarithmic scale
constexpr double kWideShare = 0.5;   // relative to the value
constexpr double kWideRange = 0.05;  // relative to the usual range

// The term and the table entry of a name. `form` is null for tangent_phi, which belongs to no form.
struct NamedPlace {
  const ReflectanceInfo* form = nullptr;
  const ParameterInfo* info = nullptr;
};

NamedPlace place_of(const FormFit& fit, const std::string& name) {
  const std::size_t terms = fit.material.terms.size();
  for (std::size_t t = 0; t < terms; ++t) {
    const ReflectanceInfo& form = info(fit.material.terms[t].form);
    for (const auto& table : {form.shape, form.weights})
      for (const ParameterInfo& p : table)
        if (name_in_sum(terms, t, p.name) == name) return {&form, &p};
  }
  return {nullptr, &kTangentInfo};
}

bool is_weight(Role role) {
  return role == Role::diffuse || role == Role::specular;
}

// Returns whether both axes of the form have this value, so that one name suffices for both.
bool has_one_width(const FormFit& fit, const Estimate& e, const NamedPlace& at) {
  if (!at.form || !at.form->anisotropic()) return false;
  const auto [along, across] = at.form->axes();
  const ParameterInfo &first = at.form->shape[std::size_t(along)],
                      &second = at.form->shape[std::size_t(across)];
  if (at.info != &first && at.info != &second) return false;
  const ParameterInfo& other = at.info == &first ? second : first;
  const std::string partner =
      e.name.substr(0, e.name.size() - at.info->name.size()) + std::string(other.name);
  return std::ranges::any_of(fit.estimates, [&](const Estimate& o) {
    return o.name == partner && o.channel == e.channel && o.value == e.value && o.status == e.status &&
           (o.status != Status::free || (o.low == e.low && o.high == e.high));
  });
}

// Returns the sum of all weights of an estimate's channel (of the first channel if all channels share the
// estimate).
double weights_of_channel(const FormFit& fit, const Estimate& e) {
  double sum = 0;
  const Material& m = fit.material;
  const auto channel = std::ranges::find(m.channels, e.channel);
  const std::size_t c = channel == m.channels.end() ? 0 : std::size_t(channel - m.channels.begin());
  for (const Term& term : m.terms) {
    const auto& table = info(term.form).weights;
    for (std::size_t k = 0; k < table.size(); ++k)
      if (is_weight(table[k].role)) sum += term.weights[c][k];
  }
  return sum;
}

bool is_weak(const FormFit& fit, const Estimate& e) {
  if (e.status != Status::free) return false;
  const bool wrong = fit.lack_of_fit.beyond_scatter && std::isfinite(e.with_lack_of_fit.low);
  const Extent extent = wrong ? e.with_lack_of_fit : Extent{e.low, e.high};
  if (!std::isfinite(extent.low)) return false;
  const ParameterInfo& p = *place_of(fit, e.name).info;
  if (p.log_scale) return extent.high > kWideFactor * std::max(extent.low, p.min);
  const double range = is_weight(p.role) ? weights_of_channel(fit, e) : p.usual_max - p.min;
  return extent.high - extent.low > 2 * std::max(kWideShare * std::abs(e.value), kWideRange * range);
}

// Returns whether the first word of a finding is a parameter. Its case must then not change: "f0 is at its
// upper bound 1".
bool begins_with_name(const FormFit& fit, std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" ,"));
  return std::ranges::any_of(
      fit.estimates, [&](const Estimate& e) { return e.name == word || named(fit, e).symbol == word; });
}

}  // namespace

std::vector<std::string> weakly_determined(const FormFit& fit) {
  std::vector<std::pair<std::string, std::vector<std::string>>> weak;  // name, channels
  for (const Estimate& e : fit.estimates) {
    if (!is_weak(fit, e)) continue;
    const NamedParameter parameter = named(fit, e);
    if (parameter.repeats) continue;
    auto at = std::ranges::find_if(weak, [&](const auto& w) { return w.first == parameter.symbol; });
    if (at == weak.end()) at = weak.insert(at, {parameter.symbol, {}});
    if (!e.channel.empty()) at->second.push_back(e.channel);
  }
  std::vector<std::string> out;
  for (const auto& [name, channels] : weak)
    out.push_back(channels.empty() || fit.material.channels.size() == 1
                      ? name
                      : name + " (" + io::joined(channels) + ")");
  return out;
}

std::string weakness_text(const FormFit& fit) {
  const std::vector<std::string> weak = weakly_determined(fit);
  return weak.empty() ? "" : "weakly determined: " + io::joined(weak);
}

std::vector<io::Remark> remarks_on(const FormFit& f) {
  std::vector<io::Remark> remarks;
  const Mark mark = usable(f.verdict) ? Mark::warn : Mark::bad;
  const auto sentence = [&](std::string text) {
    if (!begins_with_name(f, text)) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
  };
  for (const std::string& finding : f.findings) remarks.push_back({mark, sentence(finding)});
  for (const Condition condition : conditions_of(f))
    if (const std::string text = sentence_of(condition, f); !text.empty())
      remarks.push_back({state_of(condition).mark, sentence(text)});
  if (const std::string weak = weakness_text(f); !weak.empty())
    remarks.push_back({Mark::warn, sentence(weak + "; the table of parameters lists the intervals")});
  if (f.solved())
    remarks.push_back({f.lack_of_fit.beyond_scatter ? Mark::warn
                       : f.lack_of_fit.judged()     ? Mark::good
                                                    : Mark::unknown,
                       "Lack of fit: " + in_words(f.lack_of_fit) + "."});
  return remarks;
}

NamedParameter named(const FormFit& fit, const Estimate& e) {
  const NamedPlace at = place_of(fit, e.name);
  NamedParameter out{std::string(at.info->doc), e.name, std::string(at.info->doc), false, at.info};
  if (at.form) {
    const bool one = has_one_width(fit, e, at);
    out.plain = io::plain_name(*at.form, *at.info, one);
    if (one) {
      const std::size_t prefix = e.name.size() - at.info->name.size();
      out.symbol = e.name.substr(0, prefix) + std::string(at.form->tied_name());
      out.repeats = at.info == &at.form->shape[std::size_t(at.form->axes().across)];
    }
    if (fit.material.terms.size() > 1) out.plain += ", " + std::string(at.form->name);
  }
  if (!at.info->unit.empty()) out.plain += ", " + std::string(at.info->unit);
  return out;
}

}  // namespace brdf::fit
