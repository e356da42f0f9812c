// Reads of textures, as operations on the texels of a file.
#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <utility>

#include "shader/program/lowering.h"

namespace brdf::shader {
namespace {

// The position of the operand that is the image, and of the coordinates, is the same in all reads.
constexpr std::size_t kCoordinates = 1, kOperands = 2;

}  // namespace

bool Lowering::is_opaque(Id type) const {
  const spirv::Type& t = module_.type(type);
  const bool holds = t.kind == spirv::Kind::pointer || t.kind == spirv::Kind::array;
  return t.kind == spirv::Kind::opaque || (holds && is_opaque(t.element));
}

// The texture of a variable; null for a sampler, whose state the command line gives.
const Texture* Lowering::texture_named(const std::string& name, Id type) const {
  const spirv::Type& t = module_.type(type);
  if (t.is_sampler) return nullptr;
  if (!t.is_texture)
    refuse("reads " + name +
           ", which is no texture of two dimensions with numbers; use a parameter for its value");
  const auto found = options_.textures.find(name);
  if (found == options_.textures.end())
    refuse("reads the texture " + name + ": give its texels with --texture " + name +
           "=FILE.exr, or use a parameter for its value");
  return &found->second;
}

const Texture* Lowering::texture_of(const Frame& frame, Id id) const {
  if (const auto found = frame.textures.find(id); found != frame.textures.end()) return found->second;
  const auto global = module_.globals.find(id);
  if (global == module_.globals.end() || !global->second.variable)
    refuse("reads a texture that the program chooses while it runs; use a parameter for its value");
  return texture_named(module_.name(id), module_.type(global->second.instruction.type).element);
}

// Returns whether the instruction only passes a texture or a sampler on.
bool Lowering::passes_texture(Frame& frame, const spirv::Instruction& i) {
  const auto word = [&](std::size_t k) {
    if (k >= i.words.size()) refuse("an instruction is incomplete");
    return i.words[k];
  };
  switch (i.code) {
    case spv::OpVariable:
      return is_opaque(i.type);
    case spv::OpStore:
      if (!frame.textures.contains(word(1))) return false;
      frame.textures[word(0)] = frame.textures.at(word(1));
      return true;
    case spv::OpLoad:
    case spv::OpCopyObject:
    case spv::OpSampledImage:
    case spv::OpImage:
      if (i.code != spv::OpSampledImage && i.code != spv::OpImage && !is_opaque(i.type)) return false;
      frame.textures[i.result] = texture_of(frame, word(0));
      return true;
    default:
      return false;
  }
}

std::optional<Slots> Lowering::read_texture(Frame& frame, const spirv::Instruction& i) {
  const bool fetches = i.code == spv::OpImageFetch;
  const bool samples = i.code == spv::OpImageSampleImplicitLod || i.code == spv::OpImageSampleExplicitLod;
  const bool asks = i.code == spv::OpImageQuerySizeLod || i.code == spv::OpImageQuerySize;
  if (!fetches && !samples && !asks) return std::nullopt;
  const Texture* const texture = texture_of(frame, i.words.at(0));
  if (texture == nullptr) refuse("reads a sampler without a texture");
  if (asks) return Slots{integer_constant(texture->width), integer_constant(texture->height)};
  const std::uint32_t operands = i.words.size() > kOperands ? i.words[kOperands] : 0;
  // The coordinates, and the filter of the texture unit, keep their own precision.
  const bool narrow = std::exchange(narrow_, false);
  const Slots at = value(frame, i.words.at(kCoordinates));
  if (at.size() != 2) refuse("a value has two types");
  // A file has one level, so that every level of detail is that level, for a sample with gradients, too.
  const std::uint32_t kLevels = spv::ImageOperandsBiasMask | spv::ImageOperandsLodMask |
                                spv::ImageOperandsGradMask | spv::ImageOperandsMinLodMask;
  if ((operands & ~kLevels) != 0) refuse("reads a texture with an offset, which is not supported");
  if (fetches && (operands & spv::ImageOperandsLodMask) != 0 &&
      scalar(frame, i.words.at(kOperands + 1)) != integer_constant(0))
    refuse("reads a level of detail other than 0, and the file of a texture has only level 0");
  Slots out = fetches ? fetched(*texture, at) : sampled(*texture, at);
  narrow_ = narrow;
  return out;
}

// One channel of a texel.
Slot Lowering::texel(const Texture& texture, std::size_t channel, Slot place) {
  const std::shared_ptr<const TexelTable>& table = texture.channels[channel];
  if (table == nullptr) return number_constant(channel == 3 ? 1 : 0);
  auto known = std::ranges::find(program_.tables, table);
  if (known == program_.tables.end()) known = program_.tables.insert(known, table);
  return emit(Op::texel, place, 0, Slot(known - program_.tables.begin()));
}

Slot Lowering::texel_place(const Texture& texture, Slot x, Slot y) {
  return emit(Op::iadd, emit(Op::imul, y, integer_constant(texture.width)), x);
}

// Outside the texture the languages leave the value open.
Slots Lowering::fetched(const Texture& texture, const Slots& at) {
  const Slot place = texel_place(texture, emit(Op::index, at[0], integer_constant(texture.width - 1)),
                                 emit(Op::index, at[1], integer_constant(texture.height - 1)));
  Slots out;
  for (std::size_t c = 0; c < 4; ++c) out.push_back(texel(texture, c, place));
  return out;
}

// The coordinate within the texture, from 0 to 1.
Slot Lowering::wrapped(TextureWrap wrap, Slot u) {
  const auto number = [&](double x) { return number_constant(x); };
  if (wrap == TextureWrap::repeat) return emit(Op::fract, u);
  if (wrap == TextureWrap::clamp) return emit(Op::min, emit(Op::max, u, number(0)), number(1));
  // u - 2 floor(u / 2) is from 0 to 2, and its second half leads back.
  const Slot turns = emit(Op::floor, emit(Op::mul, u, number(0.5)));
  const Slot there = emit(Op::sub, u, emit(Op::mul, number(2), turns));
  return emit(Op::sub, number(1), emit(Op::abs, emit(Op::sub, number(1), there)));
}

// The texels next to a coordinate along one axis, and the share of the second.
Lowering::Neighbours Lowering::neighbours(const Texture& texture, std::uint32_t size, Slot u) {
  const Slot last = integer_constant(size - 1), zero = integer_constant(0);
  const auto inside = [&](Slot k) { return emit(Op::imax, emit(Op::imin, k, last), zero); };
  const Slot scaled = emit(Op::mul, wrapped(texture.wrap, u), number_constant(size));
  if (texture.filter == TextureFilter::nearest) {
    const Slot k = inside(emit(Op::to_signed, emit(Op::floor, scaled)));
    return {k, k, number_constant(0)};
  }
  const Slot x = emit(Op::sub, scaled, number_constant(0.5)), below = emit(Op::floor, x);
  Slot first = emit(Op::to_signed, below);
  Slot second = emit(Op::iadd, first, integer_constant(1));
  if (texture.wrap == TextureWrap::repeat) {
    first = emit(Op::iselect, emit(Op::slt, first, zero), last, first);
    second = emit(Op::iselect, emit(Op::slt, last, second), zero, second);
  }
  return {inside(first), inside(second), emit(Op::fract, x)};
}

Slots Lowering::sampled(const Texture& texture, const Slots& at) {
  const Neighbours x = neighbours(texture, texture.width, at[0]),
                   y = neighbours(texture, texture.height, at[1]);
  Slots out;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto at_texel = [&](Slot column, Slot row) {
      return texel(texture, c, texel_place(texture, column, row));
    };
    if (texture.filter == TextureFilter::nearest || texture.channels[c] == nullptr) {
      out.push_back(at_texel(x.first, y.first));
      continue;
    }
    const auto row = [&](Slot k) {
      return emit(Op::mix, at_texel(x.first, k), at_texel(x.second, k), x.share);
    };
    out.push_back(emit(Op::mix, row(y.first), row(y.second), y.share));
  }
  return out;
}

}  // namespace brdf::shader
