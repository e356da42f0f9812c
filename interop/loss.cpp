#include "interop/loss.h"

#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "interop/pairs.h"
#include "io/files/numbers.h"

namespace brdf::interop {
namespace {

constexpr double kThetas[] = {0, 30, 60, 75};  // degrees, for the albedos

// Tolerances for the errors that integrals and searches leave.
bool no_more(double a, double b) {
  return a <= b * (1 + 1e-3) + 1e-9;
}
constexpr double kAlbedoOpen = 2e-5;

std::vector<std::vector<double>> albedos_of(const Material& m, const AlbedoOptions& options) {
  std::vector<std::vector<double>> out;
  for (const double theta : kThetas) {
    std::vector<double>& row = out.emplace_back();
    for (const AlbedoResult& a : directional_albedo(m, degrees(theta), {}, options)) row.push_back(a.value);
  }
  return out;
}

}  // namespace

double relative_difference(double wanted, double carried) {
  const double difference = std::abs(carried - wanted) / (std::abs(wanted) + kDark);
  return std::isfinite(difference) ? difference : HUGE_VAL;
}

std::vector<std::vector<double>> values_at(const Material& material, const Directions<double>& d) {
  std::vector<std::vector<double>> out(material.channels.size(), std::vector<double>(d.count, 0.0));
  std::vector<double> one(d.count);
  for (std::size_t c = 0; c < out.size(); ++c)
    for (const Term& term : material.terms) {
      eval_batch(term, c, d, one.data());
      for (std::size_t k = 0; k < d.count; ++k) out[c][k] += one[k];
    }
  return out;
}

Figures figures_of(const std::vector<std::vector<double>>& wanted,
                   const std::vector<std::vector<double>>& carried, const Directions<double>& d) {
  std::vector<double> differences;
  differences.reserve(wanted.size() * d.count);
  double sum = 0;
  for (std::size_t c = 0; c < wanted.size(); ++c)
    for (std::size_t k = 0; k < d.count; ++k) {
      const double f = wanted[c][k], g = carried[c][k];
      const double residual = std::log1p(g * d.wi_z[k]) - std::log1p(f * d.wi_z[k]);
      sum += residual * residual;
      differences.push_back(relative_difference(f, g));
    }
  const double largest = *std::ranges::max_element(differences);
  return {std::sqrt(sum / double(differences.size())), io::median(differences), largest};
}

Comparison::Comparison(Material wanted, const AlbedoOptions& albedos)
    : wanted_(std::move(wanted)),
      albedo_options_(albedos),
      pairs_(io::unit_directions(pairs_about(wanted_, Pairs::judged))),
      net_(io::unit_directions(net_about(wanted_))),
      at_pairs_(values_at(wanted_, pairs_.view())),
      at_net_(values_at(wanted_, net_.view())),
      albedos_(albedos_of(wanted_, albedos)) {}

void Comparison::add_pairs(const Material& carried, Loss& loss) const {
  const Figures f = figures_of(at_pairs_, values_at(carried, pairs_.view()), pairs_.view());
  loss.rms = f.rms;
  loss.median = f.median;
}

void Comparison::add_albedos(const Material& carried, Loss& loss) const {
  const auto other = albedos_of(carried, albedo_options_);
  for (std::size_t k = 0; k < std::size(kThetas); ++k)
    for (std::size_t c = 0; c < albedos_[k].size(); ++c) {
      const double difference = std::abs(albedos_[k][c] - other[k][c]);
      if (difference <= loss.albedo) continue;
      loss.albedo = difference;
      loss.albedo_theta = kThetas[k];
    }
}

Loss Comparison::loss_of(const Material& carried) const {
  Loss loss;
  add_pairs(carried, loss);
  loss.largest = largest_of(carried);
  loss.pairs = net_.view().count;
  if (loss.none_found()) loss.beyond = largest_beyond(carried);
  add_albedos(carried, loss);
  return loss;
}

std::optional<Loss> Comparison::better_loss_of(const Material& carried, const Loss& best,
                                               const Loss& copy) const {
  Loss loss;
  add_pairs(carried, loss);
  if (!(loss.rms < best.rms) || !no_more(loss.median, copy.median)) return std::nullopt;
  loss.largest = largest_of(carried);
  loss.pairs = net_.view().count;
  if (loss.none_found()) loss.beyond = largest_beyond(carried);
  if (!no_more(loss.largest.difference, copy.largest.difference)) return std::nullopt;
  add_albedos(carried, loss);
  if (!is_better(loss, copy)) return std::nullopt;
  return loss;
}

bool is_nearer(const Loss& one, const Loss& other) {
  constexpr double kSeen = 0.02;
  return one.rms < other.rms && one.median <= std::max(2 * other.median, kSeen);
}

bool is_better(const Loss& one, const Loss& other) {
  return one.rms < other.rms && no_more(one.median, other.median) &&
         no_more(one.largest.difference, other.largest.difference) &&
         one.albedo <= other.albedo + kAlbedoOpen;
}

namespace {

std::string place_of(const Largest& l) {
  const auto number = [](double x) { return io::short_number(x, 4); };
  return "theta_i " + number(l.theta_i) + ", theta_o " + number(l.theta_o) + ", phi " + number(l.phi()) +
         ", " + l.channel;
}

}  // namespace

std::string none_found_in_words(const Loss& loss) {
  const std::string found = "no difference above 1e-9 at " + io::plural(loss.pairs, "pair") +
                            " of directions up to 80 degrees from the normal";
  if (!loss.beyond) return found;
  if (loss.beyond->difference < Loss::kNone) return found + ", nor at some up to 89.99 degrees";
  return found + "; beyond, at least " + io::percent(loss.beyond->difference) + " (" +
         place_of(*loss.beyond) + ")";
}

std::string in_words(const Loss& loss) {
  const auto number = [](double x) { return io::short_number(x, 3); };
  const Largest& l = loss.largest;
  return "largest at least " + io::percent(l.difference) + " (theta_i " + number(l.theta_i) + ", theta_o " +
         number(l.theta_o) + ", phi " + number(l.phi()) + ", " + l.channel + "), median " +
         io::percent(loss.median) + ", albedo within " + number(loss.albedo) + " (at " +
         number(loss.albedo_theta) + "), rms " + number(loss.rms);
}

io::Json to_json(const Loss& loss) {
  const Largest& l = loss.largest;
  io::Json json{{"rms", loss.rms},
                {"median", loss.median},
                {"largest", l.difference},
                {"largest_is", "at least"},
                {"theta_i", l.theta_i},
                {"phi_i", l.phi_i},
                {"theta_o", l.theta_o},
                {"phi_o", l.phi_o},
                {"phi", l.phi()},
                {"channel", l.channel},
                {"wanted", l.wanted},
                {"carried", l.carried},
                {"albedo_difference", loss.albedo},
                {"albedo_theta", loss.albedo_theta}};
  if (loss.beyond) json["largest_beyond_80_degrees"] = loss.beyond->difference;
  return json;
}

}  // namespace brdf::interop
