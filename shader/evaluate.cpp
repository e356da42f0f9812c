// Evaluates a shader's reflectance at given parameters and directions: values, lobes and derivatives.
#include <algorithm>
#include <array>
#include <memory>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/shader.h"

namespace brdf::shader {
namespace detail {
void run_numbers(const Step* steps, std::size_t count, Bank<float, 1>& bank) {
  run_clone(steps, count, bank);
}
void run_numbers(const Step* steps, std::size_t count, Bank<double, 1>& bank) {
  run_clone(steps, count, bank);
}
void run_numbers(const Step* steps, std::size_t count, Bank<float, kLanes>& bank) {
  run_clone(steps, count, bank);
}
void run_numbers(const Step* steps, std::size_t count, Bank<double, kLanes>& bank) {
  run_clone(steps, count, bank);
}
}  // namespace detail

namespace {

constexpr int kFewLanes = 6;  // fewer directions are faster one by one
constexpr int kPartials = 2;  // derivatives computed together

// A runner that is kept between calls, because filling in the constants costs as much as many runs.
template <class T, int W>
Runner<T, W>& runner_of(const Function& function) {
  thread_local std::unique_ptr<Runner<T, W>> kept;
  if (!kept || kept->number() != function.number) kept = Runner<T, W>::hoisted(function);
  return *kept;
}

// The arguments of an evaluation, to recognise a repeated evaluation of the same function.
template <class T>
struct Question {
  std::uint64_t number = 0;
  std::vector<T> numbers = {};  // parameters and directions
  bool times_cosine = false;

  Question() = default;
  Question(std::uint64_t function, const std::vector<T>& values, const Directions<T>& d, bool cosine)
      : number(function), numbers(values), times_cosine(cosine) {
    for (const T* const row : {d.wi_x, d.wi_y, d.wi_z, d.wo_x, d.wo_y, d.wo_z})
      numbers.insert(numbers.end(), row, row + d.count);
  }
  friend bool operator==(const Question&, const Question&) = default;
};
template <class T>
struct Kept {
  Question<T> question;
  std::array<std::vector<T>, 3> results;
};

}  // namespace

template <class T>
std::vector<T> ShaderReflectance::values_of(const ParameterValues<T>& p) const {
  std::vector<T> values(function_.values, T(0));
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const Parameter& parameter = function_.parameters[weights_[k]];
    for (std::size_t c = 0; c < (parameter.colour ? 3u : 1u); ++c) values[parameter.first + c] = p.weights[k];
    // A form that mixes channels may read the first channel's weights for every channel.
    if (info_.mixes_channels && parameter.colour) values[parameter.first] = p.first[k];
  }
  for (std::size_t k = 0; k < shape_.size(); ++k) values[function_.parameters[shape_[k]].first] = p.shape[k];
  return values;
}
template std::vector<double> ShaderReflectance::values_of(const ParameterValues<double>&) const;
template std::vector<float> ShaderReflectance::values_of(const ParameterValues<float>&) const;

void ShaderReflectance::endless(const EndlessLoop& loop) const {
  const std::string where = function_.source.name + (loop.line > 0 ? ":" + std::to_string(loop.line) : "");
  const auto direction = [](const std::array<double, 3>& w) {
    return "(" + io::short_number(w[0], 4) + ", " + io::short_number(w[1], 4) + ", " +
           io::short_number(w[2], 4) + ")";
  };
  std::vector<std::string> input{"light " + direction(loop.wi), "viewer " + direction(loop.wo)};
  for (const Parameter& p : function_.parameters)
    if (p.first < loop.values.size())
      input.push_back(p.name + "=" + io::short_number(loop.values[p.first], 4));
  throw InputError(where + ": this loop may not end: it was stopped after " + std::to_string(kMostStepsRun) +
                   " operations in one evaluation (" + line_of_text(function_.source.text, loop.line) +
                   "), for " + io::joined(input));
}

