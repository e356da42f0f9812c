#include "validate/data_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "brdf/scalar.h"
#include "io/text.h"
#include "validate/sample_pairs.h"

namespace brdf::validate {
namespace {

constexpr double kRadians = kPi / 180;
constexpr std::size_t kMostRowsForNeighbours = 60000;

std::string percent(double x) {
  return io::to_text(std::round(1000 * x) / 10) + " %";
}

std::string plural(std::size_t n, const std::string& word) {
  return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
}

// The first places of a list, for people.
std::string places(const io::SampleTable& t, const std::vector<std::size_t>& rows) {
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(rows.size(), 5); ++k)
    text += (k ? "; " : "") + t.where(rows[k]);
  return text + (rows.size() > 5 ? "; ..." : "");
}

Finding start(const io::SampleTable& t, const char* check) {
  Finding f{t.source, check};
  f.evaluations = 0;
  return f;
}

Finding not_applicable(const io::SampleTable& t, const char* check, std::string why) {
  Finding f = start(t, check);
  f.verdict = Verdict::not_applicable;
  f.statement = std::move(why);
  return f;
}

Finding counted(const io::SampleTable& t, const char* check, const std::vector<std::size_t>& rows,
                const std::string& clean, const std::string& fault) {
  Finding f = start(t, check);
  f.value = double(rows.size());
  f.verdict = rows.empty() ? Verdict::pass : Verdict::fail;
  f.statement = rows.empty() ? clean : plural(rows.size(), "row") + " " + fault + ": " + places(t, rows);
  return f;
}

Finding negative(const io::SampleTable& t) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < t.rows(); ++k)
    for (const auto& channel : t.values)
      if (channel[k] < 0) {
        rows.push_back(k);
        break;
      }
  return counted(t, "negative", rows, "no negative value", "with a negative value");
}

Finding missing(const io::SampleTable& t) {
  Finding f = start(t, "missing");
  f.value = double(t.skipped);
  f.statement =
      t.skipped == 0 ? "every row holds a value" : plural(t.skipped, "entry") + " without a value, left out";
  return f;
}

Finding duplicates(const io::SampleTable& t) {
  std::map<std::tuple<double, double, double, double>, std::size_t> seen;
  std::vector<std::size_t> copies;
  std::size_t repeated = 0;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    const auto [first, fresh] = seen.try_emplace({t.theta_i[k], t.phi_i[k], t.theta_o[k], t.phi_o[k]}, k);
    if (fresh) continue;
    const bool same = std::all_of(t.values.begin(), t.values.end(),
                                  [&](const auto& v) { return v[k] == v[first->second]; });
    if (same)
      copies.push_back(k);
    else
      ++repeated;
  }
  Finding f = counted(t, "duplicates", copies, "no row occurs twice",
                      "duplicated: directions and values of an earlier row");
  if (copies.empty() && repeated > 0)
    f.statement = plural(repeated, "direction") + " measured again, with other values";
  return f;
}

// At theta = 0 the azimuth means nothing: values that depend on it betray exchanged columns.
Finding directions(const io::SampleTable& t) {
  std::map<std::tuple<double, double, std::size_t>, std::pair<double, double>> ranges;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    if (t.theta_o[k] != 0) continue;
    for (std::size_t c = 0; c < t.channels.size(); ++c) {
      const double v = t.values[c][k];
      auto [at, fresh] = ranges.try_emplace({t.theta_i[k], t.phi_i[k], c}, v, v);
      at->second.first = std::min(at->second.first, v);
      at->second.second = std::max(at->second.second, v);
    }
  }
  if (ranges.empty()) return not_applicable(t, "directions", "no row along the normal (theta_o = 0)");
  std::vector<double> spread;
  for (const auto& [place, range] : ranges)
    if (range.second > 0) spread.push_back((range.second - range.first) / range.second);
  Finding f = start(t, "directions");
  f.value = spread.empty() ? 0 : median(spread);
  f.bound = 0.15;
  f.verdict = f.value > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = f.verdict == Verdict::pass
                    ? "along the normal the azimuth is without effect, as it must be"
                    : "along the normal (theta_o = 0) values change with phi_o by " + percent(f.value) +
                          ", though the direction is the same: are theta_o and phi_o exchanged?";
  return f;
}

