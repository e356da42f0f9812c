// Declarations shared by the files of the extension.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>

#include "io/columns/stated_quantity.h"
#include "io/columns/supplied.h"
#include "io/files/error.h"
#include "io/material/material_json.h"
#include "io/samples/arrange.h"
#include "io/samples/samples.h"

namespace brdf::python {

namespace py = pybind11;

// The values that Python objects hold. Operations return new objects. A table is shared with the fits made
// from it.
struct Samples {
  std::shared_ptr<const io::SampleTable> held;

  explicit Samples(io::SampleTable table) : held(std::make_shared<io::SampleTable>(std::move(table))) {}
  const io::SampleTable& table() const { return *held; }
};
struct Optics {
  io::MaterialFile file;
};

// Parses the word of an option. Throws InputError if the word is unknown.
template <class Enum>
Enum named(const char* option, const std::string& word) {
  const auto found = find_named<Enum>(word);
  if (!found) throw InputError(std::string(option) + " " + word + ": must be one of " + known_names<Enum>());
  return *found;
}

inline io::Arrangement arrangement_of(const std::string& polarisation, const std::string& repeats) {
  return {named<io::Polarisation>("--polarisation", polarisation), named<io::Repeats>("--repeats", repeats)};
}

// Returns the supplied facts. If nothing is supplied, `quantity` and `layout` are empty and `mirror_side` is
// "auto".
inline io::Supplied supplied_of(const std::string& quantity, const std::string& mirror_side,
                                const std::string& layout, const std::string& matrix = "") {
  io::stated_by_option(quantity);  // throws before any file is read
  io::Supplied supplied{quantity, named<io::MirrorSide>("--mirror-side", mirror_side), false, layout};
  supplied.matrix = matrix;
  return supplied;
}

void bind_samples(py::module_& module);
void bind_materials(py::module_& module);
void bind_sampling(py::module_& module);
void bind_fits(py::module_& module);
void bind_judgements(py::module_& module);

}  // namespace brdf::python
