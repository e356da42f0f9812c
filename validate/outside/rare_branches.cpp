#include "validate/outside/rare_branches.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "io/files/numbers.h"
#include "validate/joint/judge_sampler.h"
#include "validate/search/degrees.h"

namespace brdf::validate {
namespace {

constexpr double kRare = 1e-3;           // share of the directions
constexpr std::size_t kStartPlaces = 3;  // places from which a search starts
constexpr std::size_t kMostSearched = 64;
constexpr double kNegligible = 1e-12;  // 1/sr: f below 0 by less is rounding

// An outcome of a comparison.
using Branch = std::pair<std::uint32_t, bool>;

// The comparisons of one evaluation: the largest surplus towards each outcome, and the lines.
struct Run {
  std::map<Branch, double> towards;  // at least 0: met
  std::map<std::uint32_t, std::uint32_t> lines;
};

struct Tally {
  long met = 0;
  std::uint32_t line = 0;
  std::vector<std::pair<double, std::vector<double>>> nearest = {};  // the largest surplus first

  void add(double towards, std::span<const double> point) {
    met += towards >= 0;
    if (nearest.size() == kStartPlaces && !(towards > nearest.back().first)) return;
    if (nearest.size() == kStartPlaces) nearest.pop_back();
    nearest.emplace_back(towards, std::vector<double>(point.begin(), point.end()));
    std::ranges::stable_sort(nearest, std::greater(), [](const auto& n) { return n.first; });
  }
};

class BranchSearch {
 public:
  BranchSearch(const Subject& subject, const CheckOptions& options) : subject_(subject), options_(options) {}

  std::vector<RareBranch> run() {
    looked_ = options_.effort == Effort::full ? 16384 : 4096;
    for (long k = 0; k < looked_; ++k) {
      if (options_.budget && !options_.budget->take()) return {};
      look_at(cover_point(std::size_t(k), subject_.dimensions() + 4, options_.seed));
    }
    for (const auto& [branch, tally] : tallies_)
      if (double(tally.met) < kRare * double(looked_)) queue_.push_back(branch);
    for (std::size_t done = 0; !queue_.empty() && done < kMostSearched; ++done) {
      const Branch branch = queue_.front();
      queue_.pop_front();
      search(branch);
    }
    return std::move(found_);
  }

 private:
  // A point of the unit cube: the parameters, then light and viewer, spread evenly over the hemisphere.
  Pair pair_at_point(std::span<const double> point) const {
    const auto u = point.subspan(subject_.dimensions());
    const auto theta = [](double x) { return in_degrees(std::acos(std::clamp(1 - x, 1e-9, 1.0))); };
    return pair_at_angles(theta(u[0]), 360 * u[1], theta(u[2]), 360 * u[3]);
  }
  Material material_at(std::span<const double> point) const {
    return subject_.at(point.first(subject_.dimensions()));
  }

  Run run_at(std::span<const double> point) const {
    Run run;
    const Pair p = pair_at_point(point);
    const auto look = [&](std::uint32_t number, std::uint32_t line, bool holds, double surplus) {
      run.lines[number] = line;
      if (std::isnan(surplus)) return;
      for (const bool outcome : {false, true}) {
        const double away = std::max(std::abs(surplus), 1e-300);
        const auto [place, is_new] = run.towards.emplace(Branch{number, outcome}, -HUGE_VAL);
        place->second = std::max(place->second, holds == outcome ? away : -away);
      }
    };
    subject_.outside_facts()->for_each_comparison(material_at(point), p.wi, p.wo, look);
    return run;
  }

  void look_at(const std::vector<double>& point) {
    const Run run = run_at(point);
    for (const auto& [branch, towards] : run.towards) {
      Tally& tally = tallies_[branch];
      tally.line = run.lines.at(branch.first);
      tally.add(towards, point);
    }
  }

  double towards(const Branch& branch, std::span<const double> point) const {
    const Run run = run_at(point);
    const auto place = run.towards.find(branch);
    return place == run.towards.end() ? -HUGE_VAL : place->second;
  }

  void search(const Branch& branch) {
    const Tally& tally = tallies_.at(branch);
    std::vector<std::vector<double>> starts;
    for (const auto& [value, point] : tally.nearest) starts.push_back(point);
    SearchOptions how;
    how.cover = 0;
    how.starts = how.polish = kStartPlaces;
    how.finest = 1e-9;
    const Best best = maximise([&](std::span<const double> p) { return towards(branch, p); },
                               subject_.dimensions() + 4, how, starts);
    if (best.value >= 0) keep(branch, best.point, tally.nearest);
  }