struct Direction {
  double x, y, z;
};

Direction unit(double theta, double phi) {
  return {std::sin(theta * kRadians) * std::cos(phi * kRadians),
          std::sin(theta * kRadians) * std::sin(phi * kRadians), std::cos(theta * kRadians)};
}

double cosine(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Rows with the same light.
std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& t) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < t.rows(); ++k) groups[{t.theta_i[k], t.phi_i[k]}].push_back(k);
  return groups;
}

// A value is an outlier where it leaves its eight neighbours' median by more than a factor two and by much
// more than they differ among themselves: beside a highlight neighbours differ, and nothing is claimed.
Finding outliers(const io::SampleTable& t) {
  if (t.rows() > kMostRowsForNeighbours)
    return not_applicable(
        t, "outliers",
        "not sought in tables of more than " + std::to_string(kMostRowsForNeighbours) + " rows");
  std::set<std::size_t> found;
  for (const auto& [light, rows] : by_light(t)) {
    if (rows.size() < 12 || rows.size() > 4000) continue;
    std::vector<Direction> d;
    for (const std::size_t k : rows) d.push_back(unit(t.theta_o[k], t.phi_o[k]));
    std::vector<std::pair<double, std::size_t>> near(rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t n = 0; n < rows.size(); ++n) near[n] = {n == j ? 2 : -cosine(d[j], d[n]), n};
      std::nth_element(near.begin(), near.begin() + 8, near.end());
      for (const auto& values : t.values) {
        const double here = values[rows[j]];
        if (!(here > 0)) continue;
        std::vector<double> around;
        for (std::size_t n = 0; n < 8; ++n)
          if (const double v = values[rows[near[n].second]]; v > 0) around.push_back(std::log(v));
        if (around.size() < 6) continue;
        std::sort(around.begin(), around.end());
        const double spread = around[around.size() - 2] - around[1];  // without the two extremes
        if (std::abs(std::log(here) - median(around)) > std::log(2.0) + 3 * spread) found.insert(rows[j]);
      }
    }
  }
  return counted(t, "outliers", {found.begin(), found.end()}, "no value stands apart from its neighbours",
                 "far from all neighbours");
}

Finding exact_reciprocity(const io::SampleTable& t) {
  const auto pairs = exact_pairs(t);
  if (pairs.empty()) return not_applicable(t, "reciprocity", "no reciprocal pairs in this table");
  std::vector<double> differences;
  for (const ReciprocalPair& p : pairs) differences.push_back(relative_difference(p));
  Finding f = start(t, "reciprocity");
  f.value = median(differences);
  f.bound = 0.2;
  f.verdict = f.value > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = plural(pairs.size(), "reciprocal pair") + ", median difference " + percent(f.value);
  return f;
}

Finding noise_floor(const io::SampleTable& t, const std::vector<ReciprocalPair>& pairs) {
  if (pairs.size() < 8)
    return not_applicable(t, "noise_floor", "too few pairs of directions to interpolate between");
  std::vector<double> differences;
  for (const ReciprocalPair& p : pairs) differences.push_back(relative_difference(p));
  Finding f = start(t, "noise_floor");
  f.value = median(differences);
  f.bound = 0.2;
  f.verdict = f.value > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = "median difference " + percent(f.value) + " of " +
                plural(pairs.size(), "interpolated reciprocal pair") + ", below " +
                percent(quantile(differences, 0.9)) + " for nine of ten: no model can be judged more finely";
  return f;
}

