#include "interop/told.h"

namespace brdf::interop {
namespace {

io::Json to_json(const Loss& loss) {
  return {{"rms", loss.rms},
          {"largest", loss.largest},
          {"theta_i", loss.theta_i},
          {"theta_o", loss.theta_o},
          {"phi", loss.phi},
          {"median", loss.median},
          {"albedo_difference", loss.albedo},
          {"albedo_theta", loss.albedo_theta}};
}

}  // namespace

io::Json to_json(const Program& program, const Exported& made) {
  const Projection& projection = made.projection;
  io::Json json{{"kind", projection.exact()    ? "exact"
                         : projection.refitted ? "refitted"
                                               : "copied"},
                {"target", made.target},
                {"program", program.title},
                {"checked", program.run_here ? "run" : "formula"},
                {"loss", to_json(projection.loss)},
                {"copied", to_json(projection.copied)},
                {"same_here", "brdf eval " + made.words},
                {"refused", io::Json::array()}};
  for (const Refusal& refusal : made.refused)
    json["refused"].push_back({{"target", refusal.target}, {"reason", refusal.reason}});
  return json;
}

}  // namespace brdf::interop
