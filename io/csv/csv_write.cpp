#include "io/csv/csv.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "io/columns/plain_names.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
namespace {

// Writes nan without a sign, because the sign of a value that is not a number has no meaning.
void append_value(std::string& text, double value) {
  if (std::isnan(value))
    text += "nan";
  else
    append_number(text, value);
}

}  // namespace

void write_samples(std::ostream& out, const SampleTable& table, std::string_view quantity, Origin origin) {
  check_table(table, origin);
  std::string text;
  for (const Comment& comment : table.metadata) text += "# " + comment_text(comment) + '\n';
  (((text += "# ") += kQuantityKey) += ": ") += quantity;
  text += '\n';
  for (const std::string_view angle : kAngleNames) (text += angle) += ',';
  for (const std::string& channel : table.channels) (text += channel) += ',';
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (table.has_sigma(c)) ((text += kSigmaPrefix) += table.channels[c]) += ',';
  text.back() = '\n';
  for (std::size_t k = 0; k < table.rows(); ++k) {
    for (const double angle : {table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]}) {
      append_number(text, angle);
      text += ',';
    }
    for (const auto& column : table.values) {
      append_value(text, column[k]);
      text += ',';
    }
    for (const auto& column : table.sigma) {
      if (column.empty()) continue;
      append_number(text, column[k]);
      text += ',';
    }
    text.back() = '\n';
    if (text.size() > (1 << 16)) {
      out.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void write_samples(const std::filesystem::path& path, const SampleTable& table, std::string_view quantity,
                   Origin origin) {
  const auto write = [&](const SampleTable& written) {
    write_file_atomically(path, [&](std::ostream& out) { write_samples(out, written, quantity, origin); });
  };
  const std::filesystem::path folder = is_standard_output(path) ? "" : path.parent_path();
  const std::optional<std::string> budget = budget_comment_in(folder, table);
  if (!budget || budget == table.find_metadata(kBudgetKey)) return write(table);
  SampleTable moved = table;  // to another folder
  std::ranges::find(moved.metadata, kBudgetKey, &Comment::first)->second = *budget;
  write(moved);
}

}  // namespace brdf::io
