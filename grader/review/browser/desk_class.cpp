// STAFF ONLY. Writes a made class for the desk's tests: desk_class FOLDER PEOPLE. Names and messages are
// hostile.
#include <string>

#include "grader/class_folder/class_files.h"
#include "grader/report/facts/sample_results.h"
#include "grader/review/made_class.h"

int main(int argc, char* argv[]) {
  using namespace grader;
  if (argc != 3) return 2;
  Record record(argv[1]);
  put_made_class(record, std::stoul(argv[2]));
  const PictureResult near = sample_picture("", 1), far = sample_picture("", 30);
  for (const std::string& name : record.names()) {  // made pictures have no bytes
    Recorded one = *record.find(name);
    for (ExerciseResult& exercise : one.result.exercises)
      for (PictureResult& picture : exercise.pictures) {
        const bool is_far = picture.far_off;
        const std::string moment = picture.name;
        picture = is_far ? far : near;
        picture.name = moment;
        picture.far_off = is_far;
        exercise.motions = sample_motions(is_far ? 0.2 : 0.02);
      }
    record.put(one, {record.handed_in(name), name});
  }
  // Without a picture: "x" is none.
  const std::string planted = "<script>window.planted=1</script><img src=x onerror=window.planted=2>\"'&amp;";
  SubmissionResult mallory = submission_full_of(planted);
  mallory.exercises.front().pictures.clear();
  record.put({mallory});
  record.put_people({{mallory.name, {.name = planted, .id = planted}, "canvas"}});
  record.ask(mallory.name, "S1", planted);
  write_class_files(argv[1], record);
}
