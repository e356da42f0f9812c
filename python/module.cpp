// The extension behind `import brdf`, which exposes the functions of the C++ libraries unchanged. The public
// interface is in python/brdf.
#include <filesystem>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "python/binding.h"
#include "python/waiting.h"
#ifdef BRDF_HAS_SHADER
#include "shader/material_form.h"
#endif

namespace brdf::python {
namespace {

// Maps the library's exceptions to Python classes with the same message.
void bind_errors(py::module_& module) {
  static const py::handle input = PyErr_NewException("brdf.InputError", PyExc_ValueError, nullptr);
  static const py::handle environment = PyErr_NewException("brdf.EnvironmentError", PyExc_OSError, nullptr);
  static const py::handle stopped = PyErr_NewException("brdf.Stopped", PyExc_RuntimeError, nullptr);
  module.attr("InputError") = input;
  module.attr("EnvironmentError") = environment;
  module.attr("Stopped") = stopped;
  py::register_exception_translator([](std::exception_ptr thrown) {
    const auto raise = [](const py::handle& type, const std::string& text) {
      PyErr_SetString(type.ptr(), io::printable(text).c_str());
    };
    try {
      std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise(input, error.what());
    } catch (const EnvironmentError& error) {
      raise(environment, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
      raise(io::is_of_the_name(error.code().value()) ? input : environment, io::cannot_be_used(error));
    } catch (const Stopped&) {
      raise(stopped, "stopped by its progress callback");
    }
  });
}

}  // namespace
}  // namespace brdf::python

PYBIND11_MODULE(_brdf, module) {
  using namespace brdf::python;
  module.attr("version") = BRDF_VERSION;
  bind_errors(module);
#ifdef BRDF_HAS_SHADER
  brdf::shader::use_in_materials();
#endif
  bind_samples(module);
  bind_materials(module);
  bind_sampling(module);
  bind_fits(module);
  bind_judgements(module);
}
