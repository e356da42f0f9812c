#include "interop/reading.h"

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "io/numbers.h"

namespace brdf::interop {

Colour Reading::weight(Role role) const {
  Colour out{};
  const int k = form_.weight_index(role);
  if (k < 0) return out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = w_.term.weights[w_.term.weights.size() == 1 ? 0 : c][std::size_t(k)];
  return out;
}

Colour Reading::shape_colours(Role role) const {
  Colour out{};
  const int k = form_.shape_index(role);
  if (k < 0) return out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = w_.term.shape[w_.term.shape.size() == 1 ? 0 : c][std::size_t(k)];
  return out;
}

double Reading::metallic() const {
  for (std::size_t k = 0; k < form_.shape.size(); ++k)
    if (form_.shape[k].map == Map::metallic) return w_.term.shape[0][k];
  return 0;
}

double Reading::roughness() const {
  return std::sqrt(std::sqrt(alpha_x() * alpha_y()));
}

bool Reading::crosswise() const {
  return std::abs(std::abs(std::remainder(turn(), 180)) - 90) < 1e-9;
}

void Reading::check_widths(double least, double most_ratio, const std::string& control) const {
  if (std::min(alpha_x(), alpha_y()) < least)
    throw InputError("alpha " + number(std::min(alpha_x(), alpha_y())) + " is below " + number(least) +
                     ", where the program shows a mirror");
  if (alpha_x() > most_ratio * alpha_y() * (1 + 1e-9))
    throw InputError("alpha_x/alpha_y " + io::short_number(alpha_x() / alpha_y()) + " is above " +
                     number(most_ratio) + ", where " + control + " ends");
}

bool is_black(const Colour& c) {
  return c == Colour{};
}
bool is_grey(const Colour& c) {
  return c[0] == c[1] && c[1] == c[2];
}

std::string number(double x) {
  return io::short_number(x, 9);
}

std::string numbers(const Colour& c, const char* separator) {
  return number(c[0]) + separator + number(c[1]) + separator + number(c[2]);
}

std::string comments(const std::vector<std::string>& header, const std::string& prefix) {
  std::string text;
  for (const std::string& line : header) text += prefix + line + "\n";
  return text;
}

std::string xml_comment(const std::vector<std::string>& header) {
  std::string text = comments(header, "");
  for (std::size_t at = 0; (at = text.find("--", at)) != text.npos;) text.replace(at, 2, "- -");
  return "<!--\n" + text + "-->\n";
}

}  // namespace brdf::interop
