#include "io/samples/polarisation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using P = Polarisation;

// The channel of each polarisation, among the channels that share a name.
struct Polarised {
  std::map<P, std::size_t> channels;
  std::vector<std::size_t> with(std::initializer_list<P> all) const {
    std::vector<std::size_t> found;
    for (const P p : all)
      if (const auto at = channels.find(p); at != channels.end()) found.push_back(at->second);
    return found.size() == all.size() ? found : std::vector<std::size_t>{};
  }
};

// The channels to add, and the factor of their sum.
struct Sum {
  std::vector<std::size_t> channels;
  double factor;
};

Sum sum_of(const Polarised& all, P asked) {
  const auto first = [](std::vector<std::size_t> a, std::vector<std::size_t> b) { return a.empty() ? b : a; };
  switch (asked) {
    case P::average:
      return {first(all.with({P::s, P::p}), all.with({P::ss, P::sp, P::ps, P::pp})), 0.5};
    case P::s:
      return {first(all.with({P::s}), all.with({P::ss, P::sp})), 1};
    case P::p:
      return {first(all.with({P::p}), all.with({P::ps, P::pp})), 1};
    default:
      return {all.with({asked}), 1};
  }
}

class Choice {
 public:
  Choice(SampleTable& table, P asked) : table_(table), asked_(asked) {}

  void make() {
    std::map<std::string, Polarised> polarised;
    for (std::size_t c = 0; c < table_.channels.size(); ++c) {
      const PolarisedName name = polarised_name(table_.channels[c]);
      if (!name.of) continue;
      if (const auto [first, is_new] = polarised[name.name].channels.emplace(*name.of, c); !is_new)
        refuse("channels " + shown(table_.channels[first->second]) + " and " + shown(table_.channels[c]) +
               " are both " + std::string(name_of(*name.of)));
    }
    if (polarised.empty()) refuse("no channel name contains a polarisation; found " + found());
    SampleTable out;
    for (std::size_t c = 0; c < table_.channels.size(); ++c) {
      const PolarisedName name = polarised_name(table_.channels[c]);
      if (!name.of)
        take(out, table_.channels[c], {{c}, 1});
      else if (const auto node = polarised.extract(name.name))
        take(out, name.name, sum_for(name.name, node.mapped()));
    }
    table_.warnings.push_back("polarisation " + std::string(name_of(asked_)) + ": " + found() + " became " +
                              joined(out.channels));
    table_.channels = std::move(out.channels);
    table_.values = std::move(out.values);
    table_.sigma = std::move(out.sigma);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(table_.name() + ": --polarisation " + std::string(name_of(asked_)) + ": " + what);
  }

  std::string found() const { return joined(table_.channels); }

  Sum sum_for(const std::string& name, const Polarised& channels) const {
    const Sum sum = sum_of(channels, asked_);
    if (!sum.channels.empty()) return sum;
    std::string stated;
    for (const auto& [p, c] : channels.channels) (stated += stated.empty() ? "" : ", ") += name_of(p);
    refuse("cannot be computed from the channels of " + shown(name) + ": " + stated);
  }

  void take(SampleTable& out, const std::string& name, const Sum& sum) const {
    if (std::ranges::find(out.channels, name) != out.channels.end())
      refuse("channel " + shown(name) + " has the same name as polarised channels");
    out.channels.push_back(name);
    std::vector<double>& values = out.values.emplace_back(table_.rows(), 0.0);
    for (const std::size_t c : sum.channels)
      for (std::size_t k = 0; k < values.size(); ++k) values[k] += table_.values[c][k];
    for (double& value : values) value *= sum.factor;
    std::vector<double>& sigma = out.sigma.emplace_back();
    if (!std::ranges::all_of(sum.channels, [&](std::size_t c) { return table_.has_sigma(c); })) return;
    sigma.assign(table_.rows(), 0.0);
    for (const std::size_t c : sum.channels)
      for (std::size_t k = 0; k < sigma.size(); ++k) sigma[k] = std::hypot(sigma[k], table_.sigma[c][k]);
    for (double& s : sigma) s *= sum.factor;
  }

  SampleTable& table_;
  P asked_;
};

}  // namespace

void choose_polarisation(SampleTable& table, Polarisation asked) {
  Choice(table, asked).make();
}

}  // namespace brdf::io