template <class T, int W>
void ShaderReflectance::evaluate_block(const std::vector<T>& values, const Directions<T>& d,
                                       bool times_cosine, const Components<T>& out) const {
  Runner<T, W>& runner = runner_of<T, W>(function_);
  runner.set_values(function_, values);
  for (std::size_t first = 0; first < d.count; first += W) {
    const int lanes = int(std::min<std::size_t>(W, d.count - first));
    typename Runner<T, W>::Lanes wi, wo;
    for (std::size_t l = 0; l < W; ++l) {  // lanes beyond the last repeat it
      const std::size_t k = first + std::min(l, std::size_t(lanes - 1));
      wi[0][l] = d.wi_x[k], wi[1][l] = d.wi_y[k], wi[2][l] = d.wi_z[k];
      wo[0][l] = d.wo_x[k], wo[1][l] = d.wo_y[k], wo[2][l] = d.wo_z[k];
      if (!(smaller(wi[2][l], wo[2][l]) < T(0))) continue;
      // Below the horizon the shader is not called with the actual directions.
      wi[0][l] = wi[1][l] = wo[0][l] = wo[1][l] = T(0);
      wi[2][l] = wo[2][l] = T(1);
    }
    runner.set_directions(function_, wi, wo);
    runner.run(lanes, values, wi, wo);
    for (int l = 0; l < lanes; ++l) {
      const std::size_t k = first + std::size_t(l);
      const bool below = smaller(d.wi_z[k], d.wo_z[k]) < T(0);
      for (std::size_t c = 0; c < out.size(); ++c)
        if (out[c])
          out[c][k] = below ? T(0)
                            : reflectance_of_returned<T>(function_.returns, runner.result(l, c), d.wi_z[k],
                                                         d.wo_z[k], times_cosine);
    }
  }
}

template <class T>
void ShaderReflectance::evaluate_all(const ParameterValues<T>& p, const Directions<T>& d, bool times_cosine,
                                     T* out) const {
  const std::vector<T> values = values_of(p);
  const std::size_t component = std::min<std::size_t>(p.channel, 2);
  const auto run = [&](const Components<T>& to) {
    d.count < kFewLanes ? evaluate_block<T, 1>(values, d, times_cosine, to)
                        : evaluate_block<T, kLanes>(values, d, times_cosine, to);
  };
  try {
    // One run gives all channels, because callers that request the first channel request the others next.
    constexpr std::size_t kMostKept = 4096;
    if (channels_.empty() || d.count > kMostKept) {
      Components<T> to{};
      to[component] = out;
      return run(to);
    }
    thread_local Kept<T> kept;
    Question<T> question(function_.number, values, d, times_cosine);
    if (component == 0 || !(question == kept.question)) {
      for (std::vector<T>& of : kept.results) of.resize(d.count);
      kept.question = {};
      run({kept.results[0].data(), kept.results[1].data(), kept.results[2].data()});
      kept.question = std::move(question);
    }
    std::copy(kept.results[component].begin(), kept.results[component].end(), out);
  } catch (const EndlessLoop& loop) {
    endless(loop);
  }
}

void ShaderReflectance::eval(const ParameterValues<double>& p, const Directions<double>& d,
                             double* out) const {
  evaluate_all(p, d, false, out);
}
void ShaderReflectance::eval_cos(const ParameterValues<double>& p, const Directions<double>& d,
                                 double* out) const {
  evaluate_all(p, d, true, out);
}
void ShaderReflectance::eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const {
  evaluate_all(p, d, false, out);
}
void ShaderReflectance::eval_cos(const ParameterValues<float>& p, const Directions<float>& d,
                                 float* out) const {
  evaluate_all(p, d, true, out);
}

