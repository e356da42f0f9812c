#include "cli/steps/fit_files.h"

#include <algorithm>
#include <iostream>

#include "cli/options/next_step.h"
#include "io/files/json.h"
#include "io/files/text.h"

namespace brdf::cli {

Exit summarise(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder, bool json) {
  fit::write_summary(rows, folder);
  const bool good = std::ranges::all_of(rows, [](const fit::BatchRow& row) { return fit::usable(row); });
  const std::string page = (folder / "summary.html").string();
  if (json) {
    std::cout << io::to_text(fit::to_json(rows, folder));
  } else {
    std::cout << io::printable((folder / "summary.csv").string()) << ", " << io::printable(page) << '\n';
    print_next_step({open_page(page)});
  }
  if (std::ranges::any_of(rows, &fit::BatchRow::environment_failed)) return Exit::environment;
  return good ? Exit::good : Exit::failed;
}

}  // namespace brdf::cli
