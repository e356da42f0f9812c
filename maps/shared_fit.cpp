#include "maps/shared_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "fit/algebra/box_quadratic.h"
#include "fit/assess/reported.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::maps {
namespace {

constexpr int kMostSteps = 40;
// Predicted decrease of the cost, relative to the cost, at which a region is settled.
constexpr double kPromise = 1e-13;

using Slots = std::vector<std::size_t>;

// Returns the shapes that the names denote. The names are the same as in reports; in a sum, the name of the
// term may be omitted.
Slots slots_of(const fit::Model& model, const std::vector<std::string>& names) {
  Slots out;
  std::vector<std::string> known;
  for (const std::string& name : names) {
    const std::size_t before = out.size();
    known.clear();
    for (std::size_t k = 0; k < model.shape_slots(); ++k) {
      const fit::Slot& slot = model.slots()[k];
      if (slot.kind != fit::Slot::Kind::shape) continue;
      known.push_back(slot.name);
      if ((slot.name == name || slot.name.ends_with("." + name)) && std::ranges::find(out, k) == out.end())
        out.push_back(k);
    }
    if (out.size() == before)
      throw InputError("--share " + name + ": must be a shape that is fitted: " +
                       (known.empty() ? "this fit has no fitted shape" : io::joined(known)));
  }
  std::ranges::sort(out);
  return out;
}

// A region's shared parameters on the solver's scale, and the sums of the terms that its texels contribute.
struct Shared {
  std::vector<double> p, best;
  double cost = 0, best_cost = std::numeric_limits<double>::infinity();
  fit::Matrix hessian, meat, covariance;
  std::vector<double> gradient;
  bool known = false, settled = false;

  explicit Shared(std::size_t size) : p(size), best(size) { clear(); }
  void clear() {
    const std::size_t size = p.size();
    cost = 0;
    hessian = meat = fit::Matrix(size, size);
    gradient.assign(size, 0);
  }
  void add(const Shared& other) {
    const auto sum = [](std::vector<double>& to, const std::vector<double>& from) {
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += from[k];
    };
    cost += other.cost;
    sum(hessian.a, other.hessian.a);
    sum(meat.a, other.meat.a);
    sum(gradient, other.gradient);
  }
};

class SharedFit {
 public:
  SharedFit(const texel::Stack& stack, const Settings& settings, const Normals* normals,
            const Sharing& sharing, const Resources& resources, const io::Progress& progress)
      : stack_(stack),
        settings_(settings),
        normals_(normals),
        sharing_(sharing),
        resources_(resources),
        progress_(progress),
        model_(TexelFitter(stack, settings).model()),
        slots_(slots_of(model_, sharing.names)),
        // The bands do not depend on the number of threads, and neither do sums over them.
        bands_(texel::divided({0, 0, stack.width, stack.height}, stack.width, kUnit)),
        regions_(sharing.count, Shared(slots_.size())) {}

  texel::Planes run() {
    start();
    for (int step = 0; step < kMostSteps && !settings_.options.stop(); ++step) {
      sum_terms();
      bool settled = true;
      for (Shared& s : regions_) settled = take_step(s) && settled;
      if (settled) break;
    }
    for (Shared& s : regions_) {
      s.p = s.best;
      s.covariance = fit::sandwich(s.hessian, s.meat);
    }
    return final_maps();
  }

 private:
  // Returns the region of a texel, or null if the texel shares nothing.
  Shared* region_of(const texel::Region& band, std::size_t k) {
    const std::size_t texel = (band.y + k / band.width) * stack_.width + band.x + k % band.width;
    const std::size_t region = sharing_.regions[texel];
    return region > 0 && regions_[region - 1].known ? &regions_[region - 1] : nullptr;
  }
  std::size_t index_of(const Shared& s) const { return std::size_t(&s - regions_.data()); }

  // Works on every band in parallel and consumes the results in order.
  template <class Work, class Consume>
  void for_each_band(Work&& work, Consume&& consume) {
    const std::size_t memory = resources_.memory / std::max(resources_.threads, 1u);
    io::parallel_in_order(
        int(bands_.size()), int(resources_.threads), progress_,
        [&](int k) { return work(bands_[std::size_t(k)], memory); }, consume);
  }
  void hold(TexelFitter& fitter, const Shared* shared) const {
    if (shared)
      fitter.hold(slots_, shared->p);
    else
      fitter.hold({}, {});
  }

