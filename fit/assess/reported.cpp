#include "fit/assess/reported.h"

#include <algorithm>
#include <cmath>

namespace brdf::fit {
namespace {

std::string prefixed(const Model& model, std::size_t term, std::string_view name) {
  if (model.terms().size() == 1) return std::string(name);
  return "terms[" + std::to_string(term) + "]." + std::string(name);
}

void add_shape(const Model& model, std::span<const double> p, std::size_t t, std::vector<Reported>& out) {
  const TermModel& term = model.terms()[t];
  for (std::size_t g = 0; g < model.groups(); ++g) {
    const std::vector<double> shape = model.shape(p, t, g);
    for (std::size_t k = 0; k < shape.size(); ++k) {
      Reported r;
      r.estimate.name = prefixed(model, t, term.info->shape[k].name);
      if (model.groups() > 1) r.estimate.channel = model.channels()[g];
      r.estimate.value = shape[k];
      for (std::size_t s = 0; s < model.shape_slots(); ++s) {
        const Slot& slot = model.slots()[s];
        if (slot.kind == Slot::Kind::shape && slot.term == t && slot.group == g &&
            std::find(slot.members.begin(), slot.members.end(), k) != slot.members.end()) {
          r.slot = s;
          r.gradient = {{s, slot.slope(p[s])}};
          r.min = slot.min, r.max = slot.max;
        }
      }
      out.push_back(std::move(r));
    }
  }
}

void add_weights(const Model& model, std::span<const double> p, std::size_t t, std::vector<Reported>& out) {
  const TermModel& term = model.terms()[t];
  std::vector<double> lobes(model.lobes());
  for (std::size_t c = 0; c < model.channels().size(); ++c) {
    model.lobe_weights(p, c, lobes);
    double total = 0;
    for (double w : lobes) total += w;
    const LinearBlock& block = term.weights[c];
    const auto table = term.form->weights_of(std::span(lobes).subspan(term.first_lobe, term.lobes));
    for (std::size_t k = 0; k < table.size(); ++k) {
      const ParameterInfo& info = term.info->weights[k];
      Reported r;
      r.estimate.name = prefixed(model, t, info.name);
      r.estimate.channel = model.channels()[c];
      r.estimate.value = table[k].value;
      for (std::size_t u = 0; u < block.unknowns; ++u) {
        double slope = 0, size = 0;
        for (std::size_t l = 0; l < block.lobes; ++l) {
          slope += table[k].by_lobe[l] * block.a[l * block.unknowns + u];
          size += std::abs(table[k].by_lobe[l] * block.a[l * block.unknowns + u]);
        }
        if (std::abs(slope) > 1e-12 * size) r.gradient.push_back({block.first_slot + u, slope});
      }
      r.min = info.min, r.max = info.max;
      r.weight = true;
      r.fresnel = info.role == Role::f0;
      r.weight_scale = total;
      out.push_back(std::move(r));
    }
  }
}

std::string_view base_name(std::string_view name) {
  const auto dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

}  // namespace

std::vector<Reported> reported_parameters(const Model& model, std::span<const double> p) {
  std::vector<Reported> out;
  for (std::size_t t = 0; t < model.terms().size(); ++t) add_shape(model, p, t, out);
  if (const std::size_t s = model.tangent_slot(); s != kNoSlot) {
    Reported r;
    r.estimate.name = "tangent_phi";
    r.estimate.value = p[s] * 180 / kPi;
    r.slot = s;
    r.gradient = {{s, 180 / kPi}};
    r.min = -180, r.max = 180;
    out.push_back(std::move(r));
  }
  for (std::size_t t = 0; t < model.terms().size(); ++t) add_weights(model, p, t, out);
  return out;
}

std::string label(const Estimate& e) {
  return e.channel.empty() ? e.name : e.name + "[" + e.channel + "]";
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

std::vector<std::string> names_with(const std::vector<Reported>& all, Status status, std::size_t channels) {
  std::vector<std::pair<std::string, std::vector<std::string>>> grouped;
  for (const Reported& r : all) {
    if (r.estimate.status != status) continue;
    auto it = std::find_if(grouped.begin(), grouped.end(),
                           [&](const auto& g) { return g.first == r.estimate.name; });
    if (it == grouped.end()) it = grouped.insert(grouped.end(), {r.estimate.name, {}});
    if (!r.estimate.channel.empty()) it->second.push_back(r.estimate.channel);
  }
  std::vector<std::string> out;
  for (const auto& [name, list] : grouped) {
    std::string text = name;
    if (!list.empty() && list.size() < channels) {
      text += " (";
      for (std::size_t k = 0; k < list.size(); ++k) text += (k ? ", " : "") + list[k];
      text += ")";
    }
    out.push_back(std::move(text));
  }
  return out;
}

std::string advice(const std::vector<Reported>& all, const Model& model) {
  const auto unidentified = [&](std::string_view name) {
    return std::any_of(all.begin(), all.end(), [&](const Reported& r) {
      return r.estimate.status == Status::unidentified && base_name(r.estimate.name) == name;
    });
  };
  const auto zero = [&](std::string_view name) {
    bool any = false;
    for (const Reported& r : all)
      if (base_name(r.estimate.name) == name) {
        if (r.estimate.status != Status::at_bound || r.estimate.value > 0) return false;
        any = true;
      }
    return any;
  };
  const bool width = unidentified("alpha_x") || unidentified("alpha_y") || unidentified("exponent");
  if (width && zero("ks")) return "the samples show no specular lobe: leave it out, or fix its width";
  if (unidentified("tangent_phi"))
    return "measure more azimuths with the sample rotated, or fit without --anisotropic";
  if (unidentified("sigma"))
    return "measure more azimuths on the side of the light (phi_o - phi_i below 90 degrees), or fix sigma";
  if (unidentified("f0") && !width)
    return "only ks f0 is seen where the light is nearly head-on: measure towards grazing (theta_d above 40 "
           "degrees), or fix f0";
  if (width) return "measure closer to the mirror direction, or fix the width";
  if (model.terms().size() > 1) return "fit fewer terms, or fix some of them";
  return "measure more directions, or fix one of them";
}

}  // namespace brdf::fit
