// The commands that hairlab does not contain, because their code takes longer to build than hairlab's. They
// are in programs in hairlab's folder, and hairlab starts these.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace hair {

struct OtherProgram {
  const char* name;    // hairlab-study
  const char* target;  // hairlab_studies
};
inline constexpr OtherProgram kStudies = {"study", "studies"};
inline constexpr OtherProgram kShows = {"show", "shows"};
inline constexpr OtherProgram kGrooms = {"groom", "grooms"};
inline constexpr OtherProgram kLive = {"live", "live"};

struct OtherCommand {
  const char* name;
  const char* what;  // a line for --help
  const OtherProgram& program;
};

inline constexpr OtherCommand kSolverStudy = {
    "solver", "Study ConjGrad and the normal equations: error against iterations, products and time",
    kStudies};
inline constexpr OtherCommand kStabilityStudy = {
    "stability",
    "Map the step sizes with which each method is stable, beside theory, and what extreme cases do",
    kStudies};
inline constexpr OtherCommand kErrorStudy = {
    "study", "Error against run time, of each method that fits a scene", kStudies};
inline constexpr OtherCommand kValidation = {
    "validate", "Compare with what theory says: published numbers, exact solutions", kStudies};
inline constexpr OtherCommand kBowl = {
    "bowl", "Show the way of ConjGrad, and of the normal equations, to the bottom of a bowl", kShows};
inline constexpr OtherCommand kPhasePlane = {
    "phase", "Show a pendulum in the phase plane, by each of the four explicit methods", kShows};
inline constexpr OtherCommand kInfo = {"info", "Say what a groom is like, and what is odd about it", kGrooms};
inline constexpr OtherCommand kConvert = {"convert", "Write a groom in another format", kGrooms};
inline constexpr OtherCommand kGroom = {"groom", "Let hair grow on a head, in a style", kGrooms};
inline constexpr OtherCommand kPlayLive = {"live", "Play a scene while it is computed, in a browser", kLive};

inline constexpr std::array kOtherCommands = {kPlayLive,       kInfo,      kConvert,    kGroom,
                                              kErrorStudy,     kBowl,      kPhasePlane, kSolverStudy,
                                              kStabilityStudy, kValidation};

// Null for a command of hairlab's own.
const OtherCommand* other_command(std::string_view name);

// Replaces this process by the other program, with the same command line. Returns only if that fails, with
// the exit code. If the program is missing, or older than hairlab and so out of date, it prints how to build
// it. `what`: the command, for the message.
int hand_over(const OtherProgram& program, const std::string& what, char* argv[]);

}  // namespace hair
