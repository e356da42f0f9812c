#include "interop/reading.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::interop {

namespace {

// Returns parameter k of three channels; black if there is no such parameter.
Colour colours_of(const std::vector<std::vector<double>>& sets, int k) {
  Colour out{};
  for (std::size_t c = 0; c < 3 && k >= 0; ++c) out[c] = sets[sets.size() == 1 ? 0 : c][std::size_t(k)];
  return out;
}

}  // namespace

Colour Reading::weight(Role role) const {
  return colours_of(part_.term.weights, form_.weight_index(role));
}

Colour Reading::shape_colours(Role role) const {
  return colours_of(part_.term.shape, form_.shape_index(role));
}

double Reading::metallic() const {
  for (std::size_t k = 0; k < form_.shape.size(); ++k)
    if (form_.shape[k].map == Map::metallic) return part_.term.shape[0][k];
  return 0;
}

double Reading::roughness() const {
  return std::sqrt(std::sqrt(alpha_x() * alpha_y()));
}

bool Reading::along_tangent() const {
  return std::abs(std::remainder(turn(), 180)) < 1e-9;
}

bool Reading::crosswise() const {
  return std::abs(std::abs(std::remainder(turn(), 180)) - 90) < 1e-9;
}

void Reading::refuse_turn() const {
  throw InputError("the tangent is the mesh's dp/du: orient dp/du at " + number(given_turn()) +
                   " degrees from the surface's x axis, counter-clockwise seen from outside, and export with "
                   "tangent_phi 0");
}

void Reading::check_widths(double least, double most_ratio, const std::string& control) const {
  if (std::min(alpha_x(), alpha_y()) < least)
    throw InputError("alpha " + number(std::min(alpha_x(), alpha_y())) + " is below " + number(least) +
                     ", below which the program shows a mirror");
  if (alpha_x() > most_ratio * alpha_y() * (1 + 1e-9))
    throw InputError("alpha_x/alpha_y " + io::short_number(alpha_x() / alpha_y()) + " is above " +
                     number(most_ratio) + ", the limit of " + control);
}

void Reading::check_wider_along(const std::string& program) const {
  if (alpha_x() < alpha_y())
    throw InputError("the wider axis is across the tangent, but " + program + " widens along the tangent");
}

double Reading::anisotropy_strength() const {
  return std::sqrt((alpha_x() - alpha_y()) / std::max(1 - alpha_y(), 1e-12));
}

Shares shares_of(const Written& w, const std::string& mix) {
  Shares out;
  double lobes = 0;
  for (std::size_t k = 0; k < w.parts.size(); ++k) {
    const Reading r(w.parts[k]);
    const Colour kd = r.weight(Role::diffuse), ks = r.weight(Role::specular);
    for (std::size_t c = 0; c < 3; ++c) out.diffuse[c] += kd[c];
    const double share = *std::ranges::max_element(ks);
    if (share == 0) continue;
    lobes += share;
    out.lobes.push_back({k, share, {ks[0] / share, ks[1] / share, ks[2] / share}});
  }
  const double most = *std::ranges::max_element(out.diffuse);
  if (lobes + most > 1 + 1e-9)
    throw InputError(mix + " permits a sum of weights of 1, not " + number(lobes + most));
  out.diffuse_share = lobes < 1 - 1e-12 ? 1 - lobes : 0;
  for (double& colour : out.diffuse)
    colour = out.diffuse_share > 0 ? std::min(colour / out.diffuse_share, 1.0) : 0;
  return out;
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

std::string xml_header(const std::vector<std::string>& header) {
  std::string text = comments(header, "");
  // "?>" would end the instruction. The header's commands hold this text in single quotes, and the shell
  // joins two adjacent quoted pieces.
  for (std::size_t at = 0; (at = text.find("?>", at)) != text.npos;) text.replace(at, 2, "?''>");
  return "<?brdf\n" + text + "?>\n";
}

}  // namespace brdf::interop
