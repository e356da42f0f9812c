#include <algorithm>
#include <cmath>

#include "brdf/angle.h"
#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/text.h"
#include "io/formats/speos.h"
#include "io/samples/degrees.h"
#include "io/samples/fill_values.h"

namespace brdf::io::speos {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kMostAngles = 100000;

// Returns the place behind `characters` characters, or npos.
std::size_t behind(std::string_view text, std::size_t at, std::size_t characters, bool is_crlf_one) {
  for (; characters > 0 && at < text.size(); --characters) {
    if (is_crlf_one && text.substr(at).starts_with("\r\n")) ++at;
    for (++at; at < text.size() && (text[at] & 0xc0) == 0x80;) ++at;
  }
  return characters == 0 ? at : text.npos;
}

// The antiderivatives of (x - a) w(x) for the weights sin x cos x and sin x, at x in radians.
double weighted(double x, double a, bool is_intensity) {
  if (is_intensity) return (a - x) * std::cos(x) + std::sin(x);
  return (a - x) * std::cos(2 * x) / 4 + std::sin(2 * x) / 8;
}
double weight(double x, bool is_intensity) {
  return is_intensity ? -std::cos(x) : -std::cos(2 * x) / 4;
}

void require_ascending(const Cursor& cursor, const std::vector<double>& angles, const char* name,
                       double largest) {
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (!(std::abs(angles[k]) <= largest) || (k > 0 && !(angles[k] > angles[k - 1])))
      cursor.fail(std::string(name) + " " + to_text(angles[k]) + ": must ascend and not exceed " +
                  to_text(largest) + " degrees");
}

}  // namespace

void Cursor::fail(const std::string& what) const {
  throw InputError(content_->name + ", line " +
                   std::to_string(line_of(content_->bytes, std::min(at_, text().size()))) + ": " + what);
}

std::string_view Cursor::line() {
  const std::size_t end = std::min(text().find('\n', at_), text().size());
  std::string_view found = text().substr(at_, end - at_);
  at_ = std::min(end + 1, text().size());
  if (found.ends_with('\r')) found.remove_suffix(1);
  return trimmed(found);
}

std::string_view Cursor::word() {
  at_ = std::min(text().find_first_not_of(kBlanks, at_), text().size());
  const std::size_t end = std::min(text().find_first_of(kBlanks, at_), text().size());
  const std::string_view found = text().substr(at_, end - at_);
  at_ = end;
  return found;
}

double Cursor::number(const std::string& name) {
  const std::string_view found = word();
  double value;
  if (found.empty()) fail("the text ends early, " + name + " expected");
  if (!parse_number(found, value) || !std::isfinite(value))
    fail(shown(found) + " is not a finite number (" + name + " expected)");
  return value;
}

std::size_t Cursor::count(const std::string& name, std::size_t least, std::size_t most) {
  const double value = number(name);
  if (!(value >= double(least) && value <= double(most)) || value != std::floor(value))
    fail(to_text(value) + " is not a whole number from " + std::to_string(least) + " to " +
         std::to_string(most) + " (" + name + " expected)");
  return static_cast<std::size_t>(value);
}

std::vector<double> Cursor::numbers(const std::string& name, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) values.push_back(number(name));
  return values;
}

bool Cursor::skip_description(std::size_t characters) {
  for (const bool is_crlf_one : {true, false}) {
    const std::size_t end = behind(text(), at_, characters, is_crlf_one);
    if (end == text().npos) continue;
    const std::size_t next = text().find_first_not_of(" \t\r", end);
    if (next != text().npos && text()[next] != '\n') continue;
    at_ = std::min(next, text().size() - 1) + 1;
    return true;
  }
  return false;
}

void Cursor::end_line() {
  const std::string_view rest = line();
  if (!rest.empty()) fail(shown(rest) + " follows at the end of the line");
}

double Block::reflectance(bool is_intensity) const {
  // The mean over the azimuths for each polar angle.
  std::vector<double> widths(phi.size(), 360);
  const double span = phi.back() - phi.front();
  if (phi.size() > 1) {
    const bool is_half = std::abs(span - 180) < 1e-9;
    const double gap = is_half || span >= 360 - 1e-9 ? 0 : 360 - span;
    for (std::size_t p = 0; p < phi.size(); ++p) {
      const double before = p > 0 ? phi[p] - phi[p - 1] : gap;
      const double after = p + 1 < phi.size() ? phi[p + 1] - phi[p] : gap;
      widths[p] = (before + after) / 2 * (is_half ? 2 : 1);
    }
  }
  std::vector<double> rings;
  for (std::size_t t = 0; t < theta.size(); ++t) {
    double ring = 0;
    for (std::size_t p = 0; p < phi.size(); ++p) ring += at(t, p) * degrees(widths[p]).radians();
    rings.push_back(ring);
  }
  double sum = 0;
  for (std::size_t t = 0; t + 1 < theta.size(); ++t) {
    const double a = degrees(theta[t]).radians(), b = degrees(std::min(theta[t + 1], 90.0)).radians();
    if (theta[t] >= 90) break;
    const double slope = (rings[t + 1] - rings[t]) / degrees(theta[t + 1] - theta[t]).radians();
    sum += rings[t] * (weight(b, is_intensity) - weight(a, is_intensity)) +
           slope * (weighted(b, a, is_intensity) - weighted(a, a, is_intensity));
  }
  return sum;
}

Block read_block(Cursor& cursor) {
  Block block;
  const std::size_t thetas = cursor.count("the number of polar angles", 1, kMostAngles);
  const std::size_t phis = cursor.count("the number of azimuths", 1, kMostAngles);
  block.phi = cursor.numbers("an azimuth", phis);
  require_ascending(cursor, block.phi, "azimuth", kLargestAzimuth / 4);
  for (std::size_t t = 0; t < thetas; ++t) {
    block.theta.push_back(cursor.number("a polar angle"));
    for (std::size_t p = 0; p < phis; ++p) {
      block.values.push_back(cursor.number("a value"));
      if (is_fill_value(block.values.back()))
        cursor.fail(to_text(block.values.back()) +
                    " usually means 'not measured', for which the format has 0: write 0");
    }
  }
  require_ascending(cursor, block.theta, "polar angle", 180);
  return block;
}

}  // namespace brdf::io::speos