// If the values were f_r times cos_i, then f(a,b)/f(b,a) = cos_a/cos_b.
Finding cosine_factor(const io::SampleTable& t, const std::vector<ReciprocalPair>& pairs) {
  std::vector<double> slopes;
  for (const ReciprocalPair& p : pairs) {
    const double lever = std::log(std::cos(p.theta_a * kRadians) / std::cos(p.theta_b * kRadians));
    if (std::abs(lever) > 0.3 && std::isfinite(lever))
      slopes.push_back(std::log(p.forward / p.backward) / lever);
  }
  if (slopes.size() < 8)
    return not_applicable(t, "cosine_factor", "too few reciprocal pairs of different angles");
  Finding f = start(t, "cosine_factor");
  f.value = median(slopes);
  f.bound = 0.5;
  f.verdict = std::abs(f.value) > f.bound ? Verdict::fail : Verdict::pass;
  f.statement = f.verdict == Verdict::pass
                    ? "values are f_r: exchanging light and viewer leaves no cosine behind"
                    : std::string("values behave as f_r times ") + (f.value > 0 ? "cos_i" : "cos_o") +
                          ": exchanging light and viewer leaves that cosine behind (declare `quantity`)";
  return f;
}

Finding isotropy(const io::SampleTable& t) {
  const std::set<double> turns(t.phi_i.begin(), t.phi_i.end());
  if (turns.size() < 2)
    return not_applicable(t, "isotropy", "the sample was not turned: all light has one azimuth");
  std::map<std::tuple<long, long, long>, std::vector<std::size_t>> same;
  const auto key = [](double degrees) { return std::lround(degrees * 1e3); };
  for (std::size_t k = 0; k < t.rows(); ++k)
    same[{key(t.theta_i[k]), key(t.theta_o[k]), key(std::remainder(t.phi_o[k] - t.phi_i[k], 360.0))}]
        .push_back(k);
  std::vector<double> differences;
  for (const auto& [place, rows] : same)
    for (std::size_t j = 1; j < rows.size(); ++j)
      for (const auto& v : t.values)
        if (v[rows[j]] > 0 && v[rows[0]] > 0)
          differences.push_back(2 * std::abs(v[rows[j]] - v[rows[0]]) / (v[rows[j]] + v[rows[0]]));
  if (differences.size() < 4)
    return not_applicable(t, "isotropy", "no direction was measured at two turns of the sample");
  Finding f = start(t, "isotropy");
  f.value = median(differences);
  f.bound = 0.1;
  f.statement = f.value > f.bound ? "anisotropic: a turn of the sample changes values by " +
                                        percent(f.value) + " in the median"
                                  : "isotropic within " + percent(f.value) + " in the median";
  return f;
}

// The reflected fraction for one direction of the light: the samples around each of many directions, weighted
// by the inverse square of their distance. Its bound: what no sample is near to, the difference to the
// nearest sample alone, and the noise floor.
MeasuredAlbedo integrate(const io::SampleTable& t, const std::vector<std::size_t>& rows, double noise) {
  constexpr int kRings = 20, kSectors = 36;
  constexpr double kReach = 8 * kRadians;
  struct Sample {
    Direction d;
    std::size_t row;
  };
  std::vector<Sample> samples;
  double azimuth_low = 360, azimuth_high = -360;
  for (const std::size_t k : rows) {
    const double phi = std::remainder(t.phi_o[k] - t.phi_i[k], 360.0);
    if (t.theta_o[k] > 0) {
      azimuth_low = std::min(azimuth_low, phi);
      azimuth_high = std::max(azimuth_high, phi);
    }
    samples.push_back({unit(t.theta_o[k], phi), k});
  }
  // Measured on one side of the plane of incidence only: the other side is its mirror image.
  if (azimuth_low >= 0 || azimuth_high <= 0) {
    const std::size_t n = samples.size();
    for (std::size_t j = 0; j < n; ++j)
      samples.push_back({{samples[j].d.x, -samples[j].d.y, samples[j].d.z}, samples[j].row});
  }
  const std::size_t channels = t.channels.size();
  MeasuredAlbedo m{t.theta_i[rows.front()], 0, std::vector<double>(channels), std::vector<double>(channels)};
  const double weight = kPi / (kRings * kSectors);
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const double s = std::sqrt((ring + 0.5) / kRings), phi = 2 * kPi * (sector + 0.5) / kSectors;
      const Direction d{s * std::cos(phi), s * std::sin(phi), std::sqrt(1 - s * s)};
      std::array<std::pair<double, std::size_t>, 4> near;
      near.fill({10, 0});
      for (const Sample& sample : samples) {
        const double distance = 2 - 2 * cosine(d, sample.d);
        if (distance >= near.back().first) continue;
        near.back() = {distance, sample.row};
        std::sort(near.begin(), near.end());
      }
      const bool covered = std::sqrt(std::max(near[0].first, 0.0)) < kReach;
      m.coverage += covered ? 1.0 / (kRings * kSectors) : 0;
      for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0, weights = 0;
        for (const auto& [distance, row] : near) {
          if (distance > 5) continue;
          const double w = 1 / (std::max(distance, 0.0) + 1e-6);
          sum += w * t.values[c][row];
          weights += w;
        }
        const double smooth = weights > 0 ? sum / weights : 0, nearest = t.values[c][near[0].second];
        m.value[c] += weight * smooth;
        m.bound[c] += weight * (covered ? 0.5 * std::abs(smooth - nearest) : std::abs(smooth));
      }
    }
  for (std::size_t c = 0; c < channels; ++c) m.bound[c] += 0.5 * noise * std::abs(m.value[c]);
  return m;
}