void ShaderReflectance::derivatives(const std::vector<double>& values, const std::vector<std::size_t>& by,
                                    bool by_phi, std::size_t component, const Directions<double>& d,
                                    double* first, std::size_t stride) const {
  using D = Dual<double, kPartials>;
  constexpr std::size_t W = kLanes;
  const std::size_t count = by.size() + by_phi;
  Runner<D, kLanes>& runner = runner_of<D, kLanes>(function_);
  for (std::size_t begin = 0; begin < count; begin += kPartials) {
    const std::size_t end = std::min(begin + kPartials, count);
    std::vector<D> variables(values.begin(), values.end());
    std::vector<bool> varies(values.size());
    for (std::size_t j = begin; j < std::min(end, by.size()); ++j) {
      const Parameter& p = function_.parameters[by[j]];
      for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c) {
        variables[p.first + c] = D::variable(values[p.first + c], j - begin);
        varies[p.first + c] = true;
      }
    }
    const bool turns = by_phi && end == count;
    runner.set_variables(function_, varies, turns);
    runner.set_values(function_, variables);
    const auto number = [&](double value, double slope) {
      return D(value, Partials<double, kPartials>::make(
                          [&](std::size_t j) { return turns && j == by.size() - begin ? slope : 0.0; }));
    };
    typename Runner<D, kLanes>::Lanes wi, wo;
    const auto set = [&](auto& lanes, std::size_t l, const Vec3<double>& w) {
      lanes[0][l] = number(w.x, w.y), lanes[1][l] = number(w.y, -w.x), lanes[2][l] = number(w.z, 0);
    };
    for (std::size_t first_pair = 0; first_pair < d.count; first_pair += W) {
      const int lanes = int(std::min(W, d.count - first_pair));
      const auto below = [&](std::size_t k) { return smaller(d.wi_z[k], d.wo_z[k]) < 0; };
      for (std::size_t l = 0; l < W; ++l) {  // lanes beyond the last repeat it
        const std::size_t k = first_pair + std::min(l, std::size_t(lanes - 1));
        const Vec3<double> up{0, 0, 1};
        set(wi, l, below(k) ? up : d.wi(k)), set(wo, l, below(k) ? up : d.wo(k));
      }
      runner.set_directions(function_, wi, wo);
      runner.run(lanes, variables, wi, wo);
      for (std::size_t l = 0; l < std::size_t(lanes); ++l) {
        const std::size_t k = first_pair + l;
        const D value = below(k)
                            ? D(0.0)
                            : reflectance_of_returned<D>(function_.returns, runner.result(int(l), component),
                                                         wi[2][l], wo[2][l], false);
        for (std::size_t j = begin; j < end; ++j) first[j * stride + k] = value.v[j - begin];
      }
    }
  }
}

void ShaderReflectance::lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
                              const LobeRows& out) const {
  const bool by_phi = partial == Partial::shape_and_phi;
  const std::size_t rows = partial == Partial::none ? 1 : 1 + shape_.size() + by_phi;
  const int f0 = info_.weight_index(Role::f0);
  try {
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
      std::vector<double> weights(weights_.size(), 0.0);
      weights[lobes_[k].weight] = 1;
      if (f0 >= 0) weights[std::size_t(f0)] = lobes_[k].factor == LobeWeight::Factor::f0 ? 1 : 0;
      const ParameterValues<double> p{weights, weights, shape};
      double* const row = out.data + k * rows * out.stride;
      evaluate_all(p, d, false, row);
      if (partial != Partial::none)
        derivatives(values_of(p), shape_, by_phi, 0, d, row + out.stride, out.stride);
    }
  } catch (const EndlessLoop& loop) {
    endless(loop);
  }
}

void ShaderReflectance::gradient(const ParameterValues<double>& p, const Directions<double>& d,
                                 const LobeRows& out) const {
  std::vector<std::size_t> by = shape_;
  by.insert(by.end(), weights_.begin(), weights_.end());
  const std::size_t component = std::min<std::size_t>(p.channel, 2);
  evaluate_all(p, d, false, out.data);
  try {
    derivatives(values_of(p), by, false, component, d, out.data + out.stride, out.stride);
  } catch (const EndlessLoop& loop) {
    endless(loop);
  }
}

}  // namespace brdf::shader
