// hairlab solver from outside: what it writes, and what it returns.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(HairlabSolver, WritesAPageNumbersAndTablesAndReplacesItsOwn) {
  const TestFolder folder;
  for (int run = 0; run < 2; ++run) {
    const ProgramRun done = run_hairlab({"solver", "--quick", "--out", (folder / "out").string()});
    ASSERT_EQ(done.code, 0) << done.errors;
    EXPECT_EQ(done.errors, "") << "it is quiet in a pipe";
  }
  EXPECT_EQ(folder.names("out"),
            (std::vector<std::string>{"convergence.csv", "digits.csv", "direct.csv", "index.html",
                                      "iterations.csv", "products.csv", "solver.json"}));
  const Json json = Json::parse(bytes_of(folder / "out/solver.json"));
  EXPECT_EQ(json["program"], "hairlab solver");
  EXPECT_TRUE(json["left_out"].is_null());
  EXPECT_EQ(json["digits"].size(), 8);
  const std::string page = bytes_of(folder / "out/index.html");
  for (const char* figure : {"error-against-iterations", "squared-residual-against-iterations",
                             "error-against-time", "error-for-clusters", "squared-residual-for-clusters",
                             "error-for-clusters-against-time", "strand-error-against-products",
                             "strand-squared-residual-against-iterations", "strand-error-against-time",
                             "iterations-against-condition", "error-against-condition", "product-cost"})
    EXPECT_NE(page.find("id=\"" + std::string(figure) + "\""), std::string::npos) << figure;
}

TEST(HairlabSolver, AStubIsNamedAndNothingIsWritten) {
  const TestFolder folder;
  const ProgramRun run =
      run_hairlab({"solver", "--quick", "--out", (folder / "out").string()}, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.errors.find("S1: student/conj_grad.cpp, ConjGrad is not implemented yet"), std::string::npos)
      << run.errors;
  EXPECT_TRUE(folder.names().empty());
}

TEST(HairlabSolver, AnInterruptionLeavesNothing) {
  const TestFolder folder;
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    // As soon as it studies, its hidden folder is there.
    const fs::path studying = folder / (".hairlab-out-" + std::to_string(process));
    EXPECT_TRUE(wait_until([&] { return fs::exists(studying); }, process));
    kill(process, SIGINT);
  };
  const ProgramRun run = run_hairlab({"solver", "--out", (folder / "out").string()}, settings);
  EXPECT_EQ(run.code, 130);
  EXPECT_NE(run.errors.find("interrupted; nothing is written"), std::string::npos) << run.errors;
  EXPECT_TRUE(folder.names().empty());
}

TEST(HairlabSolver, AFolderOfSomethingElseIsRefused) {
  const TestFolder folder;
  folder.write("precious.txt", "mine");
  const ProgramRun run = run_hairlab({"solver", "--quick", "--out", folder.path().string()});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(bytes_of(folder / "precious.txt"), "mine");
  EXPECT_EQ(run_hairlab({"solver"}).code, 2) << "--out is missing";
}

}  // namespace
}  // namespace hair
