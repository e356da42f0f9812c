#include "validate/joint/density_cause.h"

#include <Eigen/QR>
#include <array>
#include <functional>
#include <optional>

#include "io/files/numbers.h"

namespace brdf::validate {
namespace {

using Vector = Vec3<double>;
using Rows = std::span<const DensityRow>;

constexpr double kNear = 2e-4, kMost = 0.95;
constexpr std::size_t kFewest = 6;  // rows that a cause needs

// Returns whether nearly all rows have this property.
bool nearly_all(Rows rows, const std::function<bool(const DensityRow&)>& holds) {
  return double(std::ranges::count_if(rows, holds)) >= kMost * double(rows.size());
}

// The factor that turns the claimed density of a wrong measure into the right one, at one direction.
struct Factor {
  const char* cause;
  double (*of)(const Vector& wi, const Vector& wo);
};

double half_cosine(const Vector& wi, const Vector& wo, bool with_normal) {
  const Vector sum{wi.x + wo.x, wi.y + wo.y, wi.z + wo.z};
  return with_normal ? sum.z / std::sqrt(dot(sum, sum)) : dot(sum, wo) / std::sqrt(dot(sum, sum));
}

constexpr Factor kFactors[] = {
    {"is that of the half vector: the factor 1 / (4 dot(V, H)) is missing",
     [](const Vector& i, const Vector& o) { return 1 / (4 * half_cosine(i, o, false)); }},
    {"has the factor 1 / (4 dot(V, H)) once too often",
     [](const Vector& i, const Vector& o) { return 4 * half_cosine(i, o, false); }},
    {"is per projected solid angle: the factor cos_i is missing",
     [](const Vector& i, const Vector&) { return i.z; }},
    {"has the factor cos_i once too often", [](const Vector& i, const Vector&) { return 1 / i.z; }},
    {"lacks the cosine of the half vector, dot(N, H)",
     [](const Vector& i, const Vector& o) { return half_cosine(i, o, true); }},
    {"has the cosine of the half vector, dot(N, H), once too often",
     [](const Vector& i, const Vector& o) { return 1 / half_cosine(i, o, true); }},
    {"has the factor 1 / (4 cos_o) in the place of 1 / (4 dot(V, H))",
     [](const Vector& i, const Vector& o) { return o.z / half_cosine(i, o, false); }},
};

// Returns the constant by which these values have to be multiplied to be the true densities of nearly all
// rows; empty if there is no such constant.
std::optional<double> constant_ratio(Rows rows, const std::function<double(const DensityRow&)>& value) {
  std::vector<double> ratios;
  for (const DensityRow& row : rows) ratios.push_back(row.truth / value(row));
  std::ranges::nth_element(ratios, ratios.begin() + long(ratios.size() / 2));
  const double factor = ratios[ratios.size() / 2];
  const auto near = std::ranges::count_if(ratios, [&](double r) { return agree(r, factor, kNear); });
  if (double(near) < kMost * double(ratios.size()) || !std::isfinite(factor) || factor <= 0) return {};
  return factor;
}

bool is_truth(Rows rows, const std::function<double(const DensityRow&)>& value) {
  return nearly_all(rows, [&](const DensityRow& row) { return agree(row.truth, value(row), kNear); });
}

std::string of_a_measure(const Trio& trio, Rows rows) {
  const auto claimed_is = [&](auto&& value) {
    return nearly_all(rows, [&](const DensityRow& r) { return agree(r.claimed, value(r.wi), kNear); });
  };
  if (claimed_is([](const Vector&) { return 1 / (2 * kPi); }))
    return "is the uniform density 1 / (2 pi), which the samples do not have";
  if (claimed_is([](const Vector& w) { return w.z / kPi; }))
    return "is the cosine density cos_i / pi, which the samples do not have";
  if (const auto factor = constant_ratio(rows, [](const DensityRow& r) { return r.claimed; }))
    return "has a wrong constant factor: the true density is " + io::short_number(*factor, 5) +
           " times this one";
  for (const Factor& f : kFactors) {
    const auto factor =
        constant_ratio(rows, [&](const DensityRow& r) { return r.claimed * f.of(r.wi, trio.at().wo); });
    if (!factor) continue;
    const std::string cause = f.cause;
    if (agree(*factor, 1, kNear)) return cause;
    // A power of dot(N, H) whose exponent is off by 1 has another norm as well.
    const bool power = cause.find("dot(N, H)") != std::string::npos;
    return cause + ", and the constant factor " + io::short_number(*factor, 5) + " as well" +
           (power ? ": an exponent that differs by 1 has this effect" : "");
  }
  return "";
}

// How often the claimed density counts the two groups of lobes between which one random number chooses:
// below and above a border.
struct Counts {
  std::size_t number;
  double least, most;  // the border lies between these values
  double below, above;
  std::ptrdiff_t explained;  // rows
};

// Solves for the counts by least squares. A row for which one lobe was not found is an outlier: repeated
// solutions leave out the rows that fit worst.
std::optional<Counts> counts_with(Rows rows, std::size_t number, double least, double most) {
  constexpr double kExplained = 0.7;  // of the rows; each fits to kNear, which no row does by chance
  constexpr int kTrims = 4;
  std::vector<Eigen::RowVector2d> parts(rows.size(), Eigen::RowVector2d::Zero());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const DensityPart& part : rows[k].parts)
      parts[k][part.u[number] > least] += part.density / rows[k].claimed;
  Eigen::Vector2d times;
  const auto error = [&](const Eigen::RowVector2d& row) { return std::abs(row.dot(times) - 1); };
  std::size_t kept = parts.size();
  for (int trim = 0; trim < kTrims; ++trim) {
    Eigen::MatrixX2d equations(Eigen::Index(kept), 2);
    for (std::size_t k = 0; k < kept; ++k) equations.row(Eigen::Index(k)) = parts[k];
    const Eigen::ColPivHouseholderQR<Eigen::MatrixX2d> qr(equations);
    if (std::abs(qr.matrixQR()(1, 1)) < 1e-3 * qr.maxPivot()) return {};
    times = qr.solve(Eigen::VectorXd::Ones(equations.rows()));
    std::ranges::sort(parts, {}, error);
    const auto explained = std::ranges::count_if(parts, [&](const auto& row) { return error(row) < kNear; });
    if (double(explained) >= kExplained * double(parts.size()) && times.minCoeff() > 0)
      return Counts{number, least, most, times[0], times[1], explained};
    kept = std::max(kFewest, std::size_t(kExplained * double(parts.size())));
  }
  return {};
}

// Returns how a mixture of two lobes is counted, if constant counts explain the claimed density. The border
// of the choice is searched among the random numbers of the rows.
std::optional<Counts> counts_of(Rows rows) {
  std::optional<Counts> best;
  const std::size_t numbers = rows[0].u.size();
  for (std::size_t number = 0; number < numbers; ++number) {
    std::vector<double> seen;
    for (const DensityRow& row : rows)
      for (const DensityPart& part : row.parts) seen.push_back(part.u[number]);
    std::ranges::sort(seen);
    for (std::size_t k = 0; k + 1 < seen.size(); ++k)
      if (seen[k + 1] - seen[k] > 1e-9)
        if (const auto counts = counts_with(rows, number, seen[k], seen[k + 1]);
            counts && (!best || counts->explained > best->explained))
          best = counts;
  }
  return best;
}

// Returns the value of the number at which the sampler changes from one lobe to the other: the place between
// the two values at which the direction jumps. Empty if it does not jump.
std::optional<double> border_of(const Trio& trio, const DensityRow& row, const Counts& counts) {
  const auto direction_at = [&](double x) {
    std::vector<double> u = row.u;
    u[counts.number] = x;
    return trio.draw_one(u).wi;
  };
  const auto distance = [](const Vector& a, const Vector& b) {
    const Vector d{a.x - b.x, a.y - b.y, a.z - b.z};
    return dot(d, d);
  };
  double low = counts.least, high = counts.most;
  Vector before = direction_at(low), after = direction_at(high);
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    const Vector at = direction_at(middle);
    if (distance(before, at) > distance(at, after))
      high = middle, after = at;
    else
      low = middle, before = at;
  }
  if (distance(before, after) < 1e-6) return {};
  return (low + high) / 2;
}

