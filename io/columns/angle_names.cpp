#include "io/columns/angle_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "io/columns/units.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using AngleKind = AngleName::Quantity;
using AngleNames = std::map<std::string, AngleName>;

constexpr std::array kLightWords{"i",      "in",    "inc",          "incident", "incidence", "incoming",
                                 "l",      "light", "illumination", "illum",    "sun",       "solar",
                                 "source", "src",   "lamp",         "laser",    "beam"};
constexpr std::array kViewer{"o",          "out",        "outgoing", "r",           "refl",     "reflected",
                             "reflection", "v",          "view",     "viewer",      "viewing",  "det",
                             "detector",   "receiver",   "observer", "observation", "e",        "exit",
                             "exitant",    "emergence",  "emergent", "emission",    "emitted",  "scatter",
                             "scattered",  "scattering", "measure",  "measurement", "measured", "detection",
                             "sensor",     "camera"};

// Adds the names of a word and a side in either order, with or without "angle".
void add_word(const char* word, AngleKind quantity, AngleNames& all) {
  const auto add = [&](const std::string& side, AngleSide whose) {
    const AngleName said{quantity, whose};
    const std::string name(word);
    all[name + side] = all[side + name] = all[side + name + "angle"] = all[name + "angle" + side] =
        all[name + "angleof" + side] = said;
  };
  for (const char* side : kLightWords) add(side, AngleSide::light);
  for (const char* side : kViewer) add(side, AngleSide::viewer);
  add("s", AngleSide::scatter_or_source);
}

// Adds "incident angle" and "angle of incidence", which are polar angles.
void add_sides(AngleNames& all) {
  const auto add = [&](const std::string& side, AngleSide whose) {
    if (side.size() == 1) all["angle" + side] = {AngleKind::polar, whose};
    if (side.size() == 1) return;
    all[side + "angle"] = all["angle" + side] = all["angleof" + side] = {AngleKind::polar, whose};
    all.try_emplace(side, AngleName{AngleKind::polar, whose, true});
  };
  for (const char* side : kLightWords) add(side, AngleSide::light);
  for (const char* side : kViewer) add(side, AngleSide::viewer);
}

AngleNames all_names() {
  AngleNames all;
  for (const char* word : {"theta", "polar", "zenith", "th"}) add_word(word, AngleKind::polar, all);
  for (const char* word : {"elevation", "altitude"}) add_word(word, AngleKind::elevation, all);
  for (const char* word : {"phi", "azimuth", "azim", "az"}) add_word(word, AngleKind::azimuth, all);
  // "ref" alone may be a reference, but not next to the word of an angle.
  for (const char* name : {"thetaref", "polarref", "zenithref", "refzenith"})
    all[name] = {AngleKind::polar, AngleSide::viewer};
  for (const char* name : {"phiref", "azimuthref", "refazimuth", "azimutausfall", "ausfallsazimut",
                           "ausfallazimut", "azimutbeobachtung", "beobachtungsazimut"})
    all[name] = {AngleKind::azimuth, AngleSide::viewer};
  for (const char* name : {"azimuteinfall", "einfallsazimut", "einfallazimut"})
    all[name] = {AngleKind::azimuth, AngleSide::light};
  add_sides(all);
  for (const char* name : {"incidence", "incident", "aoi", "sza", "iza", "srcz", "sourcez", "illuminationz",
                           "einfallswinkel", "einfallwinkel"})
    all[name] = {AngleKind::polar, AngleSide::light};
  for (const char* name : {"emergence", "vza", "oza", "viewz", "detz", "detectorz", "ausfallswinkel", "aor",
                           "aos", "streuwinkel", "beobachtungswinkel"})
    all[name] = {AngleKind::polar, AngleSide::viewer};
  for (const char* name : {"saa", "iaa", "srca", "sourcea", "illuminationa"})
    all[name] = {AngleKind::azimuth, AngleSide::light};
  for (const char* name : {"vaa", "oaa", "viewa", "deta", "detectora"})
    all[name] = {AngleKind::azimuth, AngleSide::viewer};
  for (const char* name : {"azimuth",
                           "azimuthangle",
                           "dphi",
                           "deltaphi",
                           "relativephi",
                           "relativeazimuth",
                           "relativeazimuthangle",
                           "azimuthdifference",
                           "deltaazimuth",
                           "raa",
                           "phiophii",
                           "phirphii",
                           "phivphii",
                           "phisphii",
                           "relphi",
                           "relaz",
                           "relazimuth",
                           "phirel",
                           "phidiff",
                           "diffphi",
                           "azimuthdiff",
                           "diffazimuth",
                           "dazimuth",
                           "deltaaz",
                           "relativaz",
                           "relativazimut",
                           "relativerazimut",
                           "azimutdifferenz"})
    all[name] = {AngleKind::azimuth, AngleSide::none};
  all["phi"] = {AngleKind::azimuth, AngleSide::none, false, true};
  all["i"] = {AngleKind::polar, AngleSide::light, true};
  all["e"] = {AngleKind::polar, AngleSide::viewer, true};
  return all;
}

