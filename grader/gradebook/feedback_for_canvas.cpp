// STAFF ONLY. Writes feedback under the names of attachments.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

#include "grader/gradebook/feedback.h"
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

bool is_number(const std::string& field) {
  return !field.empty() && std::ranges::all_of(field, [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::vector<std::string> fields_of(const std::string& name) {
  std::vector<std::string> fields{""};
  for (const char c : name)
    if (c == '_')
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

// Reads "doejane_LATE_4711_90001_main.cpp", or "anon_aB3dE_90021_main.cpp", of this person. A group's name
// may have numbers of its own.
std::optional<Attachment> attachment(const std::string& path, const Owner& owner) {
  const std::string name = path.substr(path.rfind('/') + 1);
  if (name.starts_with("._")) return {};
  const std::vector<std::string> fields = fields_of(name);
  for (std::size_t i = 0; i + 2 < fields.size(); ++i) {
    const bool anonymous = owner.anonymous && i > 0 && fields[i - 1] == "anon";
    if (fields[i] != owner.id || !is_number(fields[i + 1]) || (owner.anonymous && !anonymous)) continue;
    Attachment found{(anonymous ? "anon_" : "") + owner.id, fields[i + 1], fields[i + 2]};
    for (std::size_t j = i + 3; j < fields.size(); ++j) found.file += "_" + fields[j];
    if (fields.back().starts_with("link")) return {};  // Canvas takes it for a link that was handed in
    return found;
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

}  // namespace grader::gradebook