std::string of_a_mixture(const Trio& trio, Rows rows) {
  if (std::ranges::any_of(rows, [](const DensityRow& row) { return row.parts.empty(); })) return "";
  const std::optional<Counts> counts = counts_of(rows);
  if (!counts) return "";
  const std::string probabilities = "the probabilities with which the lobes are chosen";
  const std::optional<double> border = border_of(trio, rows[0], *counts);
  if (!border)
    return "counts one lobe " + io::short_number(counts->below, 4) + " times and another " +
           io::short_number(counts->above, 4) + " times: it has not " + probabilities;
  const double first = *border, second = 1 - first;
  const double used[] = {counts->below * first, counts->above * second};
  const auto pair = [](double x, double y) {
    return io::short_number(x, 4) + " and " + io::short_number(y, 4);
  };
  const std::string text = "weights the lobes with " + pair(used[0], used[1]) + " instead of " +
                           pair(first, second) + ", " + probabilities;
  const bool one[] = {agree(used[0], 1, kNear), agree(used[1], 1, kNear)};
  if (agree(used[0], second, kNear) && agree(used[1], first, kNear)) return text + ": they are exchanged";
  if (one[0] && one[1]) return text + ": both factors are missing";
  if (one[0] || one[1]) return text + ": a factor is missing";
  return text;
}

