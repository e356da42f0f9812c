#include "interop/lookup_table.h"

#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "validate/search/search.h"

namespace brdf::interop {
namespace {

constexpr AlbedoOptions kOfTables{.fixed = Fixed::viewer, .tolerance = 1e-6};

Angle angle_of_cosine(double cosine) {
  return radians(std::acos(std::clamp(cosine, 0.0, 1.0)));
}

// Integrates by the usual rule, and by bisection if that rule does not converge, as at grazing angles.
template <class Integral>
auto converged_or_bisected(const Integral& integral) {
  const auto done = [](const AlbedoResult& r) { return r.converged; };
  const std::vector<AlbedoResult> first = integral(kOfTables);
  if (std::ranges::all_of(first, done)) return first;
  AlbedoOptions bisection = kOfTables;
  bisection.rule = Rule::adaptive;
  return integral(bisection);
}

// Returns the integral of the lobe with this factor of its weight, or -1 if there is none or more than one.
int lobe_with(const ReflectanceInfo& form, LobeWeight::Factor factor) {
  int found = -1;
  for (std::size_t k = 0; k < form.lobes.size(); ++k)
    if (form.lobes[k].factor == factor) found = found == -1 ? int(k) : -2;
  return std::max(found, -1);
}

// A coordinate in texels, between the first and the last.
double in_texels(const TableAxis& axis, std::size_t size, double t) {
  const double along = axis.descending ? 1 - t : t;
  const double place = axis.rule == TexelRule::ends ? along * double(size - 1) : along * double(size) - 0.5;
  return std::clamp(place, 0.0, double(size - 1));
}

// The alpha that a coordinate of an axis stands for, if it is one of roughness.
double alpha_on(const TableAxis& axis, double t) {
  return axis.quantity == TableQuantity::alpha ? t : t * t;
}

bool is_of_cosine(const TableAxis& axis) {
  return axis.quantity == TableQuantity::cosine || axis.quantity == TableQuantity::cosine_of_root;
}

double cosine_on(const TableAxis& axis, double t) {
  return axis.quantity == TableQuantity::cosine ? t : t * t;
}

// A table of one coordinate only has one texel along the axis of roughness.
std::size_t size_of(const TableAxis& axis, const TableFunction& function) {
  return is_of_cosine(axis) || function.has_roughness() ? axis.size : 1;
}

// Searches the largest difference between the reading and the integral.
void search_reading(LookupTable& table, const TableFunction& function) {
  const std::size_t directional = function.channels().size();
  std::size_t unknown = 0;
  const auto compare = [&](std::span<const double> at, std::size_t first, std::size_t last) {
    const TablePlace place = place_at(*table.layout, at[0], at[1]);
    const bool is_mean = first == directional;
    const TableFunction::Values exact =
        is_mean ? function.mean(place.alpha) : function.directional(place.cosine, place.alpha);
    ReadingError worst{-1, place.cosine, std::sqrt(place.alpha)};
    if (!exact.converged) return worst;
    for (std::size_t c = first; c < last; ++c) {
      const double value = exact.values[c - first], read = table.read(c, at[0], at[1]);
      if (const double difference = std::abs(read - value); difference > worst.difference)
        worst = {difference, place.cosine, std::sqrt(place.alpha), read, value, table.channels[c]};
    }
    return worst;
  };
  // One search for the directional channels, and one for the mean, which is constant along the cosine.
  const auto search = [&](std::size_t first, std::size_t last, std::size_t columns) {
    std::vector<std::vector<double>> starts;
    const std::size_t rows = table.layout->y.size;
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < columns; ++x)
        starts.push_back({(double(x) + 0.5) / double(columns), (double(y) + 0.5) / double(rows)});
    // The outermost texels are held, and albedos bend most at grazing angles and small widths.
    for (const double u : {0.0, 1.0 / 512, 1.0 / 64, 1 - 1.0 / 512, 1.0})
      for (const double v : {0.0, 1.0 / 512, 1.0 / 64, 1 - 1.0 / 512, 1.0}) starts.push_back({u, v});
    std::vector<double> differences(starts.size());
    io::parallel_for(starts.size(),
                     [&](std::size_t k) { differences[k] = compare(starts[k], first, last).difference; });
    unknown += std::size_t(std::ranges::count(differences, -1.0));
    std::vector<std::size_t> order(starts.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, std::greater<>(), [&](std::size_t k) { return differences[k]; });
    std::vector<std::vector<double>> best;
    for (std::size_t k = 0; k < std::min<std::size_t>(order.size(), 60); ++k)
      best.push_back(starts[order[k]]);
    validate::SearchOptions options;
    options.cover = 0;
    options.starts = options.polish = 8;
    options.finest = 1e-5;
    const auto objective = [&](std::span<const double> at) {
      const ReadingError here = compare(at, first, last);
      unknown += here.difference < 0;
      if (here.difference > table.reading.difference) table.reading = here;
      return here.difference;
    };
    validate::maximise(objective, 2, options, best);
  };
  table.reading.difference = -1;
  const bool cosine_along_x = is_of_cosine(table.layout->x);
  search(0, directional, table.layout->x.size);
  if (table.channels.size() > directional)
    search(directional, table.channels.size(), cosine_along_x ? 1 : 16);
  table.reading.unknown = unknown;
}

}  // namespace

