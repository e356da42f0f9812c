#pragma once

#include "io/samples.h"

namespace brdf::io {

// Tables of columns of text; `need_values` refuses a table of mere directions.
SampleTable read_csv(const Content& text, bool need_values, const Supplied& supplied);

}  // namespace brdf::io
