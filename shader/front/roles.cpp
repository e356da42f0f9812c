#include "shader/front/roles.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/files/text.h"

namespace brdf::shader {
namespace {

struct AxisWords {
  Axis axis;
  std::string_view letter;  // in products: n of NdotL
  std::array<std::string_view, 28> words;
};

// In lower case, without underscores.
constexpr AxisWords kNamesOf[] = {
    {Axis::light,
     "l",
     {"wi",
      "l",
      "light",
      "lightdir",
      "lightdirection",
      "lightvec",
      "lightvector",
      "ldir",
      "tolight",
      "incoming",
      "incident",
      "omegai",
      "omegain",
      "wil",
      "directiontolight",
      "dirlight",
      "lightdirn",
      "win",
      "surfacetolight",
      "lvec",
      "woutputl",
      "i"}},
    {Axis::view,
     "v",
     {"wo",
      "v",
      "view",
      "viewdir",
      "viewdirection",
      "viewvec",
      "viewvector",
      "vdir",
      "toview",
      "toviewer",
      "eye",
      "eyedir",
      "eyevec",
      "outgoing",
      "omegao",
      "omegaout",
      "wov",
      "directiontoeye",
      "directiontocamera",
      "tocamera",
      "cameradir",
      "toeye",
      "wout",
      "surfacetoview",
      "winputl",
      "o",
      "vvec"}},
    {Axis::normal,
     "n",
     {"n", "normal", "norm", "normaldir", "surfacenormal", "shadingnormal", "worldnormal", "nrm", "ns", "nor",
      "nvec", "normalvector", "ng"}},
    {Axis::half,
     "h",
     {"h", "half", "halfvector", "halfvec", "halfway", "halfdir", "halfwaydir", "wh", "wm", "m", "hvec",
      "halfwayvector"}},
    {Axis::tangent,
     "t",
     {"x", "t", "tangent", "tangentdir", "tan", "tangentu", "tvec", "dpdu", "worldtangent"}},
    {Axis::bitangent,
     "b",
     {"y", "b", "bitangent", "binormal", "bitangentdir", "tangentv", "bvec", "dpdv", "worldbitangent"}}};

std::string plain(std::string_view name) {
  std::string out = io::lower_case(name);
  std::erase(out, '_');
  return out;
}

// The axis with this name, in lower case and without underscores; std::nullopt if the name is unknown.
std::optional<Axis> axis_of(const std::string& word) {
  for (const AxisWords& names : kNamesOf)
    if (!word.empty() && std::ranges::find(names.words, word) != names.words.end()) return names.axis;
  return std::nullopt;
}

std::optional<Axis> letter_axis(std::string_view letters) {
  if (letters == "x") return Axis::tangent;
  if (letters == "y") return Axis::bitangent;
  if (letters == "i") return Axis::light;
  if (letters == "o" || letters == "e") return Axis::view;
  if (letters == "m") return Axis::half;
  for (const AxisWords& names : kNamesOf)
    if (letters == names.letter) return names.axis;
  return axis_of(std::string(letters));
}

// Recognises ndotl, nol, dotnl and nl. The cosine of one direction is its cosine to the normal.
std::optional<std::pair<Axis, Axis>> product_of(const std::string& word) {
  const auto pair = [](std::string_view a, std::string_view b) -> std::optional<std::pair<Axis, Axis>> {
    const auto x = letter_axis(a), y = letter_axis(b);
    if (!x || !y || *x == *y) return std::nullopt;
    return std::pair(*x, *y);
  };
  if (const std::size_t at = word.find("dot"); at != word.npos) {
    if (at > 0) return pair(std::string_view(word).substr(0, at), std::string_view(word).substr(at + 3));
    const std::string_view rest = std::string_view(word).substr(3);
    return rest.size() == 2 ? pair(rest.substr(0, 1), rest.substr(1)) : std::nullopt;
  }
  if (word.size() == 3 && word[1] == 'o')
    return pair(std::string_view(word).substr(0, 1), std::string_view(word).substr(2));
  if (word.size() == 2 && std::string_view("nlvh").find(word[0]) != std::string_view::npos &&
      std::string_view("nlvh").find(word[1]) != std::string_view::npos)
    return pair(std::string_view(word).substr(0, 1), std::string_view(word).substr(1));
  if (word == "mui") return std::pair(Axis::normal, Axis::light);
  if (word == "muo") return std::pair(Axis::normal, Axis::view);
  for (const std::string_view begin : {"costheta", "cos"}) {
    if (!word.starts_with(begin)) continue;
    const std::string_view rest = std::string_view(word).substr(begin.size());
    if (rest == "i" || rest == "l" || rest == "in") return std::pair(Axis::normal, Axis::light);
    if (rest == "o" || rest == "v" || rest == "r" || rest == "out")
      return std::pair(Axis::normal, Axis::view);
    if (rest == "h" || rest == "m") return std::pair(Axis::normal, Axis::half);
    if (rest == "d") return std::pair(Axis::light, Axis::half);
  }
  return std::nullopt;
}

}  // namespace

bool is_random(std::string_view name, std::size_t components) {
  if (components < 1 || components > 4) return false;
  std::string word = plain(name);
  // A single letter means a random number only with a number behind it or as a vector: r is often a
  // roughness, and e an exponent.
  const bool numbered = !word.empty() && word.back() >= '0' && word.back() <= '9';
  while (!word.empty() && word.back() >= '0' && word.back() <= '9') word.pop_back();
  constexpr std::string_view kWords[] = {
      "u",          "xi",           "rnd",  "rand",  "random",  "randoms", "rands",   "urand",
      "urnd",       "zeta",         "rnds", "ulobe", "uselect", "usample", "uniform", "randval",
      "randsample", "randomnumber", "uc",   "rng",   "ux",      "uy",      "uniforms"};
  if (std::ranges::find(kWords, word) != std::end(kWords)) return true;
  if (word == "sample" && numbered) return true;  // sample1 and sample2 of Mitsuba
  return (word == "r" || word == "e" || word == "s" || word == "q") && (components > 1 || numbered);
}

std::optional<Meaning> meaning_of(std::string_view name, bool vector) {
  const std::string whole = plain(name);
  const std::size_t dot = whole.rfind('.');
  const std::string word = dot == whole.npos ? whole : whole.substr(dot + 1),
                    before = dot == whole.npos ? "" : whole.substr(0, dot);
  if (word == "lightcolor" || word == "lightcolour" || word == "radiance" || word == "lightintensity" ||
      word == "lightradiance" || word == "attenuation" || word == "lightattenuation" || word == "occlusion" ||
      word == "ao" || word == "falloff" || word == "shadow" || word == "shadowattenuation" ||
      word == "shadowfactor" || word == "distanceattenuation" || word == "lightstrength" ||
      (before.find("light") != before.npos && (word == "color" || word == "colour" || word == "intensity" ||
                                               word == "colorintensity" || word == "strength")))
    return Meaning{Meaning::Kind::white};
  if (!vector) {
    for (const std::string_view begin : {"", "shading", "clamped", "saturated", "abs"})
      if (word.starts_with(begin))
        if (const auto product = product_of(word.substr(begin.size())))
          return Meaning{Meaning::Kind::product, product->first, product->second};
    return std::nullopt;
  }
  if (word == "direction" || word == "dir") {
    if (before.find("light") != before.npos) return Meaning{Meaning::Kind::vector, Axis::light};
    if (before.find("view") != before.npos) return Meaning{Meaning::Kind::vector, Axis::view};
  }
  if (const auto axis = axis_of(word)) return Meaning{Meaning::Kind::vector, *axis};
  // The name may have a prefix for the origin of the variable (vNormal, uLightDir, in_normal,
  // geometryViewDir) or a suffix for its space (normalWS).
  for (const std::string_view begin : {"in", "v", "u", "a", "f", "s", "g", "frag", "world", "geometry",
                                       "shading", "surface", "local", "pixel"})
    if (word.size() > begin.size() + 2 && word.starts_with(begin))
      if (const auto axis = axis_of(word.substr(begin.size()))) return Meaning{Meaning::Kind::vector, *axis};
  for (const std::string_view end : {"ws", "vs", "es", "ts", "os", "cs", "local", "world"})
    if (word.size() > end.size() + (end.size() > 2 ? 1 : 3) && word.ends_with(end))
      if (const auto axis = axis_of(word.substr(0, word.size() - end.size())))
        return Meaning{Meaning::Kind::vector, *axis};
  return std::nullopt;
}

}  // namespace brdf::shader
