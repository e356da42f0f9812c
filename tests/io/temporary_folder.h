// A folder of its own for one test, so that tests may run side by side.
#pragma once

#include "io/temporary_folder.h"

namespace brdf {

using io::TemporaryFolder;

}  // namespace brdf