  // Starts each region at the median of the values that its texels find separately.
  void start() {
    using Values = std::vector<std::vector<double>>;  // [slot]
    std::map<std::size_t, Values> found;
    for_each_band(
        [&](const texel::Region& band, std::size_t memory) {
          std::map<std::size_t, Values> here;
          TexelFitter fitter(stack_, settings_);
          fit_texels(fitter, stack_, settings_, normals_, band, memory, {},
                     [&](std::size_t k, const TexelPixels&, const TexelFit& fit) {
                       const std::size_t texel = band.y * stack_.width + k;
                       if (sharing_.regions[texel] == 0) return;
                       Values& values = here[sharing_.regions[texel] - 1];
                       values.resize(slots_.size());
                       for (std::size_t s = 0; s < slots_.size(); ++s) values[s].push_back(fit.p[slots_[s]]);
                     });
          return here;
        },
        [&](std::map<std::size_t, Values> here) {
          for (auto& [region, values] : here) {
            found[region].resize(slots_.size());
            for (std::size_t s = 0; s < values.size(); ++s)
              found[region][s].insert(found[region][s].end(), values[s].begin(), values[s].end());
          }
        });
    for (auto& [region, values] : found) {
      regions_[region].known = true;
      for (std::size_t s = 0; s < values.size(); ++s)
        regions_[region].p[s] = io::median(std::move(values[s]));
    }
  }

  void sum_terms() {
    for (Shared& s : regions_) s.clear();
    for_each_band(
        [&](const texel::Region& band, std::size_t memory) {
          std::map<std::size_t, Shared> sums;
          TexelFitter fitter(stack_, settings_);
          fit_texels(
              fitter, stack_, settings_, normals_, band, memory,
              [&](std::size_t k) { hold(fitter, region_of(band, k)); },
              [&](std::size_t k, const TexelPixels&, const TexelFit& fit) {
                const Shared* shared = region_of(band, k);
                if (!shared) return;
                const TexelFitter::SharedTerms terms = fitter.shared_terms(fit, slots_);
                Shared one(slots_.size());
                one.cost = terms.cost;
                one.hessian = terms.profile.hessian;
                one.gradient = terms.profile.gradient;
                one.meat = terms.meat;
                sums.try_emplace(index_of(*shared), slots_.size()).first->second.add(one);
              });
          return sums;
        },
        [&](const std::map<std::size_t, Shared>& sums) {
          for (const auto& [region, sum] : sums) regions_[region].add(sum);
        });
  }

  // Takes one step; returns true if the region has settled. A step that raises the cost is halved.
  bool take_step(Shared& s) const {
    if (!s.known || s.settled) return true;
    if (s.cost > s.best_cost) {
      double change = 0;
      for (std::size_t k = 0; k < s.p.size(); ++k) {
        s.p[k] = 0.5 * (s.p[k] + s.best[k]);
        change = std::max(change, std::abs(s.p[k] - s.best[k]));
      }
      return s.settled = change < 1e-12;
    }
    s.best = s.p;
    s.best_cost = s.cost;
    const std::vector<double> low = model_.low(), high = model_.high();
    std::vector<double> to_low, to_high;
    for (std::size_t k = 0; k < s.p.size(); ++k) {
      to_low.push_back(low[slots_[k]] - s.p[k]);
      to_high.push_back(high[slots_[k]] - s.p[k]);
    }
    const std::vector<double> step = fit::box_quadratic(s.hessian, s.gradient, to_low, to_high);
    double promised = 0;
    for (std::size_t k = 0; k < step.size(); ++k) promised -= 0.5 * step[k] * s.gradient[k];
    if (!(promised > kPromise * s.cost)) return s.settled = true;
    for (std::size_t k = 0; k < step.size(); ++k) s.p[k] += step[k];
    return false;
  }

  // Returns the settings for the texels of a region, in which the shared shapes are held.
  Settings held_settings(const Shared& s) const {
    Settings out = settings_;
    std::map<std::string, std::vector<double>> values;
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const fit::Slot& slot = model_.slots()[slots_[k]];
      values[slot.name].push_back(slot.to_natural(s.p[k]));  // groups in the order of the channels
    }
    for (auto& [name, list] : values) out.options.fix.push_back({name, std::move(list)});
    return out;
  }

  struct Held {
    Settings settings;
    TexelFitter fitter;
    Held(const texel::Stack& stack, Settings s) : settings(std::move(s)), fitter(stack, settings) {}
  };

