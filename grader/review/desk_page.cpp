// STAFF ONLY. Writes the desk's page.
#include "grader/review/desk_page.h"

#include <algorithm>
#include <set>

#include "grader/report/facts/text.h"
#include "grader/review/desk_script.h"
#include "grader/review/desk_style.h"

namespace grader::inline review {
namespace {

constexpr std::size_t kMostComments = 30, kMostNames = 12;

const char* look_of(ItemKind kind) {
  if (kind <= ItemKind::conflict) return "bad";
  return kind <= ItemKind::near_threshold ? "part" : "none";
}

// A request that nobody has answered.
bool asks(const Item& item) {
  return item.kind == ItemKind::request && !item.is_decided();
}

std::string person(const std::string& name, const DeskPeople& people) {
  return shown_name(name, people.names);
}

std::string title_of(const Item& item, const DeskPeople& people) {
  return item.people.size() == 1 ? person(item.people.front(), people)
                                 : std::to_string(item.people.size()) + " people";
}

// Says "H2.3, H2.4"; the exercise, if there are no categories.
std::string places_of(const Item& item) {
  std::string all;
  for (const std::string& one : item.categories) all += (all.empty() ? "" : ", ") + one;
  return all.empty() ? item.exercise : all;
}

Html option(const std::string& place, const std::string& text, bool chosen) {
  return html("<option value=\"{}\"{}>{}</option>", {place, chosen ? html(" selected=\"\"") : Html(), text});
}

std::string points_there(const std::string& place, const std::string& name, double points, double most) {
  return place + " " + name + ": " + shown_points(points) + " of " + shown_points(most);
}

// Offers the places of the item's exercise, or all exercises; the item's own comes first.
Html place_field(const OpenItem& open, bool with_categories, const Html& whole) {
  const Item& item = open.item;
  const std::string first = item.categories.empty() ? item.exercise : item.categories.front();
  Html options = whole;
  if (!open.results.empty())
    for (const ExerciseResult& one : open.results.front().exercises) {
      if (!item.exercise.empty() && one.id != item.exercise) continue;
      options += option(one.id, points_there(one.id, one.title, one.points, one.max_points), one.id == first);
      for (std::size_t i = 0; with_categories && !item.exercise.empty() && i < one.cases.size(); ++i) {
        const std::string place = one.id + "." + std::to_string(i + 1);
        options += option(
            place, points_there(place, one.cases[i].name, one.cases[i].points, one.cases[i].max_points),
            place == first);
      }
    }
  return html("<label>Where <select name=\"place\">{}</select></label>\n", {options});
}

Html dialog(const char* action, const std::string& heading, const Html& fields) {
  return html(R"(<dialog id="{}" aria-labelledby="{}-heading"><form method="dialog" data-do="{}">
<h3 id="{}-heading">{}</h3>
{}<p class="told" role="alert"></p>
<p class="buttons"><button type="submit">Save</button> <button type="submit" value="stay">Save and stay</button> <button type="button" data-close="">Cancel</button></p>
</form></dialog>
)",
              {action, action, action, action, heading, fields});
}

// Those that stand at the same place first, then at the same exercise, then the ones that most people have.
std::vector<Comment> likely_first(std::vector<Comment> comments, const Item& item) {
  const auto fits = [&](const Comment& comment) {
    int best = 0;
    for (const CommentUse& use : comment.uses) {
      if (std::ranges::find(item.categories, use.place) != item.categories.end()) best = 2;
      if (!item.exercise.empty() && use.place.starts_with(item.exercise)) best = std::max(best, 1);
    }
    return std::pair(-best, -static_cast<int>(comment.uses.size()));
  };
  std::ranges::stable_sort(comments, {}, fits);
  if (comments.size() > kMostComments) comments.resize(kMostComments);
  return comments;
}

Html used_comments(const OpenItem& open) {
  Html rows;
  std::size_t number = 0;
  for (const Comment& comment : likely_first(open.comments, open.item)) {
    ++number;
    const std::string points = comment.points == 0 ? ""
                                                   : " (" + std::string(comment.points > 0 ? "+" : "") +
                                                         shown_points(comment.points) + ")";
    rows += html("<li><button type=\"button\" data-comment=\"{}\">{}{}{}</button></li>\n",
                 {std::to_string(comment.id), number < 10 ? html("<kbd>{}</kbd> ", {number}) : Html(),
                  comment.text, points});
  }
  if (rows.text.empty()) return {};
  return html(
      "<p class=\"quiet\">Used before: press its digit, or write another one.</p>\n<ol class=\"used\" "
      "tabindex=\"-1\">\n{}</ol>\n",
      {rows});
}

Html why_field(const char* says) {
  return html("<label>{} <textarea name=\"text\" rows=\"3\" required=\"\"></textarea></label>\n", {says});
}

Html dialogs(const OpenItem& open) {
  const std::size_t count = open.item.people.size();
  const std::string for_all = count > 1 ? " for all " + std::to_string(count) + " people" : "";
  const Html points = html(
      "<label>Points <input name=\"number\" type=\"number\" step=\"any\" min=\"0\" "
      "required=\"\"/></label>\n");
  Html all =
      dialog("points", "Set points" + for_all,
             html("{}{}{}", {points, place_field(open, true, {}), why_field("Why? The student reads it")}));
  all += dialog(
      "comment", "Comment" + for_all,
      html("{}{}{}<label>Line of the file <input name=\"line\" type=\"number\" "
           "min=\"1\"/></label>\n<label>Points "
           "<input name=\"number\" type=\"number\" step=\"any\"/></label>\n",
           {used_comments(open), why_field("A new one. The student reads it"),
            place_field(open, true, open.item.exercise.empty() ? option("", "the whole", true) : Html())}));
  all += dialog(
      "excuse", "Excuse" + for_all,
      html("{}{}",
           {place_field(open, false, open.item.exercise.empty() ? option("", "everything", true) : Html()),
            why_field("Why? The student reads it")}));
  if (asks(open.item)) all += dialog("answer", "Answer", why_field("The student reads it"));
  return all;
}

Html button(const char* action, const char* key, const char* text) {
  return html("<button type=\"button\" data-action=\"{}\">{}{}</button>\n",
              {action, text, *key == '\0' ? Html() : html(" <kbd>{}</kbd>", {key})});
}

Html names_of(const Item& item, const DeskPeople& people) {
  Html all;
  for (std::size_t i = 0; i < item.people.size(); ++i) {
    const std::string& name = item.people[i];
    all += html("<li><a href=\"class/staff/{}.html{}{}\">{}</a>{}</li>\n",
                {name, item.exercise.empty() ? "" : "#", item.exercise, person(name, people),
                 report::folder_beside(name, people.names)});
  }
  return item.people.size() > kMostNames
             ? html("<details><summary>All {} people</summary>\n<ul class=\"who\">\n{}</ul></details>\n",
                    {item.people.size(), all})
             : html("<ul class=\"who\">\n{}</ul>\n", {all});
}

Html links_of(const std::string& name, const OpenItem& open) {
  const auto& result = open.results.front();
  return html(
      "<p class=\"quiet\">{} &#183; {} &#183; <a href=\"class/staff/{}.html\">All of the hand-in</a> &#183; "
      "<a "
      "href=\"class/{}/report.html\">The student&#39;s report</a></p>\n",
      {html("<code>{}</code>", {name}), report::shown_total(points(result), max_points(result)), name, name});
}

}  // namespace

