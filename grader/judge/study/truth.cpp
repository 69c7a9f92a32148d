// STAFF ONLY. Computes and stores a part's reference solution.
#include "grader/judge/study/truth.h"

#include <algorithm>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/wire/message.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"
#include "hair/scene/playback.h"
#include "hair/truth/accurate_motion.h"
#include "hair/truth/trajectory.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;

constexpr int kTimesFinest = 32;

std::vector<particles::State> played(const StudiedPart& part, const Division& division) {
  const SceneText text = divided(part, division);
  const hair::Scene scene = hair::parse_scene(text.json, text.name);
  hair::Playback playback(scene);
  std::vector<particles::State> frames = {playback.state()};
  for (int k = 0; k < scene.frames; ++k) {
    if (const auto trouble = playback.advance())
      throw std::runtime_error("the reference breaks in " + part.name + ": " + *trouble);
    frames.push_back(playback.state());
  }
  return frames;
}

Truth by_many_steps(const StudiedPart& part) {
  Division finest = divisions_of(part.scene).back();
  finest.steps_per_frame *= kTimesFinest / 2;
  const std::vector<particles::State> half = played(part, finest);
  finest.steps_per_frame *= 2;
  Truth truth;
  truth.frames = played(part, finest);
  truth.least_error = hair::largest_distance(half, truth.frames);
  truth.method = "our own run in " + std::to_string(finest.steps()) + " steps";
  return truth;
}

// CVODE computes one strand or one toy without contacts, if it can.
std::optional<Truth> by_cvode(const StudiedPart& part) {
  const hair::Scene& scene = part.scene;
  if (!hair::have_accurate_motion() || !scene.hair.obstacles.empty() || scene.hair.strands.size() > 1 ||
      !scene.hair.modelled.empty())
    return {};
  try {
    hair::ProblemSettings settings;
    settings.duration = scene.frames / scene.frames_per_second;
    hair::Problem problem = hair::make_problem(scene, settings);
    problem.scene.frames = scene.frames;  // are the moments
    problem.scene.frames_per_second = scene.frames_per_second;
    problem.scene.hair.step = 1 / scene.frames_per_second;
    std::optional<hair::AccurateMotion> motion = hair::accurate_motion(problem, {}, std::atomic<bool>(false));
    return Truth{std::move(motion->states), 0, motion->least_error(), motion->method};
  } catch (const std::runtime_error&) {  // CVODE gave up, or knows no such problem
    return {};
  }
}

// Writes numbers in the machine's format after a checksum: another machine's or half a file is ignored.
void keep(const fs::path& file, const Truth& truth) {
  MessageWriter writer;
  writer.put(truth.method).put(truth.least_error).put(static_cast<std::uint64_t>(truth.frames.size()));
  for (const particles::State& state : truth.frames)
    for (const Eigen::VectorXd* part : {&state.x, &state.v})
      writer.put(std::span<const double>(part->data(), static_cast<std::size_t>(part->size())));
  const auto* bytes = reinterpret_cast<const char*>(writer.bytes().data());
  const std::string body(bytes, writer.bytes().size());
  hair::write_file(file, sha256(body) + body);
}

std::optional<Truth> read_kept(const fs::path& file) {
  const std::string all = hair::bytes_of(file);
  const std::size_t sum = sha256("").size();
  if (all.size() < sum || sha256(all.substr(sum)) != all.substr(0, sum)) return {};
  const auto* bytes = reinterpret_cast<const std::byte*>(all.data());
  MessageReader reader({bytes + sum, bytes + all.size()});
  Truth truth;
  truth.method = reader.get_text();
  truth.least_error = reader.get<double>();
  truth.frames.resize(reader.get<std::uint64_t>());
  for (particles::State& state : truth.frames)
    for (Eigen::VectorXd* part : {&state.x, &state.v}) {
      const std::vector<double> values = reader.get_doubles();
      *part = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    }
  return truth;
}

double size_of(const std::vector<particles::State>& frames) {
  Eigen::AlignedBox3d box;
  for (const particles::State& state : frames)
    for (Eigen::Index at = 0; at < state.x.size(); at += 3)
      box.extend(Eigen::Vector3d(state.x.segment<3>(at)));
  return box.diagonal().norm();
}

}  // namespace

Truth true_motion(const StudiedPart& part, const std::optional<fs::path>& kept) {
  const fs::path file = kept ? *kept / (sha256(part.json) + ".motion") : "";
  std::optional<Truth> found = kept ? read_kept(file) : std::nullopt;
  if (!found) {
    found = by_cvode(part);
    if (!found) found = by_many_steps(part);
    if (kept) keep(file, *found);
  }
  found->size = size_of(found->frames);
  return *std::move(found);
}

}  // namespace grader::judge
