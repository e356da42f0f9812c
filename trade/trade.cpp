#include "trade/trade.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "io/files/error.h"
#include "trade/questions/ball.h"
#include "trade/questions/claims.h"
#include "trade/questions/fits.h"
#include "trade/questions/frames.h"
#include "trade/questions/questions.h"
#include "trade/questions/variants.h"

namespace brdf::trade {
namespace {

std::vector<Question> kernel_questions() {
  std::vector<Question> all;
  for (const auto list : {precision_questions, fresnel_questions, masking_questions, lobe_questions,
                          lookup_questions, variant_questions, albedo_questions, integral_questions}) {
    std::vector<Question> some = list();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

// A part of the run, with its share of the run time.
struct Job {
  std::string group, name;
  double weight;
  std::function<std::vector<LedgerRow>()> rows;
};

bool wanted(const Job& job, const std::string& only) {
  return only.empty() || job.group == only || job.name.find(only) != std::string::npos;
}

// Data that several jobs use, made on first use.
struct Shared {
  bool quick;
  PicturePoints picture;
  std::optional<EvaluationTimes> form_times;
  std::unique_ptr<render::Device> device;
  std::string no_device;  // reason for a missing device

  explicit Shared(bool is_quick) : quick(is_quick) {
    const int size = quick ? 96 : 256;
    picture = picture_points(render::lit_points(render::prepare(material_ball(size))), size);
  }
  const EvaluationTimes& times() {
    if (!form_times) form_times = evaluation_times(fittable_forms(), quick ? 21 : 41);
    return *form_times;
  }
  render::Device* gpu() {
    if (device || !no_device.empty()) return device.get();
    try {
      device = std::make_unique<render::Device>();
    } catch (const EnvironmentError& e) {
      no_device = e.what();
    }
    return device.get();
  }
};

std::vector<Job> kernel_jobs(Shared& shared) {
  MeasureOptions options;
  options.picture = &shared.picture;
  options.points = shared.quick ? 4096 : 16384;
  options.rounds = shared.quick ? 21 : 31;
  std::vector<Job> jobs;
  for (const Question& q : kernel_questions())
    jobs.push_back({"kernels", q.name, q.points ? 4.0 : 0.05 * double(q.choices.size()),
                    [q, options] { return measure(q, options); }});
  return jobs;
}

std::vector<Job> evaluation_jobs(Shared& shared) {
  const auto options = [&shared] { return EvaluationOptions{shared.quick, &shared.picture, shared.gpu()}; };
  const FitRowsOptions fits{shared.quick, &shared.picture};
  std::vector<Job> jobs{
      {"batches", "one by one or in batches", 1, [options] { return batch_rows(options()); }},
      {"batches", "a family in the shader", 2,
       [options] { return options().device ? shader_rows(options()) : std::vector<LedgerRow>{}; }}};
  for (const Reflectance& form : fittable_forms())
    if (info(form).canonical)
      jobs.push_back({"families", families_question(form), 2,
                      [&shared, fits, form] { return family_rows(form, shared.times(), fits); }});
  jobs.push_back({"fits", "samples for a fit", 16, [fits] { return sample_count_rows(fits); }});
  return jobs;
}

std::vector<Job> frame_jobs(Shared& shared) {
  std::vector<Job> jobs;
  for (const FrameQuestion& q : frame_questions(shared.quick ? FrameDetail::quick : FrameDetail::full))
    jobs.push_back({"frames", q.name, 0.3 * double(q.ways.size()), [&shared, q] {
                      return shared.gpu() ? measure_frames(*shared.gpu(), q) : std::vector<LedgerRow>{};
                    }});
  return jobs;
}

}  // namespace

Ledger measure_ledger(const TradeOptions& options) {
  Ledger ledger;
  ledger.quick = options.quick;
  ledger.machine = this_machine();
  Shared shared(options.quick);
  std::vector<Job> jobs;
  for (const auto list : {kernel_jobs, evaluation_jobs, frame_jobs}) {
    std::vector<Job> some = list(shared);
    std::move(some.begin(), some.end(), std::back_inserter(jobs));
  }
  std::erase_if(jobs, [&](const Job& job) { return !wanted(job, options.only); });
  double total = 0, done = 0;
  for (const Job& job : jobs) total += job.weight;
  for (const Job& job : jobs) {
    options.progress(done / total, job.name);
    std::vector<LedgerRow> rows = job.rows();
    std::move(rows.begin(), rows.end(), std::back_inserter(ledger.rows));
    done += job.weight;
  }
  if (!shared.no_device.empty()) {
    if (ledger.rows.empty()) throw EnvironmentError(shared.no_device);
    ledger.left_out = "frames and shaders are missing: " + shared.no_device;
  }
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
                    question.c_str(), std::string(name_of(row.error.measure)).c_str(), row.quantity.c_str(),
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
