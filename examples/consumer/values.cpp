// values MATERIAL.json DIRECTIONS.csv: f_r of a fitted material, a row for each pair of directions and a
// column for each channel. The numbers equal the output of `brdf eval MATERIAL.json DIRECTIONS.csv`.
#include <cstdio>
#include <exception>
#include <vector>

#include "brdf/io/formats/read.h"
#include "brdf/io/material/material_file.h"
#include "brdf/io/samples/samples.h"

int main(int argc, char** argv) try {
  if (argc != 3) return std::fprintf(stderr, "usage: values MATERIAL.json DIRECTIONS.csv\n"), 2;
  const brdf::Material material = brdf::io::read_material(argv[1]);
  const brdf::DirectionArrays<double> arrays = brdf::io::unit_directions(brdf::io::read_directions(argv[2]));
  const brdf::Directions<double> directions = arrays.view();
  std::vector<double> values(material.channels.size());
  for (std::size_t k = 0; k < directions.count; ++k) {
    eval(material, directions.wi(k), directions.wo(k), values);
    for (std::size_t c = 0; c < values.size(); ++c)
      std::printf("%.17g%c", values[c], c + 1 < values.size() ? ',' : '\n');
  }
  return 0;
} catch (const std::exception& error) {  // brdf::InputError: file, line or JSON path, value, rule
  return std::fprintf(stderr, "values: %s\n", error.what()), 2;
}
