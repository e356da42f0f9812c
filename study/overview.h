// Writes the overview page, which links to the pages of many samples.
#pragma once

#include <filesystem>
#include <vector>

#include "study/study.h"

namespace brdf::study {

// Writes index.html and study.json into the folder. `against`: the older study that the rows were compared
// with; empty: the earlier results in the folder.
void write_overview(const std::vector<Row>& rows, const std::filesystem::path& folder,
                    const std::filesystem::path& against = {});

}  // namespace brdf::study