  // Keeps the branch with f inside it and directly beside it.
  void keep(const Branch& branch, const std::vector<double>& inside,
            const std::vector<std::pair<double, std::vector<double>>>& nearest) {
    RareBranch out;
    out.holds = branch.second;
    out.line = tallies_.at(branch).line;
    out.met = tallies_.at(branch).met, out.looked = looked_;
    const Run run = run_at(inside);
    for (const auto& [unseen, value] : run.towards)
      if (!tallies_.contains(unseen)) {
        tallies_[unseen].line = run.lines.at(unseen.first);
        tallies_[unseen].add(value, inside);
        queue_.push_back(unseen);
        out.leads_to_unseen = true;
      }
    out.at = material_at(inside);
    out.pair = pair_at_point(inside);
    const Values deep = values_at(inside);
    const bool is_finite = std::ranges::all_of(deep, [](double x) { return std::isfinite(x); });
    out.least = is_finite ? *std::ranges::min_element(deep) : std::nan("");
    const auto outside = std::ranges::find_if(nearest, [](const auto& n) { return n.first < 0; });
    if (outside != nearest.end()) compare_at_boundary(branch, inside, outside->second, out);
    found_.push_back(std::move(out));
  }

  void compare_at_boundary(const Branch& branch, const std::vector<double>& inside,
                           const std::vector<double>& outside, RareBranch& out) const {
    const auto [in, off] = boundary(branch, inside, outside);
    const Values here = values_at(in), beside = values_at(off);
    for (std::size_t c = 0; c < here.size(); ++c)
      if (c == 0 || here[c] - beside[c] > out.inside - out.beside)
        out.inside = here[c], out.beside = beside[c];
  }

  // Two adjacent points on the line between a point with the outcome and one without.
  std::pair<std::vector<double>, std::vector<double>> boundary(const Branch& branch, std::vector<double> in,
                                                               std::vector<double> off) const {
    for (int step = 0; step < 60; ++step) {
      std::vector<double> middle(in.size());
      for (std::size_t d = 0; d < in.size(); ++d) middle[d] = (in[d] + off[d]) / 2;
      (towards(branch, middle) >= 0 ? in : off) = middle;
    }
    return {in, off};
  }

  Values values_at(std::span<const double> point) const {
    const Material m = material_at(point);
    const Pair p = pair_at_point(point);
    Values f(m.channels.size());
    eval(m, p.wi, p.wo, f);
    return f;
  }

  const Subject& subject_;
  const CheckOptions& options_;
  long looked_ = 0;
  std::map<Branch, Tally> tallies_;
  std::deque<Branch> queue_;
  std::vector<RareBranch> found_;
};

// Whether a check looks at values of f or at integrals of them.
bool depends_on_f(std::string_view check) {
  const bool of_sampler = std::ranges::count(kSamplerChecks, check) > 0;
  return check != "undefined" && (!of_sampler || check == "sample_mean");
}

std::string sentence_of(const Subject& subject, const RareBranch& b) {
  const OutsideFacts& facts = *subject.outside_facts();
  const std::string line = b.line > 0
                               ? "line " + std::to_string(b.line) + ", `" +
                                     (facts.text_of_line ? facts.text_of_line(b.line) : std::string()) + "`: "
                               : std::string();
  return line + "a comparison " + (b.holds ? "holds" : "does not hold") + " at " + std::to_string(b.met) +
         " of " + std::to_string(b.looked) +
         " pairs that are spread evenly, but a search found where it does" + (b.holds ? "" : " not") +
         ": f is " + io::short_number(b.inside, 3) + " against " + io::short_number(b.beside, 3) +
         " /sr beside it" + (b.leads_to_unseen ? ", in code that is executed nowhere else" : "");
}

}  // namespace

bool RareBranch::may_matter() const {
  constexpr double kGrows = 0.01;  // visible; adjacent directions differ by rounding alone
  return leads_to_unseen || !(least >= -kNegligible) ||
         !(inside - beside <= kGrows * std::max(std::abs(beside), kFaintest));
}

std::vector<RareBranch> rare_branches(const Subject& subject, const CheckOptions& options) {
  const OutsideFacts* facts = subject.outside_facts();
  if (!facts || !facts->for_each_comparison || !subject.of_form()) return {};
  return BranchSearch(subject, options).run();
}

void apply_rare_branches(const Subject& subject, const CheckOptions& options, std::span<Finding> findings) {
  const std::vector<RareBranch> branches = rare_branches(subject, options);
  const auto matters = std::ranges::find_if(branches, &RareBranch::may_matter);
  if (matters == branches.end()) return;
  const std::string sentence = sentence_of(subject, *matters);
  for (Finding& f : findings) {
    const bool passes = f.outcome == Outcome::pass || f.outcome == Outcome::known_violation;
    if (!passes || !depends_on_f(f.check)) continue;
    const auto fails = std::ranges::find_if(branches, [&](const RareBranch& b) {
      return f.check == "non_negative" ? b.least < -kNegligible : f.check == "finite" && std::isnan(b.least);
    });
    if (fails == branches.end()) {
      f.outcome = Outcome::undecided;
      f.statement = "undecided: " + sentence + " (the check reported: " + f.statement + ")";
      f.witness.reset();
      continue;
    }
    f.outcome = Outcome::fail;
    f.value = f.check == "finite" ? 1 : fails->least;
    f.statement = (f.check == "finite" ? std::string("f is not finite")
                                       : "f down to " + io::short_number(fails->least, 3) + " /sr") +
                  "; " + sentence_of(subject, *fails);
    f.witness = pair_witness(subject, fails->at, fails->pair);
  }
}

}  // namespace brdf::validate
