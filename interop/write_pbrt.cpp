#include <algorithm>

#include "interop/reading.h"

namespace brdf::interop {
namespace {

std::string material(const std::string& name, const std::string& type, const std::string& parameters) {
  return "MakeNamedMaterial \"" + name + "\"\n    \"string type\" \"" + type + "\"\n" + parameters;
}
std::string list(const char* type, const char* name, const std::string& values) {
  return "    \"" + std::string(type) + " " + name + "\" [ " + values + " ]\n";
}
std::string diffuse_material(const std::string& name, const Colour& colour) {
  return material(name, "diffuse", list("rgb", "reflectance", numbers(colour, " ")));
}
std::string conductor(const std::string& name, const Reading& r) {
  // pbrt does not accept an "eta" of 0.
  Colour n = r.shape_colours(Role::index);
  for (double& x : n) x = std::max(x, 1e-3);
  const auto [along, across] = r.along_and_across();
  return material(name, "conductor",
                  list("rgb", "eta", numbers(n, " ")) +
                      list("rgb", "k", numbers(r.shape_colours(Role::extinction), " ")) +
                      list("float", "uroughness", number(along)) +
                      list("float", "vroughness", number(across)) + "    \"bool remaproughness\" false\n");
}

}  // namespace

std::string write_pbrt(const Written& w) {
  for (const WrittenPart& part : w.parts)
    if (const Reading r(part); !r.along_tangent() && !r.crosswise()) r.refuse_turn();
  const std::string name = identifier(w.name);
  const Shares shares = shares_of(w, "a mix of diffuse and conductor");
  // Each mix joins the sum so far with the next material; its "amount" is the share of the second.
  std::string text = comments(w.header, "# "), last;
  double sum = 0;
  const std::size_t pieces = shares.lobes.size() + (shares.diffuse_share > 0);
  std::size_t made = 0;
  const auto join = [&](const std::string& piece, double share) {
    sum += share;
    ++made;
    if (last.empty()) {
      last = piece;
      return;
    }
    const std::string mixed = made == pieces ? name : name + "_mix_" + std::to_string(made);
    text += material(mixed, "mix",
                     "    \"string materials\" [ \"" + last + "\" \"" + piece + "\" ]\n" +
                         list("float", "amount", number(share / sum)));
    last = mixed;
  };
  if (shares.diffuse_share > 0) {
    const std::string piece = pieces > 1 ? name + "_diffuse" : name;
    text += diffuse_material(piece, shares.diffuse);
    join(piece, shares.diffuse_share);
  }
  for (const Shares::Lobe& lobe : shares.lobes) {
    const Reading r(w.parts[lobe.part]);
    r.check_widths(1e-3, 1e4, "nothing");
    const std::string piece =
        pieces == 1 ? name : name + "_lobe" + (lobe.part > 0 ? "_" + std::to_string(lobe.part + 1) : "");
    text += conductor(piece, r);
    join(piece, lobe.share);
  }
  return text;
}

}  // namespace brdf::interop
