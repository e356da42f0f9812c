#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>
#include <glm/gtc/type_ptr.hpp>
#include <memory>
#include <sstream>

#include "io/files/content.h"
#include "io/files/error.h"
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
    // A face without area has no normal. Any direction will do, because clean() removes the face.
    if (!(glm::dot(vertex.normal, vertex.normal) > 0.25f)) vertex.normal = {0, 0, 1};
    if (source.HasTangentsAndBitangents()) {
      // Assimp's own bitangent decides the handedness, which mirrored texture coordinates reverse.
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

// Throws InputError if the header of a PLY file has no end, for which Assimp would read forever.
void require_whole_header(const io::Content& content) {
  std::istringstream in(content.bytes);
  std::string line;
  std::getline(in, line);
  if (!line.starts_with("ply") && !line.starts_with("PLY")) return;
  while (std::getline(in, line))
    if (line == "end_header" || line == "end_header\r") return;
  throw InputError(content.name + ": the header of the PLY file has no line end_header");
}

// Opens the files of a model, each read at once. Assimp would otherwise treat a read error as a missing
// file or as the end of a file.
class ModelFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ModelFiles(std::exception_ptr& failure) : failure_(failure) {}

  // Does not open the file, because opening can fail for other reasons too.
  bool Exists(const char* file) const override {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
  }
  Assimp::IOStream* Open(const char* file, const char*) override {
    try {
      const std::string bytes = io::read_content(file).bytes;
      auto copy = std::make_unique<std::uint8_t[]>(bytes.size());
      std::copy(bytes.begin(), bytes.end(), copy.get());
      auto stream = std::make_unique<Assimp::MemoryIOStream>(copy.get(), bytes.size(), true);
      copy.release();  // the stream owns the bytes now
      return stream.release();
    } catch (const InputError&) {  // for example a missing material library
    } catch (...) {
      failure_ = std::current_exception();
    }
    return nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::exception_ptr& failure_;
};

}  // namespace

Mesh load_model(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such model file");
  require_whole_header(io::read_content(file));
  std::exception_ptr failure;
  Assimp::Importer importer;
  importer.SetIOHandler(new ModelFiles(failure));  // the importer deletes it
  // For files without normals: smooth normals, except at edges sharper than this angle, in degrees.
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 40.0f);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                         aiProcess_GenSmoothNormals | aiProcess_CalcTangentSpace);
  if (failure) std::rethrow_exception(failure);
  if (!scene || !scene->mRootNode)
    throw InputError(file.string() + ": cannot be read as a model: " + importer.GetErrorString());
  Mesh mesh;
  collect(*scene, *scene->mRootNode, glm::mat4(1), file.string(), mesh);
  clean(mesh, file.string());
  return mesh;
}

}  // namespace brdf::render
