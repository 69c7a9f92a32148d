#include "hair/render/opengl/renderer.h"

#include <algorithm>
#include <optional>

#include "hair/render/fine/fine_hair.h"
#include "hair/render/light.h"
#include "hair/render/mesh.h"
#include "hair/render/opengl/fine_hair_textures.h"
#include "hair/render/opengl/gl_context.h"
#include "hair/render/opengl/gl_objects.h"
#include "hair/render/ribbons.h"
#include "hair/render/view.h"
#include "particles/require.h"

namespace hair {
namespace {

constexpr int kSamples = 2;  // per pixel's width, and as many per height: shaders.cpp relies on it

RenderSettings checked(const RenderSettings& settings) {
  for (const int side : {settings.width, settings.height}) {
    particles::require(side >= 16 && side <= 4096, "a side of the picture", side, "16 to 4096 pixels");
  }
  return settings;
}

// As fine as the samples, for a map as wide as the picture is high; a multiple of the tiles of software
// renderers.
int map_size(const RenderSettings& settings) {
  return std::clamp(settings.height * 3 / 2 / 64 * 64, 256, 2048);
}

}  // namespace

class Renderer::Parts {
 public:
  explicit Parts(const RenderSettings& settings)
      : settings_(checked(settings)),
        context_(settings.library),
        gl_(context_.functions()),
        programs_(gl_),
        fine_textures_(gl_) {}

  Image draw(const Drawing& drawing, const Camera& camera) {
    check_drawing(drawing);
    const View view(camera, static_cast<double>(settings_.width) / settings_.height);
    const GlContext::Current current(context_);
    const Content content = send(drawing, view);
    if (content.shadows()) draw_maps(content);
    draw_samples(drawing, view, content);
    if (content.fine) draw_layer(drawing, view, content);
    resolve(content);
    Image image = image_of(gl_, *picture_);
    if (gl_.GetError() != gl::kNoError) throw std::runtime_error("OpenGL failed: is there enough memory?");
    return image;
  }

  std::string about() const { return context_.about(); }

 private:
  // The contents of a drawing, and the passes that they need.
  struct Content {
    bool hair = false, solids = false;                 // to show
    bool fine = false;                                 // hair as a layer, and none of it by OpenGL
    bool hair_shadows = false, solid_shadows = false;  // to throw shadows
    std::size_t casting = 0;
    float half_width = 0;
    LightMap light = {};

    bool shadows() const { return hair_shadows || solid_shadows; }
  };

  Content send(const Drawing& drawing, const View& view) {
    Content content;
    if (!drawing.strands.fine) {
      fine_.reset();
    } else if (!fine_) {
      fine_.emplace();
    }
    if (fine_) fine_->send(drawing.strands, view, settings_.height);
    const std::vector<RibbonVertex> ribbons =
        fine_ ? std::vector<RibbonVertex>() : ribbon_vertices(drawing.strands, view);
    const Mesh mesh = mesh_of(drawing, view, kSamples * settings_.height);
    content.hair = !ribbons.empty();
    content.fine = fine_ && !fine_->empty();
    content.solids = !mesh.indices.empty();
    content.casting = mesh.casting;
    content.hair_shadows = settings_.shadows && (content.hair || content.fine);
    content.solid_shadows = settings_.shadows && mesh.casting > 0;
    content.half_width = view.length(drawing.strands.width / 2);
    if (content.shadows())
      content.light = light_map(ribbons, mesh, fine_ ? fine_->points() : std::span<const Eigen::Vector3f>());
    if (content.hair) {
      if (!ribbons_) ribbons_.emplace(gl_, std::vector{3, 3, 2});
      ribbons_->send(ribbons.data(), ribbons.size() * sizeof(RibbonVertex),
                     ribbon_indices(drawing.strands.sizes));
    }
    if (content.solids) {
      if (!mesh_) mesh_.emplace(gl_, std::vector{3, 3, 4});
      mesh_->send(mesh.vertices.data(), mesh.vertices.size() * sizeof(MeshVertex), mesh.indices);
    }
    return content;
  }

  // The light's view: the depths of solids and of hair, and the number of strands in each layer.
  void draw_maps(const Content& content) {
    const int size = map_size(settings_);
    if (content.solid_shadows) {
      if (!solid_map_) solid_map_ = make_target(gl_, size, size, 0, true);
      clear(*solid_map_);
      const gl::Program& program = programs_.use(Pass::mesh_depth);
      aim(program, content.light.to, *solid_map_);
      mesh_->draw(gl::kTriangles, content.casting);
    }
    if (content.hair_shadows && content.fine) {
      fine_->make_opacity(content.light, size);
      if (content.solids) fine_textures_.send(fine_->opacity(), size);
    } else if (content.hair_shadows) {
      if (!hair_map_) {
        hair_map_ = make_target(gl_, size, size, 0, true);
        count_map_ = make_target(gl_, size, size, gl::kRgba16F, false);
      }
      clear(*hair_map_);
      const gl::Program& depth = programs_.use(Pass::ribbon_depth);
      aim_at_light(depth, content);
      draw_ribbons();

      clear(*count_map_);
      gl_.Disable(gl::kDepthTest);
      gl_.Enable(gl::kBlend);
      gl_.BlendFunc(gl::kOne, gl::kOne);
      const gl::Program& count = programs_.use(Pass::ribbon_count);
      aim_at_light(count, content);
      count.set("layers", layers(content));
      count.set("hair_depth", 0, hair_map_->depth);
      draw_ribbons();
      gl_.Disable(gl::kBlend);
    }
  }

