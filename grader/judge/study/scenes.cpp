// STAFF ONLY. Holds the scenes of a study.
#include "grader/judge/study/scenes.h"

namespace grader::inline judge {

const std::vector<SceneText>& studied_scenes() {
  static const std::vector<SceneText> scenes = {
      {"pendulums", R"({
  "shows": "one double pendulum, four integrators",
  "frames": 12, "frames_per_second": 25, "steps_per_frame": 40,
  "toys": [
    {
      "method": "forward_euler",
      "particles": [
        {"position": [0, 0, 0], "mass": 1, "pinned": true},
        {"position": [0.4, 0, -0.3], "mass": 0.3},
        {"position": [0.4, 0, -0.7], "mass": 0.2}
      ],
      "springs": [
        {"between": [0, 1], "stiffness": 400, "rest_length": 0.5, "damping": 0.1},
        {"between": [1, 2], "stiffness": 300, "rest_length": 0.5, "damping": 0.1}
      ]
    },
    {
      "method": "symplectic_euler",
      "particles": [
        {"position": [0, 0.2, 0], "mass": 1, "pinned": true},
        {"position": [0.4, 0.2, -0.3], "mass": 0.3},
        {"position": [0.4, 0.2, -0.7], "mass": 0.2}
      ],
      "springs": [
        {"between": [0, 1], "stiffness": 400, "rest_length": 0.5, "damping": 0.1},
        {"between": [1, 2], "stiffness": 300, "rest_length": 0.5, "damping": 0.1}
      ]
    },
    {
      "method": "midpoint",
      "particles": [
        {"position": [0, 0.4, 0], "mass": 1, "pinned": true},
        {"position": [0.4, 0.4, -0.3], "mass": 0.3},
        {"position": [0.4, 0.4, -0.7], "mass": 0.2}
      ],
      "springs": [
        {"between": [0, 1], "stiffness": 400, "rest_length": 0.5, "damping": 0.1},
        {"between": [1, 2], "stiffness": 300, "rest_length": 0.5, "damping": 0.1}
      ]
    },
    {
      "method": "runge_kutta_4",
      "particles": [
        {"position": [0, 0.6, 0], "mass": 1, "pinned": true},
        {"position": [0.4, 0.6, -0.3], "mass": 0.3},
        {"position": [0.4, 0.6, -0.7], "mass": 0.2}
      ],
      "springs": [
        {"between": [0, 1], "stiffness": 400, "rest_length": 0.5, "damping": 0.1},
        {"between": [1, 2], "stiffness": 300, "rest_length": 0.5, "damping": 0.1}
      ]
    }
  ]
})"},
      {"bead-on-wire", R"({
  "shows": "a bead on a wire, and two rods",
  "frames": 12, "frames_per_second": 25, "steps_per_frame": 20,
  "toys": [{
    "particles": [
      {"position": [0.8, 0, -0.6], "mass": 0.5},
      {"position": [1.2, 0, -0.6], "mass": 0.2},
      {"position": [1.2, 0.4, -0.6], "mass": 0.1}
    ],
    "rods": [{"between": [0, 1], "length": 0.4}, {"between": [1, 2], "length": 0.4}],
    "wires": [{"particle": 0, "centre": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}],
    "feedback": {"stiffness": 400, "damping": 40}
  }]
})"},
      {"stiff-swing", R"({
  "shows": "a stiff hair, its root pulled aside",
  "frames": 12, "frames_per_second": 120, "steps_per_frame": 2,
  "method": "implicit_euler", "preconditioner": "none",
  "hair": [{
    "segments": 10, "length": 0.1,
    "material": {"stretch_factor": 10},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [0, 0, -1]}]},
    "root_velocity": [0.5, 0, 0]
  }]
})"},
      {"skip-springs", R"({
  "shows": "a hair with springs that skip a particle",
  "frames": 12, "frames_per_second": 120, "steps_per_frame": 2,
  "method": "implicit_euler",
  "hair": [{
    "segments": 8, "length": 0.08, "clamped": false,
    "material": {"bend_factor": 0, "skip_factor": 0.2},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}
  }]
})"},
      {"strand-swing", R"({
  "shows": "a hair swings down",
  "frames": 12, "frames_per_second": 60, "steps_per_frame": 4,
  "hair": [{
    "segments": 10, "length": 0.1, "clamped": false,
    "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}
  }]
})"},
      {"curly-hair", R"({
  "shows": "a curl sags under its weight",
  "frames": 12, "frames_per_second": 80, "steps_per_frame": 3,
  "method": "implicit_euler",
  "hair": [{
    "segments": 9, "length": 0.06,
    "material": {"young_modulus": 1e8},
    "shape": {"curly": {"radius": 0.006, "pitch": 0.015}},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [0, 0, -1]}]},
    "root_velocity": [0, 0.3, 0]
  }]
})"},
      {"strand-over-sphere", R"({
  "shows": "two hairs fall over a head",
  "frames": 12, "frames_per_second": 80, "steps_per_frame": 3,
  "hair": [{
    "segments": 10, "length": 0.12, "clamped": false,
    "roots": {"list": [
      {"position": [-0.04, -0.01, 0.07], "direction": [1, 0, 0]},
      {"position": [-0.04, 0.02, 0.07], "direction": [1, 0, 0]}
    ]}
  }],
  "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.06}, "friction": 0.3}]
})"},
  };
  return scenes;
}

}  // namespace grader::judge
