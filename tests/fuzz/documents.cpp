// The project's own JSON documents: reading keeps the content, and writing it again gives the same text.
#include "io/material/material_json.h"
#include "render/compare/state.h"
#include "render/scene/scene_json.h"
#include "tests/fuzz/fuzz.h"
#include "trade/ledger/compare.h"

namespace brdf::fuzz {
namespace {

const Registered materials("material", [](std::string_view input) {
  const io::MaterialFile file = io::read_material_file(as_file(input));
  check_material(file.material);
  const std::string text = io::to_text(io::to_json(file));
  require(io::to_text(io::to_json(io::read_material_file(as_file(text)))) == text,
          "the statistics of a fit are kept as they are");
});

const Registered scenes("scene", [](std::string_view input) {
  const io::Json json = io::parse_json(std::string(input), "scene");
  const render::Scene scene = render::scene_from_json({json, "scene"}, "");
  const std::string text = io::to_text(render::to_json(scene));
  const io::Json written = io::parse_json(text, "memory");
  const render::Scene again = render::scene_from_json({written, "memory"}, "");
  require(io::to_text(render::to_json(again)) == text, "a scene reads back as it was written");
  for (const render::Object& object : scene.objects) {
    const glm::mat3 linear = render::linear_part(object);
    require(std::isfinite(glm::determinant(linear)), "objects are of finite size");
  }
});

const Registered states("state", [](std::string_view input) {
  const std::string text = render::state_text(render::load_state(as_file(input)));
  require(render::state_text(render::load_state(as_file(text))) == text,
          "a state reads back as it was written");
});

const Registered ledgers("ledger", [](std::string_view input) {
  trade::Ledger ledger = trade::read_ledger(as_file(input));
  const std::string text = io::to_text(trade::to_json(ledger));
  require(io::to_text(trade::to_json(trade::read_ledger(as_file(text)))) == text,
          "a ledger reads back as it was written");
  require(trade::compare(ledger, ledger).missing.empty(), "a ledger has its own rows");
  trade::mark_dominated(ledger.rows);
  for (const trade::LedgerRow& row : ledger.rows)
    require(row.dominated_by.empty() || ledger.find(row.question, row.dominated_by),
            "what dominates is a row");
  trade::to_csv(ledger);
});

}  // namespace
}  // namespace brdf::fuzz
