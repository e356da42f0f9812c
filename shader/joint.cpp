#include "shader/joint.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "shader/binding.h"
#include "shader/half_precision.h"

namespace brdf::shader {
namespace {

Function companion(const spirv::Module& module, const spirv::Function& function, const Source& source,
                   const std::optional<EntryLine>& line, LowerOptions options,
                   const std::set<spirv::Id>& kernels) {
  Function f;
  const auto in_half = set_programs(f, std::move(options), kernels,
                                    [&](const LowerOptions& o) { return lower(module, function, o); });
  // Values of 16-bit types are rounded in float; values that may have 16 bits are not.
  if (in_half != nullptr && in_half->as_written.size() != f.as_written.size())
    f.half_unknown = "half precision, which the file allows, is not evaluated for samplers and densities";
  f.source = source;
  f.source.entry = line;
  f.entry = signature(module, function);
  return f;
}

std::string message_of(const InputError& e, const std::string& file) {
  const std::string what = e.what();
  return what.starts_with("line ") ? file + ":" + what.substr(5) : what;
}

// A name that means this direction if it is the name of an argument.
bool means(Axis axis, const std::string& name) {
  if (name.empty()) return false;
  const auto meaning = meaning_of(name, true);
  return meaning && meaning->kind == Meaning::Kind::vector && meaning->a == axis;
}

// Returns the name of the only direction that a sampler takes if it returns a direction without a name and
// its argument is called wi, incoming or similar: in a path tracer the ray that comes in is the viewer's.
// Names with an l, such as L and lightDir, mean the light alone. Empty otherwise.
std::string incoming_viewer(const spirv::Module& module, const FoundSampler& sampler) {
  if (!sampler.direction_name.empty()) return "";
  std::string incoming;
  for (const spirv::Id p : sampler.function->parameters) {
    const std::string name = module.name(p);
    if (means(Axis::view, name)) return "";
    if (means(Axis::light, name)) incoming = name;
  }
  return incoming.find_first_of("lL") == incoming.npos ? incoming : "";
}

template <class T>
Vec3<T> converted(const Vec3<double>& w) {
  return {Functions<T>::number(w.x), Functions<T>::number(w.y), Functions<T>::number(w.z)};
}

template <class T>
std::vector<T> values_for(std::span<const double> values, const std::vector<long>& from,
                          const std::vector<double>& initial) {
  std::vector<T> out;
  for (std::size_t k = 0; k < from.size(); ++k)
    out.push_back(Functions<T>::number(from[k] >= 0 ? values[std::size_t(from[k])] : initial[k]));
  return out;
}

[[noreturn]] void refuse_endless(const Function& f, const EndlessLoop& loop) {
  throw InputError(f.source.name + (loop.line > 0 ? ":" + std::to_string(loop.line) : "") + ": " + f.entry +
                   ": this loop may not end: it was stopped after " + std::to_string(kMostStepsRun) +
                   " operations in one evaluation");
}

}  // namespace

std::set<std::string> Joint::parameters() const {
  std::set<std::string> out;
  for (const auto* part : {&sampler_, &density_})
    if (*part)
      for (const Parameter& p : (*part)->function.parameters) out.insert(p.name);
  return out;
}

std::string Joint::half_unknown() const {
  for (const auto* part : {&sampler_, &density_})
    if (*part && !(*part)->function.half_unknown.empty()) return (*part)->function.half_unknown;
  return "";
}

std::shared_ptr<Joint> make_joint(const spirv::Module& module, const spirv::Function& reflectance,
                                  const Source& source, const LowerOptions& of_reflectance,
                                  const std::set<spirv::Id>& kernels) {
  const FoundSampler sampler = find_sampler(module, source, reflectance);
  const FoundDensity density = find_density(module, source, reflectance);
  auto joint = std::make_shared<Joint>();
  for (const std::string& why : {sampler.missing, density.missing})
    if (!why.empty()) joint->missing_.push_back(why);
  LowerOptions options = of_reflectance;
  options.apart = true;
  if (sampler.function) {
    options.results = {sampler.direction};
    if (sampler.pdf) joint->pdf_at_ = 3, options.results.push_back(*sampler.pdf);
    if (sampler.valid)
      joint->valid_at_ = 3 + (sampler.pdf ? 1 : 0), options.results.push_back(*sampler.valid);
    joint->values_at_ = std::size_t(3 + (sampler.pdf ? 1 : 0) + (sampler.valid ? 1 : 0));
    for (const SampledValue& value : sampler.values) {
      if (joint->value_list_.size() == Draw::kMostValues) break;
      options.results.push_back(value.part);
      joint->value_list_.push_back({value.name, value.part.count, value.kind});
    }
    options.written = sampler.written;
    options.accumulated = sampler.accumulated;
    options.random = sampler.generators;
    joint->sampler_name_ = sampler.function->name;
    joint->pdf_name_ = sampler.pdf_name;
    joint->direction_name_ = sampler.direction_name;
    joint->generated_ = !sampler.generators.empty();
    try {
      Function f = companion(module, *sampler.function, source, source.sample, options, kernels);
      f.draws = true;
      if (!(source.sample && source.sample->arguments))
        joint->viewer_name_ = incoming_viewer(module, sampler);
      f.exchanged = means(Axis::view, sampler.direction_name) || !joint->viewer_name_.empty();
      bind_companion(f);
      if (f.randoms == 0)
        throw InputError(source.name + ": " + f.entry +
                         " takes no random numbers that are recognised: name the arguments u, xi or rnd, or "
                         "assign them with a line `//: sample " +
                         sampler.function->name + "(u, V, N, ...)`");
      joint->sampler_ = Joint::Part{std::move(f)};
    } catch (const InputError& e) {
      if (source.sample) throw InputError(message_of(e, source.name));
      joint->missing_.push_back(message_of(e, source.name));
    }
  }
  if (density.function) {
    options.results = {density.part};
    options.written = density.written;
    options.accumulated = density.accumulated;
    options.random.clear();
    joint->density_name_ = density.function->name;
    try {
      Function f = companion(module, *density.function, source, source.pdf, options, kernels);
      f.exchanged =
          exchanges(joint.get(), module, *density.function) && !(source.pdf && source.pdf->arguments);
      bind_companion(f);
      if (!f.is_given(Axis::light))
        throw InputError(source.name + ": " + f.entry +
                         " takes no direction to the light that is recognised: assign the arguments with a "
                         "line `//: pdf " +
                         density.function->name + "(L, V, N, ...)`");
      joint->density_ = Joint::Part{std::move(f)};
    } catch (const InputError& e) {
      if (source.pdf) throw InputError(message_of(e, source.name));
      joint->missing_.push_back(message_of(e, source.name));
    }
  }
  if (!joint->sampler_ && !joint->density_ && joint->missing_.empty()) return nullptr;
  joint->measure_ = source.density_of.value_or(DensityOf::solid_angle);
  joint->measure_is_declared_ = source.density_of.has_value();
  if (source.sample_returns)
    for (Joint::Value& value : joint->value_list_)
      if (!value.kind) value.kind = source.sample_returns;
  return joint;
}

bool exchanges(const Joint* joint, const spirv::Module& module, const spirv::Function& function) {
  if (joint == nullptr || !joint->has_sampler()) return false;
  const std::string name =
      means(Axis::view, joint->direction_name()) ? joint->direction_name() : joint->viewer_name();
  return !name.empty() &&
         std::ranges::any_of(function.parameters, [&](spirv::Id p) { return module.name(p) == name; });
}

void bind_joint(Joint& joint, const Function& reflectance) {
  for (std::optional<Joint::Part>* part : {&joint.sampler_, &joint.density_}) {
    if (!*part) continue;
    const Function& f = (*part)->function;
    std::vector<long> from(f.values, -1);
    std::vector<std::string> unknown;
    for (const Parameter& p : f.parameters) {
      const auto same = std::ranges::find_if(reflectance.parameters, [&](const Parameter& q) {
        return q.name == p.name && q.colour == p.colour;
      });
      if (same == reflectance.parameters.end() && !p.declared) unknown.push_back(p.name);
      for (std::size_t k = 0; k < (p.colour ? 3u : 1u) && same != reflectance.parameters.end(); ++k)
        from[p.first + k] = long(same->first + k);
    }
    if (unknown.empty()) {
      (*part)->initial = f.defaults();
      (*part)->from = std::move(from);
      continue;
    }
    joint.missing_.push_back(reflectance.source.name + ": " + f.entry + ": " + io::joined(unknown) +
                             (unknown.size() > 1 ? " are" : " is") + " not among the arguments of " +
                             reflectance.entry + ": give a value with a line `//: param " + unknown[0] +
                             " MIN MAX DEFAULT`");
    part->reset();
  }
  if (joint.sampler_) {
    const std::string written = joint.direction_name_.empty() ? "the returned vector" : joint.direction_name_;
    joint.notes_.push_back(
        "the sampler is " + joint.sampler_->function.entry + "; the sampled direction is " + written +
        (!joint.viewer_name_.empty() ? "; " + joint.viewer_name_ + " is therefore the direction to the viewer"
         : joint.sampler_->function.exchanged ? ", which is therefore the light"
                                              : ""));
  }
  if (joint.density_) joint.notes_.push_back("the density is " + joint.density_->function.entry);
  if ((joint.density_ || joint.pdf_at_ >= 0) && !joint.measure_is_declared_)
    joint.notes_.push_back(
        "the density is taken per solid angle of the sampled direction; a line `//: pdf per projected` or "
        "`//: pdf per half` states another measure");
}

template <class T>
void Joint::draw_in(std::span<const double> values, const Vec3<double>& wo, std::span<const double> u,
                    std::span<Draw> out) const {
  constexpr int W = kLanes;
  const Function& f = sampler_->function;
  const std::vector<T> own = values_for<T>(values, sampler_->from, sampler_->initial);
  Runner<T, W> runner(f);
  typename Runner<T, W>::Lanes wi, v;
  const Vec3<T> o = converted<T>(wo);
  for (std::size_t l = 0; l < W; ++l) {
    wi[0][l] = wi[1][l] = Functions<T>::number(0), wi[2][l] = Functions<T>::number(1);
    v[0][l] = o.x, v[1][l] = o.y, v[2][l] = o.z;
  }
  runner.set_values(f, own);
  runner.set_directions(f, wi, v);
  const std::size_t stride = f.randoms;
  for (std::size_t first = 0; first < out.size(); first += W) {
    const int lanes = int(std::min<std::size_t>(W, out.size() - first));
    for (int l = 0; l < W; ++l) {
      const std::size_t row = first + std::size_t(std::min(l, lanes - 1));
      runner.set_randoms(f, l, u.subspan(row * stride, stride));
    }
    try {
      runner.run(lanes, own, wi, v);
    } catch (const EndlessLoop& loop) {
      refuse_endless(f, loop);
    }
    for (int l = 0; l < lanes; ++l) {
      const auto number = [&](std::size_t k) { return Functions<T>::value(runner.result(l, k)); };
      Draw& draw = out[first + std::size_t(l)];
      draw.wi = {number(0), number(1), number(2)};
      draw.pdf =
          pdf_at_ < 0 ? std::nan("") : per_solid_angle(measure_, number(std::size_t(pdf_at_)), draw.wi, wo);
      draw.valid = valid_at_ < 0 || number(std::size_t(valid_at_)) != 0;
      std::size_t at = values_at_;
      for (std::size_t k = 0; k < value_list_.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) {
          draw.values[k][c] = number(at + std::min(c, value_list_[k].components - 1));
          if (c + 1 == 3) at += value_list_[k].components;
        }
      draw.used =
          generated_ ? std::size_t(number(at)) + stride - std::min<std::size_t>(stride, kMostRandom) : stride;
    }
  }
}

template <class T>
void Joint::density_in(std::span<const double> values, const Vec3<double>& wo,
                       std::span<const Vec3<double>> wi, std::span<double> out) const {
  constexpr int W = kLanes;
  const Function& f = density_->function;
  const std::vector<T> own = values_for<T>(values, density_->from, density_->initial);
  Runner<T, W> runner(f);
  runner.set_values(f, own);
  const Vec3<T> o = converted<T>(wo);
  typename Runner<T, W>::Lanes i, v;
  for (std::size_t l = 0; l < W; ++l) v[0][l] = o.x, v[1][l] = o.y, v[2][l] = o.z;
  for (std::size_t first = 0; first < out.size(); first += W) {
    const int lanes = int(std::min<std::size_t>(W, out.size() - first));
    for (std::size_t l = 0; l < W; ++l) {
      const Vec3<T> w = converted<T>(wi[first + std::min(l, std::size_t(lanes - 1))]);
      i[0][l] = w.x, i[1][l] = w.y, i[2][l] = w.z;
    }
    runner.set_directions(f, i, v);
    try {
      runner.run(lanes, own, i, v);
    } catch (const EndlessLoop& loop) {
      refuse_endless(f, loop);
    }
    for (int l = 0; l < lanes; ++l) {
      const std::size_t k = first + std::size_t(l);
      out[k] = per_solid_angle(measure_, Functions<T>::value(runner.result(l, 0)), wi[k], wo);
    }
  }
}

void Joint::draw(std::span<const double> values, const Vec3<double>& wo, std::span<const double> u,
                 bool single, std::span<Draw> out) const {
  single ? draw_in<float>(values, wo, u, out) : draw_in<double>(values, wo, u, out);
}

void Joint::density(std::span<const double> values, const Vec3<double>& wo, std::span<const Vec3<double>> wi,
                    bool single, std::span<double> out) const {
  single ? density_in<float>(values, wo, wi, out) : density_in<double>(values, wo, wi, out);
}

}  // namespace brdf::shader
