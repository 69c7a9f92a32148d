// STAFF ONLY. Writes feedback under the names of attachments, for Canvas, and under participants' numbers,
// for Moodle.
#include "grader/gradebook/feedback.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "grader/course/input.h"
#include "grader/roster/roster.h"
#include "grader/roster/worksheet.h"
#include "grader/text/letters.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline gradebook {
namespace {

enum class Form { page, zip, tar_gz, text };  // the best comes first

struct Opens {
  const char* ending;
  Form form;
};
constexpr std::array kOpens = {
    Opens{".html", Form::page},     Opens{".htm", Form::page},   Opens{".zip", Form::zip},
    Opens{".tar.gz", Form::tar_gz}, Opens{".tgz", Form::tar_gz}, Opens{".txt", Form::text},
    Opens{".md", Form::text},       Opens{".cpp", Form::text},   Opens{".cc", Form::text},
    Opens{".cxx", Form::text},      Opens{".hpp", Form::text},   Opens{".h", Form::text},
    Opens{".c", Form::text},        Opens{".log", Form::text}};

std::optional<Form> form_of(const std::string& file) {
  const std::string name = lowered(file);
  for (const Opens& one : kOpens)
    if (name.ends_with(one.ending)) return one.form;
  return {};
}

struct Attachment {
  std::string person, number, file;
  std::string path() const {
    return (person.starts_with("anon_") ? "" : "x_") + person + "_" + number + "_" + file;
  }
};

// Reads "doejane_LATE_4711_90001_main.cpp", or "anon_aB3dE_90021_main.cpp", of this person. A group's name
// may have numbers of its own.
std::optional<Attachment> attachment(const std::string& path, const Owner& owner) {
  const std::string name = "_" + path.substr(path.rfind('/') + 1), id = "_" + owner.id + "_";
  if (name.starts_with("_._")) return {};
  for (std::size_t at = name.find(id); at != name.npos; at = name.find(id, at + 1)) {
    const std::string rest = name.substr(at + id.size());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    const bool anonymous = owner.anonymous && name.substr(0, at).ends_with("_anon");
    if (digits == 0 || rest.substr(digits, 1) != "_" || (owner.anonymous && !anonymous)) continue;
    // Canvas takes it for a link that was handed in.
    if (rest.compare(rest.rfind('_') + 1, 4, "link") == 0) return {};
    return Attachment{(anonymous ? "anon_" : "") + owner.id, rest.substr(0, digits), rest.substr(digits + 1)};
  }
  return {};
}

std::string packed(Form form, const std::string& page) {
  const hair::TemporaryFolder folder("feedback");
  const std::vector<ArchiveEntry> entries{{.path = "report.html", .bytes = page, .link = ""}};
  if (form == Form::zip)
    write_zip(folder.path() / "x", entries);
  else
    write_tar_gz(folder.path() / "x", entries);
  return hair::bytes_of(folder.path() / "x");
}

// Returns the word in "Participant 4711", in the worksheet's language.
std::string word_of(const std::string& identifier) {
  return squeezed(identifier.substr(0, identifier.find_last_not_of("0123456789") + 1));
}

}  // namespace

