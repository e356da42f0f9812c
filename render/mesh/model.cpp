#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>

#include "io/error.h"
#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

glm::vec3 to_glm(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

Mesh converted(const aiMesh& source, const std::string& name) {
  Mesh mesh;
  for (unsigned v = 0; v < source.mNumVertices; ++v) {
    Vertex vertex{to_glm(source.mVertices[v]), to_glm(source.mNormals[v]), glm::vec4(0, 0, 0, 1),
                  glm::vec2(0)};
    if (source.HasTextureCoords(0)) vertex.uv = glm::vec2(to_glm(source.mTextureCoords[0][v]));
    // A face without area leaves no normal: any direction will do, clean() drops the face.
    if (!(glm::dot(vertex.normal, vertex.normal) > 0.25f)) vertex.normal = {0, 0, 1};
    if (source.HasTangentsAndBitangents()) {
      // Assimp's own bitangent decides the handedness: mirrored texture coordinates turn it round.
      const glm::vec3 tangent = to_glm(source.mTangents[v]), bitangent = to_glm(source.mBitangents[v]);
      const bool mirrored = glm::dot(glm::cross(vertex.normal, tangent), bitangent) < 0;
      vertex.tangent = glm::vec4(tangent, mirrored ? -1 : 1);
      if (!(glm::dot(tangent, tangent) > 0.25f)) vertex.tangent = glm::vec4(any_tangent(vertex.normal), 1);
    }
    mesh.vertices.push_back(vertex);
  }
  for (unsigned f = 0; f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices != 3) continue;
    mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
  }
  if (!mesh.indices.empty()) clean(mesh, name);
  if (!source.HasTangentsAndBitangents()) make_tangents(mesh);
  return mesh;
}

void collect(const aiScene& scene, const aiNode& node, const glm::mat4& parent, const std::string& name,
             Mesh& out) {
  const glm::mat4 transform = parent * glm::transpose(glm::make_mat4(&node.mTransformation.a1));
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    // Points and lines have no faces and get no normals.
    if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) && mesh.HasNormals())
      append(out, converted(mesh, name), transform);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) collect(scene, *node.mChildren[c], transform, name, out);
}

// Assimp reads on for ever where a PLY's header has no end.
void require_whole_header(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::getline(in, line);
  if (!line.starts_with("ply") && !line.starts_with("PLY")) return;
  while (std::getline(in, line))
    if (line == "end_header" || line == "end_header\r") return;
  throw InputError(file.string() + ": the PLY's header has no line end_header");
}

}  // namespace

Mesh load_model(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such model file");
  require_whole_header(file);
  Assimp::Importer importer;
  // Where a file has no normals: smooth, but for edges sharper than this.
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 40.0f);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                         aiProcess_GenSmoothNormals | aiProcess_CalcTangentSpace);
  if (!scene || !scene->mRootNode) {
    throw InputError(file.string() + ": cannot be read as a model: " + importer.GetErrorString());
  }
  Mesh mesh;
  collect(*scene, *scene->mRootNode, glm::mat4(1), file.string(), mesh);
  clean(mesh, file.string());
  return mesh;
}

}  // namespace brdf::render
