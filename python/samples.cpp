// Tables of samples: read from files, made from arrays, and returned as arrays.
#include <limits>
#include <sstream>

#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/formats/any_table.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "io/samples/table_rules.h"
#include "python/binding.h"
#include "sheet/data_sheet.h"
#include "synth/instrument.h"

namespace brdf::python {
namespace {

using Column = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> to_vector(const Column& column) {
  return {column.data(), column.data() + column.size()};
}

// Returns a read-only view of a column. The view keeps the table alive.
py::array_t<double> view(const py::object& owner, const std::vector<double>& column) {
  py::array_t<double> array(py::ssize_t(column.size()), column.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

const io::SampleTable& table_of(const py::object& self) {
  return self.cast<const Samples&>().table();
}

std::size_t channel_index(const io::SampleTable& table, std::size_t channel) {
  if (channel >= table.channels.size()) throw py::index_error("no such channel");
  return channel;
}

// Returns columns as an array (rows, channels), with NaN for channels that have no column.
py::array_t<double> rows_of(const io::SampleTable& table, const std::vector<std::vector<double>>& columns) {
  const std::size_t rows = table.rows(), count = table.channels.size();
  py::array_t<double> out({rows, count});
  auto at = out.mutable_unchecked<2>();
  for (std::size_t c = 0; c < count; ++c)
    for (std::size_t k = 0; k < rows; ++k)
      at(py::ssize_t(k), py::ssize_t(c)) = c < columns.size() && !columns[c].empty()
                                               ? columns[c][k]
                                               : std::numeric_limits<double>::quiet_NaN();
  return out;
}

// Returns the unit vectors (rows, 3) of one of the two directions.
py::array_t<double> vectors_of(const std::vector<double>& theta, const std::vector<double>& phi) {
  py::array_t<double> out({theta.size(), std::size_t{3}});
  auto at = out.mutable_unchecked<2>();
  for (std::size_t k = 0; k < theta.size(); ++k) {
    const Vec3<double> w = io::unit_vector(theta[k], phi[k]);
    const double xyz[] = {w.x, w.y, w.z};
    for (py::ssize_t d = 0; d < 3; ++d) at(py::ssize_t(k), d) = xyz[d];
  }
  return out;
}

Samples from_arrays(const std::array<Column, 4>& angles, const std::vector<Column>& values,
                    const std::vector<std::optional<Column>>& sigma, std::vector<std::string> channels,
                    const std::vector<io::Comment>& metadata) {
  io::SampleTable table;
  table.theta_i = to_vector(angles[0]);
  table.phi_i = to_vector(angles[1]);
  table.theta_o = to_vector(angles[2]);
  table.phi_o = to_vector(angles[3]);
  table.channels = std::move(channels);
  for (const Column& column : values) table.values.push_back(to_vector(column));
  for (const auto& column : sigma) table.sigma.push_back(column ? to_vector(*column) : std::vector<double>{});
  for (const auto& [key, value] : metadata) table.add_comment(key, value);
  table.format = "arrays";
  for (const auto* columns : {&table.values, &table.sigma})
    for (const std::vector<double>& column : *columns)
      if (!column.empty() && column.size() != table.rows()) throw py::value_error("columns of other lengths");
  io::check_table(table);
  return Samples(std::move(table));
}

// Returns the angles of directions, which may have any length.
py::tuple angles_of(const Column& vectors) {
  const py::ssize_t count = vectors.shape(0);
  py::array_t<double> theta(count), phi(count);
  for (py::ssize_t k = 0; k < count; ++k) {
    const double* const w = vectors.data() + 3 * k;
    const io::Polar at = io::polar_degrees({w[0], w[1], w[2]});
    theta.mutable_data()[k] = at.theta;
    phi.mutable_data()[k] = at.phi;
  }
  return py::make_tuple(theta, phi);
}

std::string to_csv(const Samples& samples) {
  std::ostringstream out;
  io::write_samples(out, samples.table());
  return out.str();
}

// Reads a table without holding the interpreter's lock.
template <class Read>
Samples read(Read&& make) {
  const py::gil_scoped_release unlocked;
  return Samples(make());
}

}  // namespace

void bind_samples(py::module_& module) {
  py::class_<Samples> samples(module, "Samples");
  samples.def_property_readonly("theta_i", [](const py::object& s) { return view(s, table_of(s).theta_i); })
      .def_property_readonly("phi_i", [](const py::object& s) { return view(s, table_of(s).phi_i); })
      .def_property_readonly("theta_o", [](const py::object& s) { return view(s, table_of(s).theta_o); })
      .def_property_readonly("phi_o", [](const py::object& s) { return view(s, table_of(s).phi_o); })
      .def("column", [](const py::object& s,
                        std::size_t c) { return view(s, table_of(s).values[channel_index(table_of(s), c)]); })
      .def("has_sigma", [](const Samples& s, std::size_t c) { return s.table().has_sigma(c); })
      .def_property_readonly("values", [](const Samples& s) { return rows_of(s.table(), s.table().values); })
      .def_property_readonly("sigma", [](const Samples& s) { return rows_of(s.table(), s.table().sigma); })
      .def_property_readonly("wi",
                             [](const Samples& s) { return vectors_of(s.table().theta_i, s.table().phi_i); })
      .def_property_readonly("wo",
                             [](const Samples& s) { return vectors_of(s.table().theta_o, s.table().phi_o); })
      .def_property_readonly("rows", [](const Samples& s) { return s.table().rows(); })
      .def_property_readonly("channels", [](const Samples& s) { return s.table().channels; })
      .def_property_readonly("metadata", [](const Samples& s) { return s.table().metadata; })
      .def_property_readonly("source", [](const Samples& s) { return s.table().source; })
      .def_property_readonly("format", [](const Samples& s) { return s.table().format; })
      .def_property_readonly("warnings", [](const Samples& s) { return s.table().warnings; })
      .def("csv", &to_csv)
      .def("arranged",
           [](const Samples& s, const std::string& polarisation, const std::string& repeats) {
             io::SampleTable table = s.table();
             io::arrange(table, arrangement_of(polarisation, repeats));
             return Samples(std::move(table));
           })
      .def("measured",
           [](const Samples& s) {
             const py::gil_scoped_release unlocked;
             io::SampleTable table = s.table();
             sheet::leave_out(sheet::not_measured(table), table);
             return Samples(std::move(table));
           })
      .def("write", [](const Samples& s, const std::string& path) {
        const py::gil_scoped_release unlocked;
        return io::write_table(path, s.table());
      });
  module.def("read", [](const std::string& path, const std::string& quantity, const std::string& mirror_side,
                        const std::string& layout, const std::string& matrix) {
    return read([&] { return io::read_samples(path, supplied_of(quantity, mirror_side, layout, matrix)); });
  });
  module.def("read_text", [](const std::string& text, const std::string& name, const std::string& quantity,
                             const std::string& mirror_side, const std::string& layout) {
    return read([&] {
      return io::read_samples(io::Content{name, text}, supplied_of(quantity, mirror_side, layout));
    });
  });
  module.def("read_directions",
             [](const std::string& path) { return read([&] { return io::read_directions(path); }); });
  module.def("table_of_file",
             [](const std::string& path, const std::string& quantity, const std::string& mirror_side,
                const std::string& layout, const std::string& matrix, const std::string& output) {
               return read([&] {
                 return synth::table_of_file(path, supplied_of(quantity, mirror_side, layout, matrix),
                                             synth::cells_for(output));
               });
             });
  module.def("check_table_format", [](const std::string& path) { io::check_table_format(path); });
  module.def("from_arrays", &from_arrays);
  module.def("angles_of", &angles_of);
  module.def("unit_vectors", [](const Column& theta, const Column& phi) {
    return vectors_of(to_vector(theta), to_vector(phi));
  });
}

}  // namespace brdf::python
