#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "interop/reading.h"

namespace brdf::interop {
namespace {

// Radiance treats alpha^2 <= 1e-6 as a mirror.
constexpr double kMirrorAlpha = 1.0001e-3;

// Radiance reads a word of at most 127 characters, and a comment of at most 2047: it takes the rest for
// further words. Names grow by a suffix.
constexpr std::size_t kLongestName = 100, kLongestComment = 1000;

// Returns the name of the last modifier. Two names have a meaning of their own.
std::string name_of(const Written& w) {
  const std::string name = identifier(w.name).substr(0, kLongestName);
  return name == "void" || name == "inherit" ? "material_" + name : name;
}

std::string folded_comments(const std::vector<std::string>& header) {
  std::vector<std::string> lines;
  for (const std::string& line : header)
    for (std::size_t at = 0; at == 0 || at < line.size(); at += kLongestComment)
      lines.push_back(line.substr(at, kLongestComment));
  return comments(lines, "# ");
}

// Returns one modifier: its words, and its real numbers.
std::string modifier(const std::string& type, const std::string& name, const std::string& words,
                     const std::string& numbers_of) {
  const auto counted = [](const std::string& list) {
    const auto count = list.empty() ? 0 : 1 + std::ranges::count(list, ' ');
    return std::to_string(count) + (list.empty() ? "" : " " + list) + "\n";
  };
  return "void " + type + " " + name + "\n" + counted(words) + "0\n" + counted(numbers_of);
}

// Returns a plastic or a metal, with a second roughness and its direction if the widths differ.
std::string surface(const std::string& type, const std::string& name, const Colour& colour, double specular,
                    const Reading& r) {
  r.check_widths(kMirrorAlpha, 1e4, "nothing");
  const std::string numbers_of = numbers(colour, " ") + " " + number(specular) + " " + number(r.alpha_x());
  if (!r.anisotropic()) return modifier(type, name, "", numbers_of);
  const double turn = r.turn() * std::numbers::pi / 180;
  return modifier(type + "2", name, number(std::cos(turn)) + " " + number(std::sin(turn)) + " 0 .",
                  numbers_of + " " + number(r.alpha_y()));
}

// A metal that has a diffuse part of its colour.
struct Metal {
  Colour colour{};
  double specular = 1;
};
// Returns the metal with the same diffuse and specular weights, if there is one: kd = colour (1 - specular)
// and ks = colour specular in every channel.
std::optional<Metal> as_metal(const Colour& kd, const Colour& ks) {
  Metal metal;
  const std::size_t brightest = std::size_t(std::ranges::max_element(ks) - ks.begin());
  metal.specular = ks[brightest] / (ks[brightest] + kd[brightest]);
  for (std::size_t c = 0; c < 3; ++c) {
    metal.colour[c] = kd[c] + ks[c];
    if (std::abs(metal.colour[c] * metal.specular - ks[c]) > 1e-12) return std::nullopt;
  }
  return metal;
}

}  // namespace

std::string write_radiance(const Written& w) {
  const std::string name = name_of(w);
  const Shares shares = shares_of(w, "mixfunc");
  const std::string head = folded_comments(w.header);
  if (shares.lobes.empty())
    return head + modifier("plastic", name, "", numbers(shares.diffuse, " ") + " 0 0");
  if (shares.lobes.size() == 1) {
    const Shares::Lobe& lobe = shares.lobes[0];
    const Reading r(w.parts[lobe.part]);
    if (is_grey(lobe.tint)) return head + surface("plastic", name, shares.diffuse, lobe.share, r);
    Colour kd = shares.diffuse, ks = lobe.tint;
    for (std::size_t c = 0; c < 3; ++c) kd[c] *= shares.diffuse_share, ks[c] *= lobe.share;
    if (const auto metal = as_metal(kd, ks))
      return head + surface("metal", name, metal->colour, metal->specular, r);
  }
  // The last mixture has the material's name. Each mixture joins a lobe with the sum of those before.
  std::string text = head, last;
  double sum = shares.diffuse_share;
  if (sum > 0) {
    last = name + "_diffuse";
    text += modifier("plastic", last, "", numbers(shares.diffuse, " ") + " 0 0");
  }
  for (std::size_t k = 0; k < shares.lobes.size(); ++k) {
    const Shares::Lobe& lobe = shares.lobes[k];
    const std::string piece = name + "_lobe" + (k > 0 ? "_" + std::to_string(k + 1) : "");
    text += surface("metal", piece, lobe.tint, 1, Reading(w.parts[lobe.part]));
    sum += lobe.share;
    const std::string mixed = k + 1 == shares.lobes.size() ? name : name + "_mix_" + std::to_string(k + 1);
    if (!last.empty())
      text += modifier("mixfunc", mixed, piece + " " + last + " " + number(lobe.share / sum) + " .", "");
    last = last.empty() ? piece : mixed;
  }
  return text;
}

}  // namespace brdf::interop
