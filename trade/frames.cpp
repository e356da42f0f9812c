#include "trade/frames.h"

#include <cmath>

#include "render/renderer.h"
#include "trade/ball.h"
#include "trade/timing.h"

namespace brdf::trade {
namespace {

using render::Picture;
using render::Scene;
using render::Shading;

// One way to draw a frame.
struct Way {
  std::string name;
  Scene scene;
  render::RendererOptions options;
  std::string note = {};
};

// Draws every way, first each once for its picture, then in turn for its time.
class Gallery {
 public:
  Gallery(render::Device& device, const std::vector<Way>& ways, int rounds) {
    for (const Way& way : ways) {
      renderers_.push_back(
          std::make_unique<render::Renderer>(device, render::prepare(way.scene), way.options));
      renderers_.back()->draw();
      pictures.push_back(render::picture_from(way.scene.camera.width, way.scene.camera.height,
                                              renderers_.back()->read_color()));
    }
    std::vector<std::function<void()>> calls;
    for (auto& renderer : renderers_) calls.push_back([&r = *renderer] { r.draw(); });
    timing::Options options;
    options.rounds = rounds;
    options.least_seconds = 2e-3;
    // On a software driver the frame's cost is the processor's, whoever else uses the machine.
    if (device.name().find("llvmpipe") != std::string::npos) options.clock = timing::Clock::process;
    timings = timing::interleaved(calls, options);
  }
  std::vector<Picture> pictures;
  std::vector<timing::Timing> timings;

 private:
  std::vector<std::unique_ptr<render::Renderer>> renderers_;
};

// Differences of luminance over the pixels that `of` admits.
struct PictureError {
  Error error;
  double image = 0, root_mean_square = 0;
};
PictureError picture_error(
    const Picture& a, const Picture& exact,
    const std::function<bool(int x, int y)>& of = [](int, int) { return true; }) {
  PictureError out;
  std::vector<double> differences;
  double sum = 0, total = 0, squares = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (exact.at(x, y).a < 0.5f || a.at(x, y).a < 0.5f || !of(x, y)) continue;
      const auto mean = [](const glm::vec4& c) { return (double(c.r) + double(c.g) + double(c.b)) / 3; };
      const double e = mean(exact.at(x, y)), d = std::abs(mean(a.at(x, y)) - e);
      if (d > out.error.max || differences.empty()) {
        out.error.max = d;
        out.error.where = "pixel " + std::to_string(x) + ", " + std::to_string(y);
      }
      differences.push_back(d);
      sum += d;
      squares += d * d;
      total += e;
    }
  if (differences.empty()) return out;
  const auto count = double(differences.size());
  std::sort(differences.begin(), differences.end());
  out.error.mean = sum / count;
  out.error.p99 = timing::quantile(differences, 0.99);
  out.image = total > 0 ? sum / total : 0;
  out.root_mean_square = std::sqrt(squares / count);
  return out;
}

LedgerRow frame_row(const std::string& question, const std::string& exact, const Way& way,
                    const timing::Timing& timing, const timing::Timing& exact_timing,
                    const PictureError& error, const std::string& domain) {
  LedgerRow row;
  row.question = question;
  row.choice = way.name;
  row.exact = exact;
  row.unit = Unit::frame;
  row.cost = {timing.lower, timing.spread(), timing.rounds};
  row.cost_ratio = timing.lower / exact_timing.lower;
  row.error = error.error;
  row.quantity = "radiance";
  row.image_error = error.image;
  row.domain = domain;
  char text[64];
  std::snprintf(text, sizeof text, "RMS %.2e", error.root_mean_square);
  row.note = way.note.empty() ? text : way.note + "; " + text;
  return row;
}

// The pixel-shader article's light and colours on a sphere.
Scene article(const std::string& mesh, Shading shading, bool as_coded, int size) {
  Scene scene = material_ball(size);
  scene.ambient = glm::vec3(0.25f);
  scene.lights[0].intensity = 0.75f;
  scene.objects[0].mesh = mesh;
  for (std::size_t c = 0; c < 3; ++c) scene.objects[0].material.terms[0].weights[c][0] = 0.5 * double(c);
  scene.shading = shading;
  scene.as_coded = as_coded;
  return scene;
}

int triangles_of(int level) {
  return 20 << (2 * level);
}

// Shading per vertex against per pixel, judged by the finest mesh shaded per pixel.
std::vector<LedgerRow> shading_rows(render::Device& device, bool highlight, const FrameOptions& options) {
  const int size = options.quick ? 200 : 400;
  const std::vector<int> levels = options.quick ? std::vector<int>{2, 4} : std::vector<int>{2, 3, 4, 5, 6};
  std::vector<Way> ways;
  const auto add = [&](const char* name, int level, Shading shading, bool as_coded, bool per_vertex) {
    Way way{std::to_string(triangles_of(level)) + " triangles, " + name,
            article("icosphere:" + std::to_string(level), shading, as_coded, size),
            {}};
    way.scene.per_vertex = per_vertex;
    ways.push_back(std::move(way));
  };
  add("per pixel", 7, highlight ? Shading::phong_blinn : Shading::phong, false, false);
  for (int level : levels) {
    if (!highlight) {
      add("vertex colours", level, Shading::vertex_color, false, false);
      add("flat", level, Shading::flat, false, false);
      add("Gouraud", level, Shading::gouraud, false, false);
      add("Phong as coded", level, Shading::phong, true, false);
      add("Phong", level, Shading::phong, false, false);
    } else {
      add("highlight as coded", level, Shading::phong_blinn, true, false);
      add("highlight per pixel", level, Shading::phong_blinn, false, false);
    }
  }
  const Gallery gallery(device, ways, 21);
  std::vector<LedgerRow> rows;
  const std::string question = highlight ? "where to shade: highlight" : "where to shade: diffuse";
  // Front pixels: the limb is excluded, where vertices behind it carry the back colour.
  const double radius = 0.42 * size;
  const auto front = [&](int x, int y) {
    return std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) < radius;
  };
  for (std::size_t k = 0; k < ways.size(); ++k)
    rows.push_back(frame_row(question, ways[0].name, ways[k], gallery.timings[k], gallery.timings[0],
                             picture_error(gallery.pictures[k], gallery.pictures[0], front),
                             "the article's sphere, " + std::to_string(size) + " pixels wide, front pixels"));
  mark_dominated(rows);
  return rows;
}

