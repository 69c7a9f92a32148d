// STAFF ONLY. Changes scenes as texts, and reads their errors.
#include "hair/scene/test_reading.h"

#include <stdexcept>

#include "hair/io/files/bad_input.h"
#include "solver/test_refusal.h"

namespace reference_tests {

namespace {

std::string with(std::string text, const std::string& what, const std::string& by) {
  if (what.empty()) return text;
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::invalid_argument("no \"" + what + "\" in the scene");
  return text.replace(at, what.size(), by);
}

}  // namespace

std::string linked_scene() {
  return R"({
  "shows": "a brush",
  "frames": 2,
  "method": "implicit_euler",
  "hair": [
    {"segments": 3, "length": 0.1, "clamped": true,
     "roots": {"line": {"from": [0, 0, 0], "to": [0.02, 0, 0], "count": 3}}},
    {"segments": 3, "length": 0.1,
     "roots": {"line": {"from": [0, 0.01, 0], "to": [0.01, 0.01, 0], "count": 2}}}
  ],
  "links": {"stiffness": 0.001, "yields": 1, "breaks": 2, "neighbours": "both",
            "strips": {"thickness": 0.001, "stiffness": 0.1, "friction": 0.3}}
})";
}

std::string small_scene(const std::string& what, const std::string& by) {
  const std::string text = R"({
  "shows": "all kinds of things",
  "frames": 2,
  "frames_per_second": 30,
  "steps_per_frame": 8,
  "gravity": [0, 0, -9.81],
  "wind": [0, 1, 0],
  "method": "predictor_corrector",
  "drag": 1e-4,
  "geometric_term": "filtered",
  "bend_product": "definite",
  "tolerance": 1e-10,
  "hair": [
    {
      "model": "mass_spring", "segments": 4, "length": 0.1,
      "material": {"radius": 5e-5, "density": 1300, "young_modulus": 3e9, "stretch_factor": 1, "bend_factor": 1,
                   "twist_factor": 1, "skip_factor": 0, "relaxation_time": 0},
      "shape": {"wavy": {"amplitude": 0.001, "wavelength": 0.2}},
      "clamped": true,
      "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]},
      "start": {"direction": [0, 1, 0], "stretch": 1, "folded": false},
      "variation": {"seed": 1, "length": 0.1, "tilt": 5, "turn": 90},
      "moves_with": "head"
    },
    {
      "segments": 8, "length": 0.1,
      "shape": {"curly": {"radius": 0.005, "pitch": 0.1}},
      "roots": {"cap": {"centre": [0, 0, 0], "radius": 0.1, "axis": [0, 0, 1], "degrees": 60, "count": 2}},
      "root_velocity": [0, 0, 1]
    },
    {"segments": 1, "length": 0.1, "clamped": false,
     "roots": {"line": {"from": [0, 0, 0], "to": [1, 0, 0], "count": 3, "direction": [0, 1, 0]}}},
    {"segments": 1, "length": 0.1,
     "roots": {"disc": {"centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 0.1, "count": 2, "direction": [0, 1, 0]}},
     "synthesis": {"strands": 5, "mode": "blend", "spread": 1, "jitter": 0.1, "length": 0.1, "seed": 1,
                   "clump": 2, "gathered": 0.5, "fly_aways": 0.1}}
  ],
  "obstacles": [
    {"plane": {"point": [0, 0, -1], "normal": [0, 0, 1]}, "friction": 0.5},
    {"sphere": {"centre": [0, 0, -0.3], "radius": 0.1}, "moves_with": "head"},
    {"capsule": {"from": [0, 0, -0.5], "to": [1, 0, -0.5], "radius": 0.1}}
  ],
  "motions": [
    {"name": "head", "keys": [{"time": 0.1}, {"time": 1, "position": [0, 0, 1], "axis": [0, 0, 1], "degrees": 90}]}
  ],
  "toys": [
    {
      "method": "runge_kutta_4",
      "drag": 0.01,
      "particles": [
        {"position": [0, 0, 0], "mass": 1, "pinned": true},
        {"position": [1, 0, 0], "mass": 2, "velocity": [0, 1, 0]},
        {"position": [2, 0, 0], "mass": 0.5}
      ],
      "springs": [{"between": [0, 1], "stiffness": 10, "rest_length": 1, "damping": 0.1}],
      "rods": [{"between": [1, 2], "length": 1}],
      "wires": [{"particle": 2, "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 2}],
      "feedback": {"stiffness": 100, "damping": 20}
    },
    {
      "method": "implicit_euler",
      "cloth": {"rows": 3, "columns": 4, "corner": [0, 0, 0], "across": [3, 0, 0], "down": [0, 0, -2],
                "area_density": 0.1, "stretch": 100, "shear": 10, "bend": 1, "damping": 0.1,
                "pinned": ["top_left", "top_right"]}
    }
  ],
  "render": {"width": 1e-3, "root_colour": [0, 0, 0], "tip_colour": [1, 1, 1], "view": [1, 0, 0],
             "image_width": 640, "image_height": 480, "shadows": false, "hair": "fine", "colour": "red", "camera": "frame", "links": true}
})";
  return with(text, what, by);
}

std::string complaint(const std::string& text) {
  return tests::refusal<hair::BadInput>([&] { hair::parse_scene(text, "a.json"); });
}

}  // namespace reference_tests