Finding coverage(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  double least = 1, sum = 0;
  for (const MeasuredAlbedo& a : albedo) {
    least = std::min(least, a.coverage);
    sum += a.coverage;
  }
  Finding f = start(t, "coverage");
  f.value = sum / double(albedo.size());
  f.bound = 1;
  f.statement =
      percent(f.value) +
      " of the projected hemisphere lies within 8 degrees of a sample (at the worst angle of the light " +
      percent(least) + ")";
  return f;
}

Finding energy(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  constexpr double kEnough = 0.6;
  const MeasuredAlbedo* worst = nullptr;
  std::size_t channel = 0;
  for (const MeasuredAlbedo& a : albedo)
    for (std::size_t c = 0; c < a.value.size(); ++c)
      if (a.coverage >= kEnough && (!worst || a.value[c] > worst->value[channel])) {
        worst = &a;
        channel = c;
      }
  if (!worst) return not_applicable(t, "energy", "too little of the hemisphere is covered for an integral");
  Finding f = start(t, "energy");
  f.value = worst->value[channel];
  f.bound = 1;
  f.verdict = f.value - worst->bound[channel] > 1 ? Verdict::fail : Verdict::pass;
  std::ostringstream text;
  text.precision(3);
  text << "reflects at most " << f.value << " +- " << worst->bound[channel] << " (light at " << worst->theta_i
       << " degrees, channel " << t.channels[channel] << ")";
  f.statement = text.str();
  return f;
}

std::vector<std::pair<std::string, std::string>> facts_of(const io::SampleTable& t) {
  const std::set<double> lights(t.theta_i.begin(), t.theta_i.end()), turns(t.phi_i.begin(), t.phi_i.end());
  std::vector<std::pair<std::string, std::string>> facts{{"rows", std::to_string(t.rows())}};
  std::string channels;
  for (const std::string& c : t.channels) channels += (channels.empty() ? "" : ", ") + c;
  facts.emplace_back("channels", channels);
  facts.emplace_back("angles of the light", std::to_string(lights.size()) + " from " +
                                                io::to_text(*lights.begin()) + " to " +
                                                io::to_text(*lights.rbegin()) + " degrees");
  facts.emplace_back("turns of the sample", std::to_string(turns.size()));
  facts.emplace_back("largest angle of the viewer",
                     io::to_text(*std::max_element(t.theta_o.begin(), t.theta_o.end())) + " degrees");
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const auto [low, high] = std::minmax_element(t.values[c].begin(), t.values[c].end());
    facts.emplace_back("f_r of " + t.channels[c], io::to_text(*low) + " to " + io::to_text(*high) + " /sr");
  }
  for (const char* key : {"sample", "instrument", "source", "licence"})
    if (const auto value = t.find_metadata(key)) facts.emplace_back(key, *value);
  return facts;
}

}  // namespace

