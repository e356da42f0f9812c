#include "interop/told.h"

namespace brdf::interop {

io::Json to_json(const Program& program, const Exported& made) {
  io::Json json{{"kind", made.is_same             ? "exact"
                         : made.loss.none_found() ? "no_difference"
                         : made.refitted          ? "refitted"
                                                  : "copied"},
                {"target", made.target},
                {"program", program.title},
                {"checked", program.run_here ? "run" : "formula"},
                {"loss", to_json(made.loss)},
                {"copied", to_json(made.copied)},
                {"not_held", made.not_held},
                {"refused", io::Json::array()}};
  const char* const key = made.by_channel ? "by_channel_here" : "same_here";
  if (made.words.size() == 1) json[key] = "brdf eval " + made.words[0];
  for (std::size_t k = 0; made.words.size() > 1 && k < made.words.size(); ++k)
    json[key].push_back("brdf eval " + made.words[k]);
  for (const Refusal& refusal : made.refused)
    json["refused"].push_back({{"target", refusal.target}, {"reason", refusal.reason}});
  return json;
}

}  // namespace brdf::interop