TablePlace place_at(const TableLayout& layout, double x, double y) {
  const bool first = is_of_cosine(layout.x);
  const TableAxis &cosine = first ? layout.x : layout.y, &width = first ? layout.y : layout.x;
  return {cosine_on(cosine, first ? x : y), alpha_on(width, first ? y : x)};
}

double LookupTable::read(std::size_t channel, double x, double y) const {
  const double u = in_texels(layout->x, width, x), v = in_texels(layout->y, height, y);
  const std::size_t i = std::size_t(u), j = std::size_t(v);
  const std::size_t right = std::min(i + 1, width - 1), below = std::min(j + 1, height - 1);
  const auto texel = [&](std::size_t at_x, std::size_t at_y) { return texels[channel][at_y * width + at_x]; };
  const double a = u - double(i), b = v - double(j);
  return (1 - b) * ((1 - a) * texel(i, j) + a * texel(right, j)) +
         b * ((1 - a) * texel(i, below) + a * texel(right, below));
}

TableFunction::TableFunction(const Material& material, TableKind kind, bool bias_first)
    : term_(material.terms.at(0)), kind_(kind), bias_first_(bias_first) {
  const ReflectanceInfo& form = info(term_.form);
  if (material.terms.size() > 1)
    throw InputError("a lookup table: the material is a sum of terms; a table holds one lobe: give a form");
  if (term_.shape.size() > 1)
    throw InputError("a lookup table: the shape differs between the channels; a table holds one shape");
  if (is_anisotropic(material))
    throw InputError("a lookup table: the lobe is anisotropic, and a table has one width: set both equal");
  term_.weights.resize(1);
  term_.tangent_phi = {};
  const int specular = form.weight_index(Role::specular), diffuse = form.weight_index(Role::diffuse);
  splits_ = lobe_with(form, LobeWeight::Factor::f0) >= 0 && lobe_with(form, LobeWeight::Factor::rest) >= 0;
  if (specular >= 0) {
    term_.weights[0][std::size_t(specular)] = 1;
    if (diffuse >= 0) term_.weights[0][std::size_t(diffuse)] = 0;
    if (const int f0 = form.weight_index(Role::f0); f0 >= 0) term_.weights[0][std::size_t(f0)] = 1;
  }
  for (const auto& roles : kAxisRoles)
    for (const Role role : roles)
      if (const int k = form.shape_index(role); k >= 0) widths_.push_back(std::size_t(k));
  // Shaders and forms of other conventions have the root itself.
  if (widths_.empty()) root_ = form.shape_index("roughness");
  if (kind == TableKind::dfg && splits_) {
    channels_ =
        bias_first ? std::vector<std::string>{"bias", "white"} : std::vector<std::string>{"scale", "bias"};
    content_ = "split sum of " + lobe_name() +
               (bias_first ? ": albedo = (1 - f0) bias + f0 white" : ": albedo = f0 scale + bias");
  } else {
    channels_ = {"albedo"};
    content_ = "directional albedo of " + lobe_name() + (specular >= 0 && splits_ ? " with f0 = 1" : "");
  }
}