Html row_of(const Item& item, const DeskPeople& people) {
  std::string words, section;
  for (const std::string& name : item.people) {
    const auto line = people.lines.find(name);
    words += " " + name + (item.people.size() > 1 ? " " + person(name, people) : "");
    if (line == people.lines.end()) continue;
    words += " " + line->second.id;
    section = line->second.section;
  }
  return html(
      "<li data-key=\"{}\" data-kind=\"{}\" data-exercise=\"{}\" data-section=\"{}\" data-owner=\"{}\" "
      "data-lost=\"{}\" data-words=\"{}\"{}><a href=\"#\" tabindex=\"-1\"><span "
      "class=\"name\">{}</span><span "
      "class=\"number\">{}</span><span class=\"quiet\">{}{}</span><span class=\"quiet "
      "number\">{}</span></a></li>\n",
      {item.key(), word_of(item.kind), item.exercise, section, item.owner, std::to_string(item.lost), words,
       item.is_decided() ? html(" class=\"decided\"") : Html(), title_of(item, people),
       item.lost > 0 ? html("&#8722;{}", {report::shown_points(item.lost)}) : Html(), heading_of(item.kind),
       places_of(item).empty() ? "" : ", " + places_of(item), item.is_decided() ? item.decided_by : ""});
}

Html item_part(const OpenItem& open, const DeskPeople& people) {
  const Item& item = open.item;
  Html all = html(
      "<article data-key=\"{}\" data-version=\"{}\" data-accept=\"{}\">\n<header>\n<p class=\"line\"><span "
      "class=\"badge {}\">{}</span><span>{}</span><span class=\"quiet\">{}</span></p>\n<h2 "
      "tabindex=\"-1\">{}</h2>\n{}\n",
      {item.key(), item.version, asks(item) ? "answer" : "accept", look_of(item.kind), heading_of(item.kind),
       places_of(item), item.owner.empty() ? "" : "for " + item.owner, title_of(item, people),
       html(item.kind == ItemKind::request ? "<blockquote>{}</blockquote>" : "<p>{}</p>", {item.why})});
  if (item.people.size() > 1)
    all += names_of(item, people);
  else if (!open.results.empty())
    all += links_of(item.people.front(), open);
  if (!open.reproduce.empty()) all += html("<p class=\"quiet\"><code>{}</code></p>\n", {open.reproduce});
  if (!open.opened_by.empty())
    all += html("<p class=\"note\">{} has this open, too.</p>\n", {open.opened_by});
  for (const std::string& line : open.decisions) all += html("<p class=\"note\">{}</p>\n", {line});
  if (item.is_decided())
    all += html("<p class=\"line\"><span class=\"badge good\">decided</span><span>by {}, {} UTC</span></p>\n",
                {item.decided_by, item.decided_at});
  all += html("</header>\n<div class=\"actions\" role=\"group\" aria-label=\"What to do with this\">\n");
  all += asks(item) ? button("answer", "a", "Answer") : button("accept", "a", "Accept");
  all += button("points", "e", "Points");
  all += button("comment", "c", "Comment");
  all += button("excuse", "", "Excuse");
  if (item.place == kLate) all += button("late_days", "", "Give a day");
  if (item.kind == ItemKind::conflict) all += button("unset", "", "Unset");
  if (item.is_decided()) all += button("reopen", "", "Not decided");
  all += html("</div>\n<div class=\"what\">\n");
  for (const SubmissionResult& result : open.results) {
    if (item.people.size() > 1)
      all += html("<p class=\"line\"><strong>One of them: {}</strong></p>\n", {person(result.name, people)});
    all += report::staff_part(result, item.exercise, "class/staff/");
  }
  return all += html("</div>\n{}</article>\n", {dialogs(open)});
}

