#include "hair/lab/commands/command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/finish_output.h"
#include "hair/lab/run/stub.h"
#include "solver/decimal_point.h"
#include "solver/not_in_course.h"

namespace hair {

namespace {

Course course_of_program(const std::optional<std::filesystem::path>& file) {
  Course course = read_course(HAIR_EXERCISES_JSON, file);
  mark_stubs(course, kStubs);
  return course;
}

int run_command(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[],
                const std::function<void(const Course&)>& overview) {
  std::optional<std::filesystem::path> course_file;
  for (const Command& command : commands)
    command.app->add_option("--course", course_file,
                            "A course file: the exercises that there are (default: this build's)");
  try {
    if (argc == 1 && overview)
      if (const Course course = course_of_program({});
          std::ranges::any_of(course.exercises, &Exercise::stub)) {
        overview(course);
        return 0;
      }
    app.require_subcommand(1);
    app.parse(argc, argv);
    const auto asked = std::ranges::find_if(commands, [](const Command& one) { return one.app->parsed(); });
    return asked->run(course_of_program(course_file));
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hairlab: " << error.what() << "; see hairlab --help\n";
    return kBadInput;
  } catch (const BadInput& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBadInput;
  } catch (const NotInCourse& left_out) {
    std::cerr << "hairlab: " << left_out.what()
              << "; take it out of the scene, or build with a course that has it\n";
    return kBadInput;
  } catch (const NotImplemented& stub) {
    std::cerr << "hairlab: this needs " << missing_part(stub) << "\n";
    return kNotWritten;
  } catch (const std::exception& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBroke;
  }
}

}  // namespace

int run_program(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[],
                const std::function<void(const Course&)>& overview) {
  begin_output();
  const solver::DecimalPoint point;  // an exercise may call setlocale
  return finish_output("hairlab", run_command(app, commands, argc, argv, overview));
}

}  // namespace hair
