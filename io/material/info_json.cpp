#include "io/material/info_json.h"

namespace brdf::io {
namespace {

Json parameter_json(const ParameterInfo& p, const char* kind) {
  Json json{{"name", p.name},
            {"kind", kind},
            {"role", name_of(p.role)},
            {"min", p.min},
            {"max", p.max},
            {"default", p.initial},
            {"usual_max", p.usual_max},
            {"unit", p.unit},
            {"log_scale", p.log_scale},
            {"doc", p.doc}};
  if (p.whole) json["whole"] = true;
  return json;
}

}  // namespace

Json to_json(const ReflectanceInfo& form) {
  Json json;
  json["form"] = form.name;
  json["family"] = form.family;
  json["fittable"] = form.fittable();
  json["canonical"] = form.canonical;
  json["parameters"] = Json::array();
  for (const ParameterInfo& p : form.weights) json["parameters"].push_back(parameter_json(p, "weight"));
  for (const ParameterInfo& p : form.shape) json["parameters"].push_back(parameter_json(p, "shape"));
  json["known_violations"] = Json::array();
  for (const Violation& v : form.violations) {
    json["known_violations"].push_back({{"check", v.check},
                                        {"statement", v.statement},
                                        {"witness", v.witness},
                                        {"theta", v.theta},
                                        {"value", v.value}});
  }
  return json;
}

}  // namespace brdf::io
