#include "validate/joint/trio.h"

#include <algorithm>
#include <cmath>

#include "brdf/angle.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "validate/search/degrees.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

constexpr std::size_t kBlock = 4096;

// Gives each channel a colour of its own, so that choices by the brightness of a colour are seen.
void colour(Material& m, const SamplerFacts& facts, std::size_t number) {
  if (facts.colour_weights.empty() || m.terms.size() != 1) return;
  Term& term = m.terms.front();
  if (m.channels.size() != 3) {
    const std::vector<double> grey = term.weights.front();
    m.channels = {"r", "g", "b"};
    term.weights.assign(3, grey);
    if (term.shape.size() > 1) term.shape.resize(1);
  }
  constexpr double kShares[3][3] = {{1, 0.6, 0.25}, {0.3, 1, 0.7}, {0.5, 0.2, 1}};
  for (const std::size_t k : facts.colour_weights)
    for (std::size_t c = 0; c < 3; ++c) term.weights[c][k] *= kShares[(number + k) % 3][c];
}

}  // namespace

std::vector<SampledCase> cases_of(const Subject& subject, const SamplerFacts& facts,
                                  const CheckOptions& options) {
  const int count = options.effort == Effort::full ? 24 : 6;
  std::vector<SampledCase> out;
  for (int k = 0; k < count; ++k) {
    SampledCase c;
    if (k < 2 || !subject.of_form()) {
      c.at = subject.own();
      c.theta = k == 0 ? 20 : k == 1 ? 65 : 0;
      c.phi = 40;
    }
    if (k >= 2) {
      const std::vector<double> x = cover_point(std::size_t(k), subject.dimensions() + 2, options.seed);
      if (subject.of_form()) c.at = subject.at(x);
      c.theta = 5 + 75 * x[x.size() - 2];
      c.phi = 360 * x.back();
    }
    colour(c.at, facts, std::size_t(k));
    c.wo = direction(degrees(c.theta), degrees(c.phi));
    out.push_back(std::move(c));
  }
  return out;
}

std::vector<double> Trio::f(std::span<const Vec3<double>> wi, bool times_cosine) const {
  if (!facts().has_eval) return std::vector<double>(wi.size() * channels());
  DirectionArrays<double> rows(wi.size());
  for (std::size_t k = 0; k < wi.size(); ++k) rows.set(k, wi[k], case_.wo);
  std::vector<double> out(wi.size() * channels()), row(wi.size());
  for (std::size_t c = 0; c < channels(); ++c)
    for (const Term& term : case_.at.terms) {
      times_cosine ? eval_cos_batch(term, c, rows.view(), row.data())
                   : eval_batch(term, c, rows.view(), row.data());
      for (std::size_t k = 0; k < wi.size(); ++k) out[c * wi.size() + k] += row[k];
    }
  return out;
}

std::vector<double> Trio::density(std::span<const Vec3<double>> wi, bool single) const {
  std::vector<double> out(wi.size());
  sampler_.density(case_.at, case_.wo, wi, single, out);
  return out;
}

double Trio::density_of(const Vec3<double>& wi, const Vec3<double>& wo) const {
  double out = 0;
  sampler_.density(case_.at, wo, std::span(&wi, 1), false, std::span(&out, 1));
  return out;
}

std::vector<Draw> Trio::draw(std::span<const double> u, bool single) const {
  std::vector<Draw> out(u.size() / facts().randoms);
  sampler_.draw(case_.at, case_.wo, u, single, out);
  return out;
}

Draw Trio::draw_one(std::span<const double> u) const {
  Draw out;
  sampler_.draw(case_.at, case_.wo, u, false, std::span(&out, 1));
  return out;
}

std::size_t Trio::randoms_used() const {
  if (!facts().generated) return facts().randoms;
  Random random(17);
  std::vector<double> u(1024 * facts().randoms);
  for (double& x : u) x = random.uniform();
  std::size_t most = 0;
  for (const Draw& draw : draw(u)) most = std::max(most, draw.used);
  return std::min(most, facts().randoms);
}

void for_draws(const Trio& trio, std::size_t count, std::uint64_t seed,
               const std::function<void(std::span<const double>, std::span<const Draw>)>& each) {
  Random random(seed);
  const std::size_t width = trio.facts().randoms;
  std::vector<double> u;
  for (std::size_t done = 0; done < count; done += kBlock) {
    const std::size_t rows = std::min(kBlock, count - done);
    // All of them, because loops of a generator may use more numbers than a trial run shows.
    u.resize(rows * width);
    for (double& x : u) x = random.uniform();
    const std::vector<Draw> draws = trio.draw(u);
    each(u, draws);
  }
}

Witness witness_of(const Subject& subject, const Trio& trio, std::string_view check,
                   const CheckOptions& options, const Vec3<double>* wi, std::span<const double> u) {
  Witness w;
  const SampledCase& at = trio.at();
  const std::vector<std::string>& names = at.at.channels;
  if (subject.of_form()) {
    const ReflectanceInfo& form = info(*subject.of_form());
    const Term& term = at.at.terms.front();
    for (std::size_t k = 0; k < form.weights.size(); ++k) {
      const bool one = std::ranges::find(trio.facts().colour_weights, k) == trio.facts().colour_weights.end();
      for (std::size_t c = 0; c < (one ? 1 : names.size()); ++c)
        w.parameters.emplace_back(
            std::string(form.weights[k].name) + (one || names.size() < 2 ? "" : "[" + names[c] + "]"),
            term.weights[c][k]);
    }
    for (std::size_t k = 0; k < form.shape.size(); ++k)
      w.parameters.emplace_back(form.shape[k].name, term.shape[0][k]);
  }
  w.angles = {{"theta_o", at.theta}, {"phi_o", at.phi}};
  if (wi) {
    const double rho = std::hypot(wi->x, wi->y);
    const double phi = in_degrees(std::atan2(wi->y, wi->x));
    w.angles.emplace_back("theta_i", in_degrees(std::atan2(rho, wi->z)));
    w.angles.emplace_back("phi_i", phi < 0 ? phi + 360 : phi);
  }
  for (std::size_t k = 0; k < u.size(); ++k) w.parameters.emplace_back("u" + std::to_string(k), u[k]);
  const OutsideFacts* facts = subject.outside_facts();
  const std::string words = facts ? facts->words : "--form " + io::shell_word(subject.name()) + " --samplers";
  if (!words.empty())
    w.command = "brdf validate " + words + " --require " + std::string(check) + " --seed " +
                std::to_string(options.seed) + (options.effort == Effort::full ? " --effort full" : "");
  return w;
}

}  // namespace brdf::validate
