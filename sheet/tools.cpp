#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {

std::string places(const View& view, std::span<const Row> rows) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> named;
  for (const Row k : rows) {
    std::string place = view.where(k);
    if (!named.empty() && named.back() == place) continue;
    if (named.size() == kMost) return io::joined(named, "; ") + "; ...";
    named.push_back(std::move(place));
  }
  return io::joined(named, "; ");
}

NamedRow named_row(const View& view, Row k) {
  const io::SampleTable& t = view.table();
  NamedRow row;
  row.row = view.origin(k);
  if (k < t.lines.size()) row.line = t.lines[k];
  row.theta_i = t.theta_i[k];
  row.phi_i = t.phi_i[k];
  row.theta_o = t.theta_o[k];
  row.phi_o = t.phi_o[k];
  return row;
}

NamedRow named_row(const View& view, Row k, std::size_t c) {
  NamedRow row = named_row(view, k);
  row.channel = view.table().channels[c];
  row.value = row.expected = view.table().values[c][k];
  return row;
}

Finding start(const io::SampleTable& t, std::string_view check) {
  Finding f{t.source, std::string(check)};
  f.evaluations = 0;
  return f;
}

Finding undecided(const io::SampleTable& t, std::string_view check, std::string why) {
  Finding f = start(t, check);
  f.outcome = Outcome::undecided;
  f.statement = std::move(why);
  return f;
}

Finding counted(const View& view, std::string_view check, const std::vector<Row>& rows,
                const std::string& clean, const std::string& fault) {
  Finding f = start(view.table(), check);
  f.value = double(rows.size());
  for (const Row k : rows) f.rows.push_back(named_row(view, k));
  f.conclude(rows.empty(), clean, plural(rows.size(), "row") + " " + fault + ": " + places(view, rows));
  return f;
}

std::vector<bool> within(const io::SampleTable& t, double max_theta) {
  std::vector<bool> inside(t.rows());
  for (std::size_t k = 0; k < t.rows(); ++k) inside[k] = !t.is_beyond(k, max_theta);
  return inside;
}

double resolution(const std::vector<double>& values) {
  constexpr std::size_t kLooked = 2000;
  const std::size_t stride = values.size() / kLooked + 1;
  int digits = 0;
  for (std::size_t k = 0; k < values.size(); k += stride) {
    const double x = std::abs(values[k]);
    for (; digits <= 12; ++digits) {
      const double scaled = x * std::pow(10.0, digits);
      if (std::abs(scaled - std::round(scaled)) <= 1e-9 * std::max(scaled, 1.0)) break;
    }
    if (digits > 12) return 0;
  }
  return std::pow(10.0, -digits);
}

bool has_light(const io::SampleTable& t) {
  return std::ranges::any_of(t.values, [](const auto& values) {
    return std::ranges::any_of(values, [](double x) { return x > 0; });
  });
}

bool is_constant(const io::SampleTable& t) {
  return std::ranges::all_of(t.values, [](const auto& values) {
    return std::ranges::all_of(values, [&](double x) { return x == values.front(); });
  });
}

bool is_of_cells(const io::SampleTable& t) {
  return t.format == "merl";
}

}  // namespace brdf::sheet
