#include <algorithm>

#include "io/files/output.h"
#include "io/files/provenance.h"
#include "maps/textures/written.h"

namespace brdf::maps {
namespace {

constexpr const char* kRedGreenBlue[] = {"R", "G", "B"};

std::filesystem::path image_path(const std::filesystem::path& output, std::string_view name) {
  return output.parent_path() / (output.stem().string() + "_" + std::string(name) + ".exr");
}

}  // namespace

std::vector<std::filesystem::path> possible_files(const interop::Program& program,
                                                  const std::filesystem::path& output) {
  std::vector<std::filesystem::path> out{output};
  if (suffix_of(program) == ".glb") return out;
  for (const interop::TargetRules& rules : program.targets)
    if (const TexturedTarget* target = find_textured(info(rules.target).name))
      for (const Input& input : target->inputs)
        if (const auto path = image_path(output, input.name); std::ranges::find(out, path) == out.end())
          out.push_back(path);
  for (const char* name : {"normal", "held"}) out.push_back(image_path(output, name));
  return out;
}

std::string ImageFiles::add(std::string_view name, texel::Planes planes) {
  for (const auto& field : io::provenance_fields(io::provenance())) planes.attributes.push_back(field);
  files_.emplace_back(image_path(output_, name), std::move(planes));
  return files_.back().first.filename().string();
}

std::string ImageFiles::add(const InputMap& map) {
  texel::Planes planes{maps_.width(), maps_.height(), {}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<double>& shares = map.shares[map.shares.size() == 1 ? 0 : c];
    planes.names.emplace_back(kRedGreenBlue[c]);
    planes.values.emplace_back(shares.begin(), shares.end());
  }
  return add(map.input.name, std::move(planes));
}

std::string ImageFiles::add_normals() {
  texel::Planes planes{maps_.width(), maps_.height(), {}, {}};
  for (const auto& [name, axis] :
       {std::pair{"R", &Vec3<double>::x}, {"G", &Vec3<double>::y}, {"B", &Vec3<double>::z}}) {
    planes.names.emplace_back(name);
    std::vector<float>& values = planes.values.emplace_back();
    for (const Vec3<double>& normal : carried_.normals) values.push_back(float(0.5 + 0.5 * normal.*axis));
  }
  return add("normal", std::move(planes));
}

std::string ImageFiles::add_held() {
  texel::Planes planes{maps_.width(), maps_.height(), {}, {}};
  for (const char* name : kRedGreenBlue) {
    planes.names.emplace_back(name);
    planes.values.emplace_back(carried_.held.begin(), carried_.held.end());
  }
  return add("held", std::move(planes));
}

std::vector<std::filesystem::path> ImageFiles::write() const {
  std::vector<std::filesystem::path> paths;
  for (const auto& [path, planes] : files_) {
    texel::write_planes(path, planes);
    paths.push_back(path);
  }
  return paths;
}

}  // namespace brdf::maps