// Cook-Torrance on the ball, in a frame of 16 : 9.
Scene frame_scene(int lights, bool quick) {
  Scene scene = material_ball(360);
  scene.camera.width = quick ? 320 : 640;
  scene.camera.height = quick ? 180 : 360;
  scene.objects[0].material = make_material(cook_torrance{});
  scene.lights.clear();
  for (int k = 0; k < lights; ++k) {
    const float turn = 2.3999632f * float(k);  // the golden angle
    scene.lights.push_back({false,
                            {std::cos(turn), -0.5f - 0.5f * float(k % 3), std::sin(turn) - 1.2f},
                            glm::vec3(1),
                            3.1415927f / float(lights)});
  }
  return scene;
}

std::string frame_domain(const Scene& scene) {
  return std::to_string(scene.camera.width) + " x " + std::to_string(scene.camera.height) + ", " +
         std::to_string(scene.lights.size()) + (scene.lights.size() == 1 ? " light" : " lights") +
         ", 50,176 triangles, cook_torrance";
}

std::vector<LedgerRow> bits_rows(render::Device& device, const FrameOptions& options) {
  const auto run = [&](double alpha) {
    std::vector<Way> ways;
    for (int bits : {32, 16, 8}) {
      Way way{std::to_string(bits) + " bits", frame_scene(1, options.quick), {bits, render::Path::deferred}};
      way.scene.objects[0].material.terms[0].shape[0] = {alpha, alpha};
      ways.push_back(std::move(way));
    }
    const Gallery gallery(device, ways, 21);
    std::vector<LedgerRow> rows;
    char name[64];
    std::snprintf(name, sizeof name, "bits of the G-buffer, alpha %g", alpha);
    for (std::size_t k = 0; k < ways.size(); ++k)
      rows.push_back(frame_row(name, ways[0].name, ways[k], gallery.timings[k], gallery.timings[0],
                               picture_error(gallery.pictures[k], gallery.pictures[0]),
                               frame_domain(ways[k].scene)));
    mark_dominated(rows);
    return rows;
  };
  std::vector<LedgerRow> rows = run(0.3);
  for (LedgerRow& row : run(0.05)) rows.push_back(std::move(row));
  return rows;
}

std::vector<LedgerRow> light_rows(render::Device& device, const FrameOptions& options) {
  std::vector<LedgerRow> rows;
  for (int lights : {1, 4, 16, 64}) {
    const Scene scene = frame_scene(lights, options.quick);
    const std::vector<Way> ways{{"forward", scene, {32, render::Path::forward}},
                                {"deferred, 32 bits", scene, {32, render::Path::deferred}},
                                {"deferred, 16 bits", scene, {16, render::Path::deferred}}};
    const Gallery gallery(device, ways, 21);
    std::vector<LedgerRow> some;
    for (std::size_t k = 0; k < ways.size(); ++k)
      some.push_back(
          frame_row("forward or deferred, " + std::to_string(lights) + (lights == 1 ? " light" : " lights"),
                    ways[0].name, ways[k], gallery.timings[k], gallery.timings[0],
                    picture_error(gallery.pictures[k], gallery.pictures[0]), frame_domain(scene)));
    mark_dominated(some);
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  }
  return rows;
}