bool holds_any(std::string_view text, std::initializer_list<const char*> parts) {
  return std::ranges::any_of(parts, [&](const char* part) { return text.find(part) != text.npos; });
}

}  // namespace

std::string plain_spelling(std::string_view name) {
  std::string text = lower_case(plain_symbols(name));
  std::erase_if(text, [](char c) { return c == ' ' || c == '_' || c == '-' || c == '.' || c == '\\'; });
  return text;
}

std::optional<AngleName> angle_named(std::string_view name) {
  static const AngleNames names = all_names();
  const auto found = names.find(plain_spelling(name));
  if (found == names.end()) return std::nullopt;
  return found->second;
}

bool is_like_azimuth(std::string_view name) {
  const std::string key = plain_spelling(name);
  // phi_h and phi_d belong to the half vector.
  const bool is_phi = key.starts_with("phi") && key != "phih" && key != "phid" && key != "phihalf";
  return is_phi || holds_any(key, {"azimut", "dphi", "deltaphi"});
}

bool is_phase_name(std::string_view name) {
  const std::string key = plain_spelling(name);
  return key == "phase" || key == "phaseangle";
}

std::optional<RoadAngle> road_angle_named(std::string_view name) {
  const std::string key = plain_spelling(name);
  if (key == "tangamma" || key == "tan(gamma)" || key == "tggamma" || key == "tg(gamma)")
    return RoadAngle::tangent;
  if (key == "gamma") return RoadAngle::incidence;
  if (key == "beta") return RoadAngle::azimuth;
  return key == "alpha" ? std::optional(RoadAngle::viewer) : std::nullopt;
}

std::optional<RefusedAngle> refused_angle(std::string_view name) {
  std::string key = plain_spelling(name);
  std::erase(key, '|');
  const std::size_t sine = key.find("sin");
  if ((key.starts_with("beta") && key.find("beta", 4) != key.npos) ||
      (sine != key.npos && key.find("sin", sine + 1) != key.npos))
    return RefusedAngle{
        "is a difference of sines (beta - beta_0, as in Harvey's plots), which does not determine the angle "
        "of incidence: write columns theta_i and theta_o"};
  const bool has_as = key.find("as") != key.npos || key.find("a:") != key.npos;
  const bool has_geometry = has_as && key.find_first_of("0123456789") != key.npos &&
                            key.find_first_not_of("0123456789r:asz()nm, ") == key.npos;
  if (has_geometry || key == "geometry")
    return RefusedAngle{
        "is an aspecular geometry (ASTM E2194), which is not read next to these columns: write columns "
        "theta_i "
        "and theta_o, for 45as15 45 and 30"};
  if (holds_any(key, {"aspec", "offspec", "fromspec", "thetaspec", "thetasspec"}) || key == "delta" ||
      key == "deltatheta" || key == "dtheta")
    return RefusedAngle{
        "is an angle from the mirror direction, which is not read: write columns theta_i and theta_o"};
  if (road_angle_named(name) == RoadAngle::tangent)
    return RefusedAngle{
        "is the tangent of an r-table's angle of incidence: such a table has columns beta, tan gamma and r, "
        "or is a matrix with 'tan gamma \\ beta' in its first cell"};
  return std::nullopt;
}

}  // namespace brdf::io
