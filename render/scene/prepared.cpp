#include "render/scene/prepared.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/colour/in_colour.h"
#include "io/files/error.h"

namespace brdf::render {
namespace {

const Texture* map_of(const TextureSet& textures, TextureSlot slot) {
  return textures[std::size_t(slot)].get();
}

void set_rules(Item& item, const ReflectanceInfo& form, const TextureSet& textures) {
  const bool albedo = map_of(textures, TextureSlot::albedo),
             roughness = map_of(textures, TextureSlot::roughness),
             metallic = map_of(textures, TextureSlot::metallic);
  for (const ParameterInfo& p : form.weights) {
    const Rule rule = rule_of(p, form);
    const bool driven = metallic || (albedo && (rule == Rule::albedo || rule == Rule::diffuse));
    item.weight_rules.push_back(driven ? rule : Rule::own);
  }
  for (const ParameterInfo& p : form.shape) {
    const Rule rule = rule_of(p, form);
    item.shape_rules.push_back((rule == Rule::metallic ? metallic : roughness) ? rule : Rule::own);
  }
}

// `only`: makes an item for this colour alone, with zero weights for the others; otherwise for all colours
// with the shared shape.
Item make_item(const Term& term, const io::ChannelColours& colours, std::optional<std::size_t> only,
               const TextureSet& textures) {
  Item item;
  item.form = term.form;
  item.cos_turn = float(std::cos(term.tangent_phi.radians()));
  item.sin_turn = float(std::sin(term.tangent_phi.radians()));
  for (const double value : term.shape_of(colours.of[only.value_or(0)])) item.shape.push_back(float(value));
  item.channels = colours.of;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const double value : term.weights[item.channels[c]])
      item.weights[c].push_back(only.value_or(c) == c ? float(value) : 0);
  }
  set_rules(item, info(term.form), textures);
  return item;
}

std::vector<Item> items_of(const Object& object, const TextureSet& textures) {
  std::vector<Item> items;
  const Material material = io::in_colour(object.material);
  const io::ChannelColours colours = require_colours(material.channels, "material " + object.material_name);
  for (const Term& term : material.terms) {
    io::require_red_first(term, colours);
    if (term.shape.size() <= 1) {
      items.push_back(make_item(term, colours, std::nullopt, textures));
      continue;
    }
    if (info(term.form).mixes_channels) {
      throw InputError("material " + object.material_name + ": shapes per channel of " +
                       std::string(info(term.form).name) +
                       ", a form that combines channels, cannot be rendered");
    }
    for (std::size_t colour = 0; colour < 3; ++colour)
      items.push_back(make_item(term, colours, colour, textures));
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
  PointBox box;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const MeshBounds& mesh = prepared.mesh_bounds[k];
    const glm::vec4 bound = mesh.sphere;
    items[k].resize(layers);
    for (std::size_t layer = 0; layer < layers; ++layer) {
      Item& item = items[k][layer];
      item.object = k;
      item.linear = linear_part(objects[k]);
      item.normals = glm::transpose(glm::inverse(item.linear));
      item.origin = objects[k].position;
      item.low = mesh.low;
      item.high = mesh.high;
      const float stretch =
          std::max({glm::length(item.linear[0]), glm::length(item.linear[1]), glm::length(item.linear[2])});
      item.extent = stretch * (glm::length(glm::vec3(bound)) + bound.w);
      prepared.layers[layer].push_back(item);
      const glm::vec3 center = item.origin + item.linear * glm::vec3(bound);
      box.add(center - stretch * bound.w);
      box.add(center + stretch * bound.w);
    }
  }
  prepared.bounds = glm::vec4((box.low + box.high) / 2.0f, glm::length(box.size()) / 2);
}

namespace {

LightMap light_map(const Scene& scene) {
  if (const auto formula = find_named<Formula>(scene.environment->picture)) return light_map_of(*formula);
  return load_light_map(scene.folder / scene.environment->picture);
}

[[noreturn]] void refuse(std::size_t object, const std::string& what, std::size_t most) {
  throw InputError("$.objects[" + std::to_string(object) + "]: with this object the scene has more than " +
                   std::to_string(most) + " " + what);
}

}  // namespace

PreparedScene prepare(Scene scene) {
  PreparedScene prepared;
  std::map<std::string, std::shared_ptr<const Mesh>> meshes;
  std::size_t triangles = 0, texels = 0;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const Object& object = scene.objects[k];
    std::shared_ptr<const Mesh>& mesh = meshes[object.mesh];
    if (!mesh) mesh = std::make_shared<const Mesh>(make_mesh(object.mesh, scene.folder));
    triangles += mesh->triangles();
    if (triangles > kMostTriangles) refuse(k, "triangles", kMostTriangles);
    prepared.meshes.push_back(mesh);
    const auto [low, high] = bounding_box(*mesh);
    prepared.mesh_bounds.push_back({low, high, bounding_sphere(*mesh)});
    TextureSet textures;
    for (std::size_t slot = 0; slot < 4; ++slot) {
      if (!object.textures[slot]) continue;
      textures[slot] = std::make_shared<const Texture>(load_texture(scene.folder / *object.textures[slot]));
      texels += textures[slot]->texels.size();
      if (texels > kMostTexelsOfAll) refuse(k, "texels", kMostTexelsOfAll);
    }
    prepared.textures.push_back(std::move(textures));
  }
  if (scene.environment) prepared.environment = std::make_shared<const LightMap>(light_map(scene));
  prepared.scene = std::move(scene);
  update_items(prepared);
  return prepared;
}

}  // namespace brdf::render
