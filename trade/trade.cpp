#include "trade/trade.h"

#include <algorithm>
#include <cstdio>

#include "trade/ball.h"
#include "trade/claims.h"
#include "trade/fits.h"
#include "trade/frames.h"
#include "trade/questions.h"
#include "trade/variants.h"

namespace brdf::trade {
namespace {

std::vector<Question> kernel_questions() {
  std::vector<Question> all;
  for (const auto list : {precision_questions, fresnel_questions, masking_questions, lobe_questions,
                          lookup_questions, variant_questions, albedo_questions}) {
    std::vector<Question> some = list();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

Ledger measure_ledger(const TradeOptions& options) {
  Ledger ledger;
  ledger.quick = options.quick;
  ledger.machine = this_machine();
  const int size = options.quick ? 96 : 256;
  const PicturePoints picture =
      picture_points(render::lit_points(render::prepare(material_ball(size))), size);
  MeasureOptions measuring;
  measuring.picture = &picture;
  measuring.points = options.quick ? 4096 : 16384;
  measuring.rounds = options.quick ? 21 : 31;
  const auto add = [&](std::vector<LedgerRow> rows) {
    std::move(rows.begin(), rows.end(), std::back_inserter(ledger.rows));
  };
  const auto group = [&](const char* name) { return options.only.empty() || options.only == name; };
  std::vector<Question> questions = kernel_questions();
  std::erase_if(questions, [&](const Question& q) { return q.name.find(options.only) == std::string::npos; });
  // Shares of the whole run, roughly: kernels a third, fits a third, frames a third.
  for (std::size_t k = 0; k < questions.size(); ++k) {
    options.progress(0.35 * double(k) / double(questions.size()), questions[k].name);
    add(measure(questions[k], measuring));
  }
  const FitRowsOptions fits{options.quick, &picture, [&, done = 0.35](const std::string& what) mutable {
                              options.progress(done = std::min(0.65, done + 0.03), what);
                            }};
  if (group("batches")) add(batch_rows(fits));
  if (group("families")) add(family_rows(fits));
  if (group("fits")) add(sample_count_rows(fits));
  const FrameOptions frames{options.quick, [&, done = 0.65](const std::string& what) mutable {
                              options.progress(done = std::min(0.99, done + 0.05), what);
                            }};
  if (group("frames")) add(frame_rows(frames));
  ledger.claims = judge_claims(ledger);
  options.progress(1, "");
  return ledger;
}

std::string to_terminal(const Ledger& ledger) {
  std::string text;
  std::string question;
  for (const LedgerRow& row : ledger.rows) {
    char line[512];
    if (row.question != question) {
      question = row.question;
      std::snprintf(line, sizeof line, "\n%s  (error: %s of %s; %s)\n  %-36s %10s %7s %9s %9s %9s %9s\n",
                    question.c_str(), kMeasureNames[std::size_t(row.error.measure)], row.quantity.c_str(),
                    row.domain.c_str(), "choice", "ns", "cost", "max", "mean", "p99", "image");
      text += line;
    }
    char image[16] = "-";
    if (row.image_error) std::snprintf(image, sizeof image, "%.2g", *row.image_error);
    std::snprintf(line, sizeof line, "  %-36s %10.4g %7.3g %9.2g %9.2g %9.2g %9s%s\n", row.choice.c_str(),
                  row.cost.seconds * 1e9, row.cost_ratio, row.error.max, row.error.mean, row.error.p99, image,
                  row.dominated_by.empty() ? "" : ("   dominated by " + row.dominated_by).c_str());
    text += line;
  }
  for (const Claim& c : ledger.claims)
    text += "\n" + c.source + ": " + c.claim + "\n  " + c.verdict + ": " + c.evidence + "\n";
  return text;
}

}  // namespace brdf::trade
