#include "fit/solve/few_channels.h"

#include <algorithm>

namespace brdf::fit {
namespace {

constexpr std::size_t kFew = 3, kMany = 12;

bool has_one_per_channel(const std::vector<NamedValues>& named) {
  return std::ranges::any_of(named, [](const NamedValues& n) { return n.values.size() > 1; });
}

std::vector<std::size_t> spread(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < kFew; ++k) chosen.push_back((k * (count - 1) + (kFew - 1) / 2) / (kFew - 1));
  return chosen;
}

}  // namespace

std::optional<FewChannels> few_channels(const FitData& data, const Model& model, const FitOptions& options) {
  if (data.channels.size() < kMany || model.groups() > 1 || has_one_per_channel(options.fix) ||
      has_one_per_channel(options.start))
    return std::nullopt;
  FitData few = data;
  few.channels.clear();
  few.values.clear();
  few.sigma.clear();
  for (const std::size_t c : spread(data.channels.size())) {
    few.channels.push_back(data.channels[c]);
    few.values.push_back(data.values[c]);
    if (!data.sigma.empty()) few.sigma.push_back(data.sigma[c]);
  }
  std::vector<Reflectance> forms;
  for (const TermModel& term : model.terms()) forms.push_back(term.form);
  Model reduced(std::move(forms), few.channels, options);
  return FewChannels{std::move(few), std::move(reduced)};
}

}  // namespace brdf::fit