  // The layer behind solids, and in their shadows.
  void draw_layer(const Drawing& drawing, const View& view, const Content& content) {
    FineHair::Solids solids;
    if (content.solids) {
      solids.samples = kSamples;
      solids.distances = depths_of(gl_, *samples_);
      for (float& depth : solids.distances) depth = view.distance(depth);
    }
    if (content.solid_shadows) {
      solids.light_depths = depths_of(gl_, *solid_map_);
      solids.light = content.light;
      solids.bias = bias(content);
    }
    fine_textures_.send(fine_->draw(drawing.strands, view, settings_.width, settings_.height, solids));
  }

  void draw_samples(const Drawing& drawing, const View& view, const Content& content) {
    if (!samples_) {
      samples_ =
          make_target(gl_, kSamples * settings_.width, kSamples * settings_.height, gl::kRgba16F, true);
    }
    clear(*samples_);
    const std::string header = std::string(content.hair_shadows ? "#define HAIR_SHADOWS\n" : "") +
                               (content.solid_shadows ? "#define SOLID_SHADOWS\n" : "");
    if (content.solids) {
      const gl::Program& program = programs_.use(Pass::mesh, header);
      light(program, view, content);
      mesh_->draw(gl::kTriangles, mesh_->size());
    }
    if (content.hair) {
      const gl::Program& program = programs_.use(Pass::ribbon, header);
      light(program, view, content);
      program.set("half_width", content.half_width);
      program.set("half_sample", view.tangent_y() / static_cast<float>(kSamples * settings_.height));
      program.set("seen_from", Eigen::Vector4f(0, 0, 0, 1));
      program.set("root_colour", drawing.strands.root);
      program.set("tip_colour", drawing.strands.tip);
      draw_ribbons();
    }
  }

  void resolve(const Content& content) {
    if (!picture_) {
      picture_ = make_target(gl_, settings_.width, settings_.height, gl::kRgba8, false);
      gl_.GenVertexArrays(1, &no_vertices_);
    }
    draw_into(gl_, *picture_);
    gl_.Disable(gl::kDepthTest);
    const gl::Program& program = programs_.use(Pass::resolve, content.fine ? "#define FINE_HAIR\n" : "");
    program.set("samples", 0, samples_->colour);
    if (content.fine) fine_textures_.set_layer(program);
    gl_.BindVertexArray(no_vertices_);
    gl_.DrawArrays(gl::kTriangles, 0, 3);
  }

  void clear(const gl::Target& target) {
    draw_into(gl_, target);
    gl_.Enable(gl::kDepthTest);
    gl_.Clear(gl::kColourBufferBit | gl::kDepthBufferBit);
  }

  void draw_ribbons() {
    gl_.Enable(gl::kPrimitiveRestart);
    gl_.PrimitiveRestartIndex(kRestart);
    ribbons_->draw(gl::kTriangleStrip, ribbons_->size());
    gl_.Disable(gl::kPrimitiveRestart);
  }

  float half_texel(const Content& content) const {
    return content.light.radius / static_cast<float>(map_size(settings_));
  }

  float bias(const Content& content) const { return 3 * half_texel(content) / LightMap::kDepth; }

  static Eigen::Vector4f layers(const Content& content) { return OpacityMap::ends(content.light); }

  void aim(const gl::Program& program, const Eigen::Matrix4f& to_clip, const gl::Target& target) {
    program.set("to_clip", to_clip);
    program.set("grid", 128.0F * static_cast<float>(target.width),
                128.0F * static_cast<float>(target.height));
  }

  void aim_at_light(const gl::Program& program, const Content& content) {
    aim(program, content.light.to, *hair_map_);
    program.set("seen_from", Eigen::Vector4f(kKeyLight[0], kKeyLight[1], kKeyLight[2], 0));
    program.set("half_width", content.half_width);
    program.set("half_sample", half_texel(content));
  }

  void light(const gl::Program& program, const View& view, const Content& content) {
    aim(program, view.projection(), *samples_);
    program.set("key_light", kKeyLight);
    program.set("up", view.direction(Vector3d(0, 0, 1)));
    if (!content.shadows()) return;
    program.set("to_light", content.light.to);
    if (content.hair_shadows && content.fine) {
      program.set("opacity", 1.0F);
      program.set("skip", fine_->opacity().skip());
      program.set("layers", layers(content));
      fine_textures_.set_opacity(program);
    } else if (content.hair_shadows) {
      const float half = half_texel(content);
      program.set("opacity", content.half_width / std::max(content.half_width, half));
      program.set("skip", 4 * std::max(content.half_width, half) / LightMap::kDepth);
      program.set("layers", layers(content));
      program.set("hair_depth", 0, hair_map_->depth);
      program.set("hair_count", 1, count_map_->colour);
    }
    if (content.solid_shadows) {
      program.set("bias", bias(content));
      program.set("away", 4 * half_texel(content));
      program.set("solid_depth", 2, solid_map_->depth);
    }
  }

  RenderSettings settings_;
  GlContext context_;
  const gl::Functions& gl_;
  gl::Programs programs_;
  FineHairTextures fine_textures_;
  std::optional<gl::Triangles> ribbons_, mesh_;
  std::optional<gl::Target> solid_map_, hair_map_, count_map_, samples_, picture_;
  std::optional<FineHair> fine_;
  gl::Name no_vertices_ = 0;
};

Renderer::Renderer(const RenderSettings& settings) : parts_(std::make_unique<Parts>(settings)) {}
Renderer::~Renderer() = default;

Image Renderer::draw(const Drawing& drawing, const Camera& camera) {
  return parts_->draw(drawing, camera);
}

std::string Renderer::about() const {
  return parts_->about();
}

}  // namespace hair