Feedback feedback_for_canvas(const std::vector<std::string>& files, const std::vector<Grade>& grades,
                             const ReportOf& report) {
  Feedback feedback;
  std::map<std::string, std::string> taken;  // by the file's name
  std::size_t as_text = 0, as_archive = 0;
  for (const Grade& grade : grades) {
    std::optional<Attachment> best;
    std::string seen;
    for (const std::string& file : files) {
      const std::optional<Attachment> one =
          grade.owner.id.empty() ? std::nullopt : attachment(file, grade.owner);
      if (!one) continue;
      seen = one->file;
      if (form_of(one->file) && (!best || *form_of(one->file) < *form_of(best->file))) best = one;
    }
    if (!best) {
      feedback.said.push_back(grade.hand_in + ": gets no feedback: " +
                              (seen.empty() ? "no file in the download is an attachment of this student, and "
                                              "Canvas takes feedback by their names alone"
                                            : "nothing that we can write opens as " + composed(seen) +
                                                  ", under whose name Canvas would hand it out"));
      continue;
    }
    const auto [other, is_new] = taken.emplace(best->path(), grade.hand_in);
    if (!is_new) {
      feedback.said.push_back(grade.hand_in + ": gets no feedback: its attachment is " + other->second +
                              "'s, too");
      continue;
    }
    const Form form = *form_of(best->file);
    const ReportOfStudent theirs = report(grade.hand_in);
    feedback.entries.push_back({.path = best->path(),
                                .bytes = form == Form::page   ? theirs.page
                                         : form == Form::text ? theirs.text
                                                              : packed(form, theirs.page),
                                .link = ""});
    as_text += form == Form::text;
    as_archive += form == Form::zip || form == Form::tar_gz;
  }
  if (as_archive > 0)
    feedback.said.push_back(
        std::to_string(as_archive) +
        " get an archive with report.html in it, under the name of the archive that they handed in");
  if (as_text > 0)
    feedback.said.push_back(std::to_string(as_text) +
                            " get the report as plain text under the name of a file that they handed in, "
                            "such as main.cpp: tell them");
  feedback.said.emplace_back("Canvas takes no scores from this archive: give those by its gradebook");
  return feedback;
}

Feedback feedback_for_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const ReportOf& report) {
  std::size_t identifier = column_of(worksheet, "Identifier");
  if (identifier == kNoColumn)
    if (const std::optional<Worksheet> sheet = worksheet_by_form(worksheet)) identifier = sheet->identifier;
  if (identifier == kNoColumn)
    throw BadInput(
        place_of(worksheet, worksheet.rows.front()) +
        ": no title is \"Identifier\", and the table has not the form of a worksheet, which begins with "
        "\"Participant 4711\"; download the grading worksheet of the assignment");
  const Roster roster(worksheet);
  std::map<std::size_t, std::string> words;
  for (const Csv::Row& row : worksheet.rows) words[row.line] = word_of(composed(row.at(identifier)));

  Feedback feedback;
  std::map<std::string, std::vector<const Grade*>> by_number;
  for (const Grade& grade : grades) {
    const bool members = !grade.owner.members.empty();
    for (const Owner& owner : members ? grade.owner.members : std::vector{grade.owner}) {
      const Roster::Match match = roster.find(owner, "moodle");
      std::string why_not = match.told;
      if (match.person && why_not.empty()) {
        const Person& person = roster.people()[*match.person];
        // A blind worksheet has no names, and a download of teams no participants.
        if (person.name.empty() && !owner.name.empty() && squeezed(owner.name) != words[person.line] &&
            !owner.anonymous)
          why_not = "number " + owner.id + " is a participant's in the worksheet, and " +
                    composed(owner.name) + " is a team's name or another person's";
        else
          by_number[person.id(IdKind::participant)].push_back(&grade);
      }
      if (!why_not.empty())
        feedback.said.push_back(grade.hand_in +
                                (members ? ", " + composed(owner.name.empty() ? owner.id : owner.name) : "") +
                                ": gets no feedback: " + why_not);
    }
  }
  for (const auto& [number, theirs] : by_number) {
    if (theirs.size() > 1) {
      feedback.said.push_back("participant " + number + ": gets no feedback: both " + theirs[0]->hand_in +
                              " and " + theirs[1]->hand_in + " are theirs");
      continue;
    }
    std::string who = theirs[0]->hand_in;
    std::ranges::replace(who, '_', '-');  // Moodle splits at it
    feedback.entries.push_back({.path = who + "_" + number + "_assignfeedback_file/report.html",
                                .bytes = report(theirs[0]->hand_in).page,
                                .link = ""});
  }
  feedback.said.emplace_back(
      "each gets report.html as a feedback file; Moodle takes no grades from this archive: give those by its "
      "worksheet");
  return feedback;
}

}  // namespace grader::gradebook