DataSheet data_sheet(const io::SampleTable& t) {
  DataSheet sheet;
  if (t.rows() == 0) {
    sheet.findings.push_back(not_applicable(t, "missing", "the table has no rows"));
    sheet.findings.back().verdict = Verdict::fail;
    return sheet;
  }
  sheet.facts = facts_of(t);
  const auto pairs = interpolated_pairs(t);
  const Finding noise = noise_floor(t, pairs);
  // Integrals at up to 60 angles of the light: a large table has thousands.
  const auto groups = by_light(t);
  const std::size_t stride = (groups.size() + 59) / 60;
  std::size_t index = 0;
  for (const auto& [light, rows] : groups)
    if (index++ % stride == 0)
      sheet.albedo.push_back(
          integrate(t, rows, noise.verdict == Verdict::not_applicable ? 0.1 : noise.value));
  sheet.findings = {negative(t),
                    missing(t),
                    duplicates(t),
                    directions(t),
                    outliers(t),
                    exact_reciprocity(t),
                    noise,
                    cosine_factor(t, pairs),
                    isotropy(t),
                    coverage(t, sheet.albedo),
                    energy(t, sheet.albedo)};
  return sheet;
}

std::vector<std::string> data_sheet_names() {
  return {"negative",    "missing",       "duplicates", "directions", "outliers", "reciprocity",
          "noise_floor", "cosine_factor", "isotropy",   "coverage",   "energy"};
}

void add_to_report(io::HtmlReport& report, const io::SampleTable& t, const DataSheet& sheet) {
  std::vector<std::vector<io::Cell>> rows;
  for (const auto& [name, value] : sheet.facts) rows.push_back({{name}, {value}});
  report.table({"table", t.source}, rows);
  io::Plot plane;
  plane.title = "In the plane of incidence: " + t.source;
  plane.x_label = "polar angle of the viewer, degrees (mirror side positive)";
  plane.y_label = "f_r of " + t.channels.front() + ", 1/sr";
  plane.log_y = true;
  plane.caption = "The values as they were measured, one colour for each angle of the light.";
  plane.command = "grep -v '^#' " + t.source;
  for (const auto& [light, members] : by_light(t)) {
    io::Series s{"light at " + io::to_text(light.first), {}, {}, io::Series::Style::points};
    for (const std::size_t k : members) {
      const double phi = std::abs(std::remainder(t.phi_o[k] - light.second, 360.0));
      if (t.theta_o[k] != 0 && phi != 0 && phi != 180) continue;
      s.x.push_back(phi == 0 ? -t.theta_o[k] : t.theta_o[k]);
      s.y.push_back(t.values.front()[k]);
    }
    if (!s.x.empty() && plane.series.size() < 8) plane.series.push_back(std::move(s));
  }
  if (!plane.series.empty()) report.plot(plane);
  io::Plot albedo;
  albedo.title = "Reflected fraction by integrating the samples: " + t.source;
  albedo.x_label = "polar angle of the light, degrees";
  albedo.y_label = "albedo of " + t.channels.front();
  albedo.series = {{"value", {}, {}, io::Series::Style::line},
                   {"value + bound", {}, {}, io::Series::Style::dashed},
                   {"value - bound", {}, {}, io::Series::Style::dashed}};
  for (const MeasuredAlbedo& a : sheet.albedo) {
    if (a.coverage < 0.6) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      albedo.series[k].x.push_back(a.theta_i);
      albedo.series[k].y.push_back(a.value[0] + (k == 1 ? a.bound[0] : k == 2 ? -a.bound[0] : 0));
    }
  }
  albedo.caption =
      "The bound holds what no sample is near to, the coarseness of the sampling, and half the noise floor.";
  albedo.command = "brdf validate " + t.source + " --json";
  if (albedo.series[0].x.size() > 1) report.plot(albedo);
}

}  // namespace brdf::validate
