#pragma once

#include "io/samples.h"

namespace brdf::io {

// The project's own sample table; `need_values` refuses a table of mere directions.
SampleTable read_csv(const Content& text, bool need_values);

}  // namespace brdf::io
