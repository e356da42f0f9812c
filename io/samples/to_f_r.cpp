#include "io/samples/to_f_r.h"

#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/fill_values.h"

namespace brdf::io {
namespace {

// Returns the numbers of the rows in which every cosine of a divisor is above 0.
std::vector<std::size_t> defined_rows(const SampleTable& table, bool by_light, bool by_viewer) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (!(by_light && cos_degrees(table.theta_i[k]) <= 0) &&
        !(by_viewer && cos_degrees(table.theta_o[k]) <= 0))
      rows.push_back(k);
  return rows;
}

[[noreturn]] void refuse(const SampleTable& table, std::size_t row, const Quantity& quantity, double value) {
  const bool is_one_cosine = quantity.kind->divisor == 1 && quantity.factor == 1 &&
                             quantity.scale == Quantity::Scale::linear &&
                             quantity.kind->cos_i + quantity.kind->cos_o == 1;
  const double cosine = cos_degrees(quantity.kind->cos_i == 1 ? table.theta_i[row] : table.theta_o[row]);
  throw InputError(table.where(row) + ": " + to_text(value) +
                   (is_one_cosine
                        ? " divided by the cosine " + to_text(cosine) + " exceeds the range of numbers"
                        : ": f_r, " + quantity.operation() + ", exceeds the range of numbers"));
}

}  // namespace

void keep_rows(SampleTable& table, const std::vector<std::size_t>& rows) {
  const auto keep = [&](auto& column) {
    if (column.empty()) return;
    for (std::size_t k = 0; k < rows.size(); ++k) column[k] = column[rows[k]];
    column.resize(rows.size());
  };
  for (auto* angle : {&table.theta_i, &table.phi_i, &table.theta_o, &table.phi_o}) keep(*angle);
  for (auto* columns : {&table.values, &table.sigma})
    for (auto& column : *columns) keep(column);
  keep(table.lines);
}

void make_f_r(SampleTable& table, const std::vector<Quantity>& quantities) {
  refuse_fill_values(table);
  bool by_light = false, by_viewer = false;
  for (const Quantity& q : quantities) {
    by_light = by_light || q.kind->cos_i > 0;
    by_viewer = by_viewer || q.kind->cos_o > 0;
  }
  if (by_light || by_viewer) {
    const std::vector<std::size_t> rows = defined_rows(table, by_light, by_viewer);
    const std::size_t undefined = table.rows() - rows.size();
    if (undefined > 0) {
      keep_rows(table, rows);
      table.skipped += undefined;
      table.warnings.push_back(plural(undefined, "row") +
                               " left out: f_r is undefined if the cosine of the quantity is 0");
    }
    if (table.rows() == 0) throw InputError(table.name() + ": has no rows in which f_r is defined");
  }
  for (std::size_t c = 0; c < quantities.size(); ++c) {
    const Quantity& q = quantities[c];
    if (q.is_f_r()) continue;
    for (std::size_t k = 0; k < table.rows(); ++k) {
      const double cos_i = by_light ? cos_degrees(table.theta_i[k]) : 1;
      const double cos_o = by_viewer ? cos_degrees(table.theta_o[k]) : 1;
      const double value = table.values[c][k];
      if (table.has_sigma(c)) table.sigma[c][k] = q.sigma(value, table.sigma[c][k], cos_i, cos_o);
      table.values[c][k] = q.f_r(value, cos_i, cos_o);
      if (!std::isfinite(table.values[c][k])) refuse(table, k, q, value);
    }
  }
}

}  // namespace brdf::io
