// Textures of fine hair for OpenGL: its shadow on solids, and the layer that covers the picture.
#pragma once

#include <optional>

#include "hair/render/fine/hair_layer.h"
#include "hair/render/fine/opacity_map.h"
#include "hair/render/opengl/gl_objects.h"

namespace hair {

class FineHairTextures {
 public:
  explicit FineHairTextures(const gl::Functions& functions) : gl_(functions) {}

  void send(const OpacityMap& map, int size) {
    send(first_, size, size, 1, map.first().data());
    send(opacity_, size, size, OpacityMap::kLayers, map.opacity().data());
  }
  void send(const HairLayer& layer) {
    send(pixels_, layer.width, layer.height, 4, layer.pixels.data());
    send(empty_, layer.width, layer.height, 1, layer.empty.data());
  }

  // Gives the textures of the last call of `send` to a program that is in use.
  void set_opacity(const gl::Program& program) const {
    program.set("hair_depth", 0, first_->name());
    program.set("hair_count", 1, opacity_->name());
  }
  void set_layer(const gl::Program& program) const {
    program.set("hair", 1, pixels_->name());
    program.set("hair_empty", 2, empty_->name());
  }

 private:
  void send(std::optional<gl::FloatTexture>& texture, int width, int height, int channels,
            const float* values) {
    if (!texture) texture.emplace(gl_);
    texture->send(width, height, channels, values);
  }

  const gl::Functions& gl_;
  std::optional<gl::FloatTexture> first_, opacity_, pixels_, empty_;
};

}  // namespace hair