// Returns the density for other parameters, at each row.
bool fits_with(const Trio& trio, Rows rows, const std::function<double(double)>& changed, std::size_t shape) {
  SampledCase other = trio.at();
  for (std::vector<double>& values : other.at.terms[0].shape) values[shape] = changed(values[shape]);
  const Trio with = trio.with(other);
  return is_truth(rows, [&](const DensityRow& row) { return with.density_of(row.wi, other.wo); });
}

std::string of_a_width(const Trio& trio, Rows rows) {
  const Term& term = trio.at().at.terms[0];
  const auto& shape = info(term.form).shape;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const std::string name(shape[k].name);
    // The sampler squares the parameter and the density does not, or the reverse.
    if (fits_with(
            trio, rows, [](double x) { return x * x; }, k))
      return "fits the samples with the square of " + name + ": the sampler squares it once more";
    if (fits_with(
            trio, rows, [](double x) { return std::sqrt(x); }, k))
      return "fits the samples with the root of " + name + ": the density squares it once more";
  }
  return "";
}

struct Frame {
  const char* axes;
  Vector (*of)(const Vector&);
};

constexpr Frame kFrames[] = {
    {"with the normal along Y: Y and Z are exchanged",
     [](const Vector& w) {
       return Vector{w.x, w.z, w.y};
     }},
    {"with the normal along X: X and Z are exchanged",
     [](const Vector& w) {
       return Vector{w.z, w.y, w.x};
     }},
    {"that is turned: X, Y, Z are Y, Z, X",
     [](const Vector& w) {
       return Vector{w.y, w.z, w.x};
     }},
};

// Returns whether the density in the other frame is the true one. Functions return 0 if Z of a direction is
// negative. Therefore only directions with a positive Z in both frames are compared.
bool fits_in_frame(const Trio& trio, Rows rows, const std::function<Vector(const Vector&)>& seen,
                   const Vector& wo) {
  std::vector<DensityRow> compared;
  for (const DensityRow& row : rows)
    if (seen(row.wi).z > 0.01) compared.push_back(row);
  return wo.z > 0.01 && compared.size() >= kFewest &&
         is_truth(compared, [&](const DensityRow& r) { return trio.density_of(seen(r.wi), wo); });
}

// Returns the frame's axes after a turn about the normal, which changes no isotropic lobe, and brings a
// viewer of any azimuth above the horizon of the other frame.
std::function<Vector(const Vector&)> turned(const Frame& frame, double turn) {
  return [&frame, c = std::cos(turn), s = std::sin(turn)](const Vector& w) {
    return frame.of({w.x * c - w.y * s, w.x * s + w.y * c, w.z});
  };
}

std::string of_a_frame(const Trio& trio, Rows rows) {
  const Vector wo = trio.at().wo;
  const auto exchanged = [](const Vector& w) { return Vector{w.y, w.x, w.z}; };
  if (is_truth(rows, [&](const DensityRow& r) { return trio.density_of(exchanged(r.wi), exchanged(wo)); }))
    return "belongs to exchanged axes: X and Y, or the widths along them, are exchanged";
  for (const Frame& frame : kFrames) {
    for (const double turn : {0.0, kPi / 4, kPi / 2})
      if (const auto seen = turned(frame, turn); fits_in_frame(trio, rows, seen, seen(wo)))
        return std::string("belongs to a frame ") + frame.axes;
    // The sampler takes the viewer in one frame and returns the direction in another.
    if (fits_in_frame(trio, rows, frame.of, wo))
      return std::string("fits if the sampled direction is in a frame ") + frame.axes;
  }
  if (is_truth(rows, [&](const DensityRow& r) { return trio.density_of(wo, r.wi); }))
    return "belongs to exchanged directions: light and viewer are exchanged";
  return "";
}

}  // namespace

std::string cause_of(const Trio& trio, Rows rows) {
  if (rows.size() < kFewest) return "";
  if (const std::string cause = of_a_measure(trio, rows); !cause.empty()) return cause;
  if (trio.facts().has_density) {
    if (const std::string cause = of_a_frame(trio, rows); !cause.empty()) return cause;
    if (const std::string cause = of_a_width(trio, rows); !cause.empty()) return cause;
  }
  return of_a_mixture(trio, rows);
}

}  // namespace brdf::validate
