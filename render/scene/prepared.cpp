#include "render/scene/prepared.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/error.h"

namespace brdf::render {
namespace {

constexpr std::size_t kMostWeights = 3, kMostShapes = 3;  // what the targets have room for

void set_roles(Item& item, const ReflectanceInfo& form, const TextureSet& textures) {
  const bool albedo = bool(textures[0]), roughness = bool(textures[2]), metallic = bool(textures[3]);
  const bool has_f0 = form.weight_index("f0") >= 0;
  for (std::size_t k = 0; k < form.weights.size(); ++k) {
    const Role role = role_of(form.weights[k].name, has_f0);
    const bool driven = metallic || (albedo && (role == Role::reflectance || role == Role::diffuse));
    if (driven) item.weight_roles[k] = role;
  }
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const Role role = role_of(form.shape[k].name, has_f0);
    if (role == Role::metallic ? metallic : roughness) item.shape_roles[k] = role;
  }
}

// `channel` -1: all channels with the shared shape; otherwise that channel alone, the others' weights zero.
Item make_item(const Term& term, std::size_t channels, int channel, const TextureSet& textures) {
  Item item;
  item.form = catalogue_index(term.form);
  item.cos_turn = float(std::cos(term.tangent_phi.radians()));
  item.sin_turn = float(std::sin(term.tangent_phi.radians()));
  const auto shape = term.shape_of(channel < 0 ? 0 : std::size_t(channel));
  for (std::size_t k = 0; k < shape.size(); ++k) item.shape[k] = float(shape[k]);
  for (int c = 0; c < 3; ++c) {
    if (channel >= 0 && c != channel) continue;
    const std::vector<double>& weights = term.weights[channels == 1 ? 0 : std::size_t(c)];
    for (std::size_t k = 0; k < weights.size(); ++k) item.weights[k][c] = float(weights[k]);
  }
  set_roles(item, info(term.form), textures);
  return item;
}

std::vector<Item> items_of(const Object& object, const TextureSet& textures) {
  std::vector<Item> items;
  const std::size_t channels = object.material.channels.size();
  if (channels != 1 && channels != 3) {
    throw InputError("material " + object.material_name + " has " + std::to_string(channels) +
                     " channels; the renderer takes 1 or 3");
  }
  for (const Term& term : object.material.terms) {
    const ReflectanceInfo& form = info(term.form);
    if (form.weights.size() > kMostWeights || form.shape.size() > kMostShapes) {
      throw InputError("material " + object.material_name +
                       ": the renderer has room for three weights per channel and "
                       "three shape parameters, " +
                       std::string(form.name) + " has more");
    }
    if (term.shape.size() <= 1) {
      items.push_back(make_item(term, channels, -1, textures));
      continue;
    }
    if (!info(term.form).fittable()) {
      throw InputError("material " + object.material_name + ": shapes per channel of " +
                       std::string(info(term.form).name) + ", which mixes channels, cannot be rendered");
    }
    for (int channel = 0; channel < int(channels); ++channel) {
      items.push_back(make_item(term, channels, channel, textures));
    }
  }
  return items;
}

}  // namespace

void update_items(PreparedScene& prepared) {
  const std::vector<Object>& objects = prepared.scene.objects;
  std::vector<std::vector<Item>> items;
  std::size_t layers = 1;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    items.push_back(items_of(objects[k], prepared.textures[k]));
    layers = std::max(layers, items.back().size());
  }
  prepared.layers.assign(layers, {});
  glm::vec3 low(1e30f), high(-1e30f);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const glm::vec4 bound = bounding_sphere(*prepared.meshes[k]);
    items[k].resize(layers);
    for (std::size_t layer = 0; layer < layers; ++layer) {
      Item& item = items[k][layer];
      item.object = k;
      item.linear = linear_part(objects[k]);
      item.normals = glm::transpose(glm::inverse(item.linear));
      item.origin = objects[k].position;
      const float stretch =
          std::max({glm::length(item.linear[0]), glm::length(item.linear[1]), glm::length(item.linear[2])});
      item.extent = stretch * (glm::length(glm::vec3(bound)) + bound.w);
      prepared.layers[layer].push_back(item);
      const glm::vec3 center = item.origin + item.linear * glm::vec3(bound);
      low = glm::min(low, center - stretch * bound.w);
      high = glm::max(high, center + stretch * bound.w);
    }
  }
  prepared.bounds = glm::vec4((low + high) / 2.0f, glm::length(high - low) / 2);
}

PreparedScene prepare(Scene scene) {
  PreparedScene prepared;
  std::map<std::string, std::shared_ptr<const Mesh>> known;
  for (const Object& object : scene.objects) {
    std::shared_ptr<const Mesh>& mesh = known[object.mesh];
    if (!mesh) mesh = std::make_shared<const Mesh>(make_mesh(object.mesh, scene.folder));
    prepared.meshes.push_back(mesh);
    TextureSet textures;
    for (std::size_t slot = 0; slot < 4; ++slot) {
      if (object.textures[slot])
        textures[slot] = std::make_shared<const Texture>(load_texture(scene.folder / *object.textures[slot]));
    }
    prepared.textures.push_back(std::move(textures));
  }
  prepared.scene = std::move(scene);
  update_items(prepared);
  return prepared;
}

}  // namespace brdf::render