  // Returns a texel's own parameters from a fit that holds the shared ones. The uncertainty of the shared
  // parameters is added to the standard errors.
  TexelFit own_fit(TexelFitter& together, Held& held, const TexelPixels& pixels, const TexelFit& fit,
                   const Shared& shared) const {
    const fit::Profile profile = together.shared_terms(fit, slots_).profile;
    TexelFit start = fit;
    for (std::size_t k = slots_.size(); k-- > 0;) start.p.erase(start.p.begin() + std::ptrdiff_t(slots_[k]));
    const std::size_t texel = pixels.y * stack_.width + pixels.x;
    TexelFit out = held.fitter.fit(pixels, normal_at(normals_, texel), &start);
    const std::vector<fit::Reported> reported = fit::reported_parameters(model_, fit.p);
    for (std::size_t k = 0; k < out.estimates.size(); ++k) {
      fit::Estimate& e = out.estimates[k];
      fit::Matrix slope(slots_.size(), 1);  // derivatives of the reported parameter by the shared ones
      bool is_shared = false;
      for (const auto& [slot, by_slot] : reported[k].gradient) {
        is_shared = is_shared || std::ranges::find(slots_, slot) != slots_.end();
        for (std::size_t s = 0; s < slots_.size(); ++s) slope(s, 0) += by_slot * profile.follows(slot, s);
      }
      if (is_shared) e.status = fit::Status::free, e.freedom = std::numeric_limits<double>::infinity();
      if (e.status == fit::Status::free)
        e.standard_error = std::hypot(
            e.standard_error, std::sqrt(std::max(fit::congruent(slope, shared.covariance)(0, 0), 0.0)));
    }
    return out;
  }

  texel::Planes final_maps() {
    texel::Planes maps = empty_maps(stack_, settings_);
    std::size_t next = 0;
    for_each_band(
        [&](const texel::Region& band, std::size_t memory) {
          texel::Planes out = unknown_maps(model_, band.width, band.height);
          TexelFitter fitter(stack_, settings_);
          std::map<std::size_t, std::unique_ptr<Held>> held;
          fit_texels(
              fitter, stack_, settings_, normals_, band, memory,
              [&](std::size_t k) { hold(fitter, region_of(band, k)); },
              [&](std::size_t k, const TexelPixels& pixels, const TexelFit& fit) {
                const auto put_fit = [&](const TexelFit& found) {
                  put_texel(plane_values(found, settings_.fits_normal, stack_.channels.size()), k, out);
                };
                const Shared* shared = region_of(band, k);
                if (!shared) return put_fit(fit);
                std::unique_ptr<Held>& own = held[index_of(*shared)];
                if (!own) own = std::make_unique<Held>(stack_, held_settings(*shared));
                TexelFit found = own_fit(fitter, *own, pixels, fit, *shared);
                found.from_grid = fit.from_grid;
                if (!found.empty()) put_fit(found);
              });
          return out;
        },
        [&](const texel::Planes& band) { put(band, bands_[next++], maps); });
    return maps;
  }

  const texel::Stack& stack_;
  const Settings& settings_;
  const Normals* normals_;
  const Sharing& sharing_;
  Resources resources_;
  io::Progress progress_;
  fit::Model model_;
  Slots slots_;
  std::vector<texel::Region> bands_;
  std::vector<Shared> regions_;
};

}  // namespace

Sharing read_sharing(const std::vector<std::string>& names, const std::filesystem::path& file,
                     const texel::Stack& stack) {
  Sharing out{names, std::vector<std::size_t>(stack.width * stack.height, 1), 1};
  if (file.empty()) return out;
  const texel::Planes image = texel::read_planes(file);
  if (image.width != stack.width || image.height != stack.height || image.values.size() != 1)
    throw InputError(file.string() + ": regions must be one channel of the stack's " +
                     std::to_string(stack.width) + " x " + std::to_string(stack.height) + " texels");
  std::map<float, std::size_t> number_of;
  for (std::size_t k = 0; k < out.regions.size(); ++k) {
    const float label = image.values[0][k];
    if (!(label >= 0) || label != std::floor(label))
      throw InputError(file.string() + ": at " + std::to_string(k % stack.width) + ", " +
                       std::to_string(k / stack.width) + ": " + io::short_number(double(label)) +
                       ": a region is a whole number, 0 or more");
    out.regions[k] = label > 0 ? number_of.try_emplace(label, number_of.size() + 1).first->second : 0;
  }
  out.count = number_of.size();
  return out;
}

texel::Planes fit_shared(const texel::Stack& stack, const Settings& settings, const Normals* normals,
                         const Sharing& sharing, const Resources& resources, const io::Progress& progress) {
  return SharedFit(stack, settings, normals, sharing, resources, progress).run();
}

}  // namespace brdf::maps
