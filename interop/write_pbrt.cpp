#include <algorithm>

#include "interop/reading.h"
#include "interop/writers.h"
#include "io/error.h"

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
  // "eta" must not be 0.
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
  const Reading r(w);
  if (r.turn() != 0 && !r.crosswise())
    throw InputError("its tangent is the mesh's: turn the texture coordinates by " + number(r.turn()) +
                     " degrees instead and export with tangent_phi 0");
  const Colour kd = r.weight(Role::diffuse);
  const double share = r.weight(Role::specular)[0];
  const std::string name = identifier(w.name), head = comments(w.header, "# ");
  if (share == 0) return head + diffuse_material(name, kd);
  r.check_widths(1e-3, 1e4, "nothing");
  if (share == 1) return head + conductor(name, r);
  const Colour below{kd[0] / (1 - share), kd[1] / (1 - share), kd[2] / (1 - share)};
  if (std::max({below[0], below[1], below[2]}) > 1 + 1e-9)
    throw InputError("a mix of diffuse and conductor reaches weights of 1 together, not " +
                     number(std::max({kd[0], kd[1], kd[2]}) + share));
  return head + diffuse_material(name + "_diffuse", below) + conductor(name + "_lobe", r) +
         material(name, "mix",
                  "    \"string materials\" [ \"" + name + "_diffuse\" \"" + name + "_lobe\" ]\n" +
                      list("float", "amount", number(share)));
}

}  // namespace brdf::interop
