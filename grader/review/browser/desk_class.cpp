// STAFF ONLY. Writes a made class for the desk's tests: desk_class FOLDER PEOPLE. Names and messages are
// hostile.
#include <iostream>

#include "grader/class_folder/class_files.h"
#include "grader/report/facts/sample_results.h"

int main(int argc, char* argv[]) {
  using namespace grader;
  if (argc != 3) return 2;
  Record record(argv[1]);
  std::vector<SubmissionResult> results = class_of_ten_exercises(std::stoi(argv[2]));
  const std::string planted = "<script>window.planted=1</script><img src=x onerror=window.planted=2>\"'&amp;";
  results.push_back(submission_full_of(planted));
  results.back().exercises.front().pictures.clear();  // those of its kind are no pictures
  std::vector<HandIn> hand_ins;
  for (const SubmissionResult& result : results) {
    hand_ins.push_back({result.name, {.name = result.name + " " + planted, .id = result.name}, "canvas"});
    record.put({result});
  }
  record.put_people(hand_ins);
  record.ask(results.front().name, "", planted);
  write_class_files(argv[1], record);
}
