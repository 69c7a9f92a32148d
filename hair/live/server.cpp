#include "hair/live/server.h"

#include "hair/io/plot/html.h"
#include "hair/live/live.h"
#include "hair/live/live_script.h"
#include "hair/view/page_scripts.h"

namespace hair {

namespace {

constexpr auto kHeartbeat = std::chrono::seconds(2);  // the next heartbeat notices a page that is closed
constexpr unsigned kMostStreams = 5;
constexpr std::size_t kMostCommandBytes = 200;

// Letters, digits, and characters of numbers.
bool is_command(const std::string& text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.+- ") == std::string::npos;
}

std::string page_of(const LiveOptions& options) {
  const Html body = html(R"(<main class="view">
<h1>{}, live</h1>
<p id="shows">{}</p>
<noscript><p>This page needs JavaScript, which this browser does not run.</p></noscript>
<p id="note" role="status"></p>
<p id="state" role="status">starting</p>
<canvas id="picture" tabindex="0" role="img" aria-label="The simulation"></canvas>
<div class="controls">
<button id="play" type="button">Pause</button>
<button id="step" type="button">One step</button>
<button id="restart" type="button">Restart</button>
<input id="time" type="range" min="0" max="0" value="0" aria-label="Frame"/>
<label>speed <select id="rate"><option value="1">as it is</option><option value="0.5">half</option><option value="0.25">a quarter</option><option value="0.1">a tenth</option></select></label>
<label>colour <select id="colour"></select></label>
<label>a drag <select id="drag"><option value="camera">moves the camera</option><option value="root">takes the roots</option><option value="turn">turns the roots</option></select></label>
</div>
<div class="controls">
<label>step <input id="step-size" type="range" min="-5" max="5" step="1" value="0"/></label><output id="step-words" for="step-size"></output>
<label>stiffness <input id="stiffness" type="range" min="-3" max="3" step="0.25" value="0"/></label><output id="stiffness-words" for="stiffness"></output>
<label>wind <input id="wind" type="range" min="0" max="20" step="0.5" value="0"/></label><output id="wind-words" for="wind"></output>
<label>method <select id="method"></select></label>
</div>
<p id="moment" class="quiet"></p>
<div id="plots"></div>
<h2>In words</h2>
<div id="words"></div>
<p class="quiet">Other steps, another stiffness, wind or method start it anew. A hand that takes the roots is at most 2 m/s fast; what breaks in it starts anew. Drag to turn, with shift to move, and use the wheel or two fingers to come nearer. Arrow keys turn, + and - come nearer and go away, 0 goes back. Space goes on and pauses; full stop makes one step, r starts anew.</p>
</main>
)",
                         {options.name, options.shows});
  return html_page(options.name + ", live", body, {{"\"use strict\";\n" + kPageScripts + kLiveScript}, true});
}

}  // namespace

LiveServer::LiveServer(const LiveOptions& options, const MessageLog& log,
                       std::function<void(const std::string&)> command)
    : page_(page_of(options)),
      log_(log),
      command_(std::move(command)),
      server_(options.port, kMostCommandBytes,
              [this](const WebRequest& request) { return answer(request); }) {}

WebAnswer LiveServer::answer(const WebRequest& request) {
  if (request.path.empty() && !request.changes) return {200, page_, kHtmlType};
  if (request.path == "events" && !request.changes) return stream();
  if (request.path != "command" || !request.changes) return {404};
  if (!is_command(request.body)) return {400, "no command\n"};
  command_(request.body);
  return {204};
}

WebAnswer LiveServer::stream() {
  const auto place = std::make_shared<MessageLog::Place>();
  const bool too_many = ++streams_ > kMostStreams;
  const std::shared_ptr<void> open(nullptr, [this](void*) { --streams_; });
  if (too_many) return {503, "too many pages of this server are open; close one\n"};
  command_(kPageOpened);
  return {200, "", "text/event-stream", [this, place, open]() -> std::optional<std::string> {
            const MessageLog::Message message = log_.next(*place, kHeartbeat);
            if (log_.closed()) return {};
            return message ? "data: " + *message + "\n\n" : ":\n\n";
          }};
}

}  // namespace hair
