#include "hair/live/live_page.h"

#include "hair/io/plot/html.h"
#include "hair/live/live_script.h"
#include "hair/view/page_scripts.h"

namespace hair {

std::string live_page(const std::string& name, const std::string& shows) {
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
                         {name, shows});
  return html_page(name + ", live", body, {{"\"use strict\";\n" + kPageScripts + kLiveScript}, true});
}

}  // namespace hair