std::string TableFunction::lobe_name() const {
  const ReflectanceInfo& form = info(term_.form);
  const std::string name(form.name);
  return form.weight_index(Role::specular) >= 0 ? "the lobe of " + name : name;
}

Term TableFunction::at_alpha(double alpha) const {
  Term term = term_;
  const ReflectanceInfo& form = info(term.form);
  for (const std::size_t k : widths_) {
    const ParameterInfo& p = form.shape[k];
    const bool exponent = p.role == Role::exponent || p.role == Role::exponent_across;
    // Equal peaks of the distributions (Walter et al. 2007).
    const double value = exponent ? 2 / std::max(alpha * alpha, 1e-12) - 2 : alpha;
    term.shape[0][k] = std::clamp(value, p.min, p.max);
  }
  if (root_ >= 0) {
    const ParameterInfo& p = form.shape[std::size_t(root_)];
    term.shape[0][std::size_t(root_)] = std::clamp(std::sqrt(alpha), p.min, p.max);
  }
  return term;
}

TableFunction::Values TableFunction::directional(double cosine, double alpha) const {
  const Term term = at_alpha(alpha);
  const ReflectanceInfo& form = info(term.form);
  const Angle theta = angle_of_cosine(cosine);
  Values out;
  if (kind_ == TableKind::albedo || !splits_) {
    const AlbedoResult r = converged_or_bisected(
        [&](const AlbedoOptions& o) { return std::vector{directional_albedo(term, 0, theta, {}, o)}; })[0];
    return {{r.value}, r.error_bound, r.converged};
  }
  const auto lobes = converged_or_bisected(
      [&](const AlbedoOptions& o) { return lobe_albedos(term.form, term.shape[0], theta, {}, o); });
  const AlbedoResult &white = lobes[std::size_t(lobe_with(form, LobeWeight::Factor::f0))],
                     &bias = lobes[std::size_t(lobe_with(form, LobeWeight::Factor::rest))];
  out.converged = white.converged && bias.converged;
  out.bound = white.error_bound + (bias_first_ ? 0 : bias.error_bound);
  out.values = bias_first_ ? std::vector<double>{bias.value, white.value}
                           : std::vector<double>{white.value - bias.value, bias.value};
  return out;
}

TableFunction::Values TableFunction::mean(double alpha) const {
  AlbedoOptions options = kOfTables;
  options.tolerance = 1e-5;
  const AlbedoResult r = average_albedo(at_alpha(alpha), 0, options);
  return {{r.value}, r.error_bound, r.converged};
}

LookupTable lookup_table(const Material& material, TableKind kind, const TableLayout& layout) {
  const TableFunction function(material, kind, layout.bias_first);
  LookupTable table{&layout, size_of(layout.x, function), size_of(layout.y, function), function.channels()};
  table.content = function.content();
  const std::size_t directional = table.channels.size(), count = table.width * table.height;
  if (kind == TableKind::albedo) table.channels.push_back("mean");
  table.texels.assign(table.channels.size(), std::vector<double>(count));
  std::vector<double> bounds(count);
  std::vector<char> converged(count, 1);
  const bool first = is_of_cosine(layout.x);
  const auto place_of = [&](std::size_t x, std::size_t y) {
    return place_at(layout, layout.x.computed_at(x), layout.y.computed_at(y));
  };
  io::parallel_for(count, [&](std::size_t k) {
    const std::size_t x = k % table.width, y = k / table.width;
    const TablePlace place = place_of(x, y);
    const TableFunction::Values at = function.directional(place.cosine, place.alpha);
    for (std::size_t c = 0; c < directional; ++c) table.texels[c][k] = at.values[c];
    bounds[k] = at.bound;
    converged[k] = char(at.converged);
  });
  if (kind == TableKind::albedo) {
    const std::size_t rows = first ? table.height : table.width, along = first ? table.width : table.height;
    io::parallel_for(rows, [&](std::size_t r) {
      const TableFunction::Values mean = function.mean(place_of(first ? 0 : r, first ? r : 0).alpha);
      for (std::size_t k = 0; k < along; ++k) {
        const std::size_t texel = first ? r * table.width + k : k * table.width + r;
        table.texels[directional][texel] = mean.values[0];
        bounds[texel] = std::max(bounds[texel], mean.bound);
        converged[texel] = char(converged[texel] && mean.converged);
      }
    });
  }
  table.texel_bound = *std::ranges::max_element(bounds);
  table.not_converged = std::size_t(std::ranges::count(converged, 0));
  for (const std::vector<double>& plane : table.texels)
    for (const double value : plane)
      table.rounding = std::max(table.rounding, std::abs(stored(value, layout.format) - value));
  search_reading(table, function);
  return table;
}

