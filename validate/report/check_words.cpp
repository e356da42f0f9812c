#include "validate/report/check_words.h"

#include <algorithm>
#include <iterator>

#include "sheet/data_sheet.h"
#include "validate/form/checks.h"

namespace brdf::validate {

std::string_view check_meaning(std::string_view check) {
  const auto* const found = std::ranges::find(kChecks, check, &Check::name);
  return found == std::end(kChecks) ? sheet::check_meaning(check) : found->meaning;
}

}  // namespace brdf::validate