// The article's material, evaluated or looked up, per pixel and per vertex.
std::vector<LedgerRow> lookup_rows(render::Device& device, const FrameOptions& options) {
  const int size = options.quick ? 256 : 512;
  std::vector<Way> ways;
  const auto add = [&](std::string name, const std::string& mesh, Shading shading, bool per_vertex,
                       bool as_coded) {
    Way way{std::move(name), material_ball(size), {32, render::Path::deferred}};
    render::Object& object = way.scene.objects[0];
    object.mesh = mesh;
    object.material = make_material(cook_torrance_vcavity{});
    for (auto& shape : object.material.terms[0].shape) shape = {0.3, 0.3, 1.5};
    way.scene.shading = shading;
    way.scene.per_vertex = per_vertex;
    way.scene.as_coded = as_coded;
    ways.push_back(std::move(way));
  };
  add("evaluated", "icosphere:6", Shading::brdf, false, false);
  // The article's light is 1 where ours is pi: Cm n.l Cd has no 1/pi.
  ways[0].scene.lights[0].intensity = 3.1415927f;
  add("lookup per pixel", "icosphere:6", Shading::lookup, false, false);
  add("lookup per pixel, the slip", "icosphere:6", Shading::lookup, false, true);
  for (int level : {2, 4, 6})
    add("lookup per vertex, " + std::to_string(triangles_of(level)) + " triangles",
        "icosphere:" + std::to_string(level), Shading::lookup, true, false);
  const Gallery gallery(device, ways, 21);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < ways.size(); ++k)
    rows.push_back(frame_row("lookup texture in a frame", ways[0].name, ways[k], gallery.timings[k],
                             gallery.timings[0], picture_error(gallery.pictures[k], gallery.pictures[0]),
                             "the article's material on a sphere, " + std::to_string(size) + " pixels wide"));
  mark_dominated(rows);
  return rows;
}

// Time of one evaluation in the light pass: what 63 more lights cost, per lit pixel; by form.
std::vector<LedgerRow> shader_rows(render::Device& device) {
  std::vector<Way> ways;
  std::vector<AnyForm> forms;
  for_each_form([&](auto form) {
    if (form.name != form.family) return;
    forms.push_back(form);
    for (int lights : {1, 64}) {
      Way way{std::string(form.name), frame_scene(lights, true), {32, render::Path::deferred}};
      way.scene.objects[0].material = make_material(form);
      ways.push_back(std::move(way));
    }
  });
  const Gallery gallery(device, ways, 21);
  std::vector<LedgerRow> rows;
  std::size_t exact = 0;
  for (std::size_t k = 0; k < forms.size(); ++k)
    if (forms[k].index() == AnyForm(cook_torrance{}).index()) exact = k;
  const auto seconds = [&](std::size_t k) {
    double pixels = 0;
    for (const glm::vec4& p : gallery.pictures[2 * k].pixels) pixels += p.a > 0.5f;
    return (gallery.timings[2 * k + 1].lower - gallery.timings[2 * k].lower) / (63 * std::max(pixels, 1.0));
  };
  for (std::size_t k = 0; k < forms.size(); ++k) {
    LedgerRow row;
    row.question = "a family in the shader, on " + device.name();
    row.choice = info(forms[k]).name;
    row.exact = "cook_torrance";
    row.cost = {seconds(k), gallery.timings[2 * k + 1].spread(), 21};
    row.cost_ratio = seconds(k) / seconds(exact);
    const PictureError error = picture_error(
        gallery.pictures[2 * k],
        render::render_reference(render::prepare(ways[2 * k].scene), render::ReferenceOptions{.threads = 2}));
    row.error = error.error;
    row.quantity = "radiance, shader against the library";
    row.image_error = error.image;
    row.domain = frame_domain(ways[2 * k].scene);
    row.note = "63 more lights, per pixel of the frame that a surface covers; all threads of the driver";
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

}  // namespace

std::vector<LedgerRow> frame_rows(const FrameOptions& options) {
  render::Device device;
  std::vector<LedgerRow> rows;
  const auto add = [&](const char* what, std::vector<LedgerRow> some) {
    options.tick(what);
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  };
  add("frames: where to shade", shading_rows(device, false, options));
  add("frames: highlights", shading_rows(device, true, options));
  add("frames: G-buffer", bits_rows(device, options));
  add("frames: lights", light_rows(device, options));
  add("frames: lookup texture", lookup_rows(device, options));
  add("frames: shaders", shader_rows(device));
  return rows;
}

}  // namespace brdf::trade