std::vector<std::string> sentences(const LookupTable& table) {
  const TableLayout& layout = *table.layout;
  const auto axis = [](const TableAxis& a) -> std::string {
    const std::string quantity = a.quantity == TableQuantity::cosine           ? "cos(theta)"
                                 : a.quantity == TableQuantity::cosine_of_root ? "sqrt(cos(theta))"
                                 : a.quantity == TableQuantity::roughness      ? "roughness = sqrt(alpha)"
                                                                               : "alpha";
    return quantity +
           (a.rule == TexelRule::ends ? " with 0 and 1 at the outer texels" : " at texel centres") +
           (a.descending ? ", 1 at the first row" : "") +
           (a.shift != 0 ? ", computed " + io::short_number(a.shift) + " texel beyond" : "");
  };
  std::vector<std::string> out;
  out.push_back(std::to_string(table.width) + " x " + std::to_string(table.height) + " texels for " +
                std::string(layout.title) + "; " + table.content);
  out.push_back("x: " + axis(layout.x) + "; y: " + axis(layout.y) +
                "; channels: " + io::joined(table.channels));
  if (!layout.supposed.empty()) out.push_back("supposed, not checked: " + std::string(layout.supposed));
  const std::string integrated =
      table.not_converged > 0
          ? "the integrals of " + std::to_string(table.not_converged) + " did not converge"
          : "integrated within " + io::short_number(table.texel_bound, 2);
  out.push_back("texels: " + integrated + "; as " + std::string(name_of_format(layout.format)) +
                " rounded by at most " + io::short_number(table.rounding, 2));
  if (table.reading.unknown > 0)
    out.push_back("bilinear reading: unknown at " + std::to_string(table.reading.unknown) +
                  " places of the search: their integrals did not converge");
  if (table.reading.difference < 0) return out;
  out.push_back(
      "bilinear reading: largest difference from the integral at least " +
      io::short_number(table.reading.difference, 3) + ", found by a search: " + table.reading.channel +
      " is read as " + io::short_number(table.reading.read, 5) + " instead of " +
      io::short_number(table.reading.integral, 5) + " at cos(theta) " +
      io::short_number(table.reading.cosine) + ", roughness " + io::short_number(table.reading.roughness));
  return out;
}

io::Json to_json(const LookupTable& table) {
  const ReadingError& r = table.reading;
  return {{"layout", table.layout->name},
          {"width", table.width},
          {"height", table.height},
          {"channels", table.channels},
          {"content", table.content},
          {"texel_bound", table.not_converged > 0 ? io::Json() : io::Json(table.texel_bound)},
          {"not_converged", table.not_converged},
          {"format", name_of_format(table.layout->format)},
          {"rounding", table.rounding},
          {"reading",
           {{"largest", r.difference < 0 ? io::Json() : io::Json(r.difference)},
            {"largest_is", "at least"},
            {"unknown", r.unknown},
            {"cosine", r.cosine},
            {"roughness", r.roughness},
            {"channel", r.channel},
            {"read", r.read},
            {"integral", r.integral}}},
          {"supposed", table.layout->supposed}};
}

}  // namespace brdf::interop
