// The page that leads to many samples' pages.
#pragma once

#include <filesystem>
#include <vector>

#include "study/study.h"

namespace brdf::study {

// index.html and study.json in the folder.
void write_overview(const std::vector<Row>& rows, const std::filesystem::path& folder);

}  // namespace brdf::study