Html nothing_left() {
  return html(
      "<article data-key=\"\">\n<h2 tabindex=\"-1\">Nothing waits for a decision here</h2>\n<p>Other items "
      "may be "
      "hidden by the filters, or somebody else&#39;s.</p>\n</article>\n");
}

Html progress_part(const std::vector<ProgressOfTa>& progress) {
  Html all;
  for (const ProgressOfTa& one : progress)
    all += one.items > 0 ? html("<span><strong>{}</strong> {} of {}</span>\n",
                                {one.who.empty() ? "nobody's" : one.who, one.decided, one.items})
                         : html("<span><strong>{}</strong> {} decided</span>\n", {one.who, one.has_decided});
  return all;
}

std::string desk_page(const std::string& who, const std::string& where, const Html& rows, std::size_t stamp,
                      const std::vector<ProgressOfTa>& progress, const Html& item) {
  Html kinds, owners;
  for (int i = 0; i < kItemKinds; ++i)
    kinds += option(word_of(static_cast<ItemKind>(i)), heading_of(static_cast<ItemKind>(i)), false);
  bool has_mine = false;
  for (const ProgressOfTa& one : progress) {
    has_mine = has_mine || (one.who == who && one.items > 0);
    if (!one.who.empty() && one.who != who) owners += option(one.who, one.who + "'s", false);
  }
  const Html body = html(
      R"(<style>{}</style>
<header class="top">
<h1>{}</h1>
<p class="line" id="progress">{}</p>
<p class="line"><a href="class/index.html">The class</a> <button type="button" data-action="help">Keys <kbd>?</kbd></button></p>
</header>
<noscript><p class="note">This page needs JavaScript, which this browser does not run.</p></noscript>
<main class="desk" data-who="{}">
<section class="side" aria-label="Items">
<div class="filters">
<input id="search" type="search" placeholder="name, id, H2.3" aria-label="Search"/>
<select id="whose" aria-label="Whose"><option value="{}"{}>mine</option><option value="*"{}>everybody's</option>{}</select>
<select id="kind" aria-label="Kind"><option value="">all kinds</option>{}</select>
<select id="sort" aria-label="Order"><option value="">as urgent</option><option value="lost">by points lost</option></select>
<label><input id="undecided" type="checkbox" checked=""/> undecided only</label>
</div>
<div class="steps"><button type="button" data-action="next">Down <kbd>j</kbd></button> <button type="button" data-action="back">Up <kbd>k</kbd></button> <button type="button" data-action="undecided">Undecided <kbd>u</kbd></button> <button type="button" data-action="undo">Undo <kbd>z</kbd></button></div>
<p id="count" class="quiet"></p>
<ol id="list" data-stamp="{}">
{}</ol>
</section>
<section class="item" aria-label="Item">
<p id="told" role="status"></p>
<div id="item" aria-busy="false">{}</div>
</section>
</main>
<dialog id="help" aria-labelledby="help-heading"><form method="dialog">
<h2 id="help-heading">Keys</h2>
<dl><dt><kbd>j</kbd> <kbd>k</kbd></dt><dd>down and up the list</dd><dt><kbd>u</kbd></dt><dd>the next one that is undecided</dd><dt><kbd>a</kbd></dt><dd>accept it as it is; answer a request</dd><dt><kbd>c</kbd></dt><dd>comment; then a digit takes one that was used before</dd><dt><kbd>e</kbd></dt><dd>set points</dd><dt><kbd>z</kbd></dt><dd>undo your last decision</dd><dt><kbd>?</kbd></dt><dd>this help</dd></dl>
<p class="quiet">Keys do nothing while you write, or while a box like this is open. After a decision the next item comes; it is saved before.</p>
<label><input id="keys" type="checkbox" checked=""/> use keys</label>
<p class="buttons"><button>Close</button></p>
</form></dialog>
)",
      {Html{kDeskStyle}, where, progress_part(progress), who, who, has_mine ? html(" selected=\"\"") : Html(),
       has_mine ? Html() : html(" selected=\"\""), owners, kinds, stamp, rows, item});
  return hair::html_page("Desk of " + who, body, {{hair::kDeskScript}, true}, hair::Pictures::beside);
}

}  // namespace grader::review
