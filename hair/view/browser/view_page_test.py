# STAFF ONLY. The page of `hairlab view`, opened from disk in a browser without a network.
import csv
import re
from pathlib import Path

from browser import PageTest, WITHOUT_WEBGL, hairlab, main

FRAMES = 20
SCRUBBED_TO = 13


class ViewPage(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.run_folder = Path(cls.folder.name) / "run"
        hairlab("run", "strand-swing", "--no-render", "--frames", FRAMES, "--out", cls.run_folder)
        hairlab("view", cls.run_folder)
        with open(cls.run_folder / "states.csv", encoding="utf-8") as file:
            cls.states = list(csv.DictReader(file))

    def setUp(self):
        self.driver.get(f"file://{self.run_folder}/view.html")
        self.wait_for("return window.hairView && hairView.pictures > 0")

    def stop(self):
        self.run_script("hairView.clock.stop(); hairView.seek(0)")

    def test_opens_without_a_network_and_without_complaints(self):
        self.assertEqual(self.complaints(), [])
        self.assertEqual(self.run_script("return performance.getEntriesByType('resource').map((one) => one.name)"), [])
        self.assertEqual(self.text("note"), "")
        self.assertGreater(self.share_drawn(), 0.0005)

    def test_has_no_sideways_scroll(self):
        self.check_no_sideways_scroll()

    def test_plays_by_itself_to_its_end_and_says_so(self):
        self.wait_for("return !hairView.clock.playing")
        self.wait_for("return document.getElementById('moment').textContent.startsWith(arguments[0])", f"Frame {FRAMES} of {FRAMES}")
        self.assertEqual(self.text("play"), "Play")

    def test_is_coarser_while_it_moves_if_pictures_take_long(self):
        self.run_script("""const read = WebGL2RenderingContext.prototype.readPixels;
            WebGL2RenderingContext.prototype.readPixels = function(...all) {
              for (const end = performance.now() + 100; performance.now() < end;);
              return read.apply(this, all);
            };
            hairView.clock.rate = 0.01; hairView.seek(0); hairView.clock.play();""")
        wide = "return picture.width / Math.round(picture.clientWidth * devicePixelRatio)"
        self.wait_for(wide + " < 0.6")
        self.stop()
        self.wait_for(wide + " === 1")

    def test_plays_again_at_the_end_of_the_longer_run(self):
        short, page = Path(self.folder.name) / "short", Path(self.folder.name) / "both.html"
        hairlab("run", "strand-swing", "--no-render", "--frames", FRAMES // 2, "--out", short)
        hairlab("view", short, "--with", self.run_folder, "--out", page)
        self.driver.get(f"file://{page}")
        self.wait_for("return window.hairView && hairView.pictures > 0")
        self.stop()
        self.go_to("time")
        self.press("\ue010")
        self.wait_for("return document.getElementById('moment').textContent.startsWith(arguments[0])", f"Frame {FRAMES} of {FRAMES}")
        self.go_to("play")
        self.press(" ")
        self.assertTrue(self.run_script("return hairView.clock.time < hairView.runs[0].duration"))

    def test_says_how_many_of_many_strands_are_shown(self):
        page = Path(self.folder.name) / "head.html"
        said = hairlab("view", "head-of-hair", "--out", page).stderr
        shown = int(re.fullmatch(r"head-of-hair: the page shows (\d+) of 22000 strands, and only these are computed\n", said)[1])
        self.assertLess(page.stat().st_size, 12e6)
        self.driver.get(f"file://{page}")
        self.wait_for("return window.hairView && hairView.pictures > 0")
        self.assertIn("22,000 hairs", self.text("shows"))
        self.assertRegex(self.text("words"), f"^22,000 strands, 61 frames.*{shown:,} strands of them are shown. Only they were computed")
        self.stop()
        self.wait_for("return document.getElementById('moment').textContent === 'Frame 0 of 60, 0 s'")

    def test_goes_by_keys_alone(self):
        self.stop()
        for name in ("picture", "play", "time", "rate", "colour"):
            self.assertIn(name, self.reached_by_tab())
        self.go_to("play")
        self.press(" ")
        self.wait_for("return hairView.clock.playing")
        self.press(" ")
        self.wait_for("return !hairView.clock.playing")
        self.run_script("hairView.seek(0)")
        self.go_to("picture")
        self.press(".", ".", ".", ",")
        self.wait_for("return document.getElementById('moment').textContent.startsWith('Frame 2 of')")
        before = self.run_script("return [hairView.orbit.yaw, hairView.orbit.pitch, hairView.orbit.distance]")
        self.press("\ue012", "\ue013", "+")
        after = self.run_script("return [hairView.orbit.yaw, hairView.orbit.pitch, hairView.orbit.distance]")
        for a, b, what in zip(before, after, ("yaw", "pitch", "distance")):
            self.assertNotAlmostEqual(a, b, msg=what)
        self.press("0")
        self.assertEqual(self.run_script("return [hairView.orbit.yaw, hairView.orbit.pitch, hairView.orbit.distance]"), before)

    def test_shows_the_frame_that_it_is_scrubbed_to(self):
        self.stop()
        self.go_to("time")
        self.press("\ue011", *["\ue014"] * SCRUBBED_TO)
        self.wait_for("return document.getElementById('moment').textContent.startsWith(arguments[0])", f"Frame {SCRUBBED_TO} of {FRAMES}")
        shown = self.run_script("return hairView.places()")
        low, high = self.run_script("return [hairView.runs[0].low, hairView.runs[0].high]")
        wanted = [float(row[axis]) for row in self.states if row["frame"] == str(SCRUBBED_TO) for axis in "xyz"]
        self.assertEqual(len(shown), len(wanted))
        # hair/view/motion.h's bound, and the rounding of 32 bits.
        bound = max(b - a for a, b in zip(low, high)) * (1 / 131070 + 1e-6)
        farthest = max(abs(a - b) for a, b in zip(shown, wanted))
        self.assertLess(farthest, bound)
        others = [float(row[axis]) for row in self.states if row["frame"] == str(SCRUBBED_TO + 1) for axis in "xyz"]
        self.assertGreater(max(abs(a - b) for a, b in zip(others, wanted)), 10 * bound, "the next frame is another one")

    def test_says_the_run_in_words(self):
        self.stop()
        self.wait_for("return document.getElementById('picture').getAttribute('aria-label').includes('Frame 0 of')")
        self.assertEqual(self.run_script("return document.getElementById('picture').getAttribute('role')"), "img")
        self.assertIn("Frame 0", self.run_script("return document.getElementById('time').getAttribute('aria-valuetext')"))
        self.assertEqual(self.run_script("return document.getElementById('note').getAttribute('role')"), "status")
        words = self.text("words")
        for part in (f"{FRAMES + 1} frames", "It ended as planned", "energy", "largest stretch"):
            self.assertIn(part, words)
        for label in self.run_script("return [...document.querySelectorAll('.plot canvas')].map((one) => one.getAttribute('aria-label'))"):
            self.assertIn("over time", label)
        unnamed = self.run_script("""return [...document.querySelectorAll("button, input, select")]
            .filter((one) => !(one.textContent.trim() && one.tagName === "BUTTON") &&
              !one.getAttribute("aria-label") && !one.labels?.length)
            .map((one) => one.id)""")
        self.assertEqual(unnamed, [])

    def test_has_no_findings_of_axe(self):
        self.check_no_findings_of_axe()

    def lose_context(self):
        self.run_script("window.card = document.getElementById('picture').getContext('webgl2').getExtension('WEBGL_lose_context'); card.loseContext()")

    def test_draws_lines_when_the_card_is_lost_and_as_before_when_it_comes_back_late(self):
        self.stop()
        self.lose_context()
        self.wait_for("return hairView.stage.plain")
        self.assertIn("was lost", self.text("note"))
        self.wait_for("return document.getElementById('picture').getContext('2d') !== null")
        self.assertGreater(self.share_drawn(), 0.0005)
        self.run_script("card.restoreContext()")
        self.wait_for("return !hairView.stage.plain")
        self.assertEqual(self.text("note"), "")
        self.wait_for("return document.getElementById('picture').getContext('webgl2') !== null")
        self.assertGreater(self.share_drawn(), 0.0005)

    def test_draws_as_before_when_the_card_comes_back(self):
        self.stop()
        self.lose_context()
        self.run_script("card.restoreContext()")
        self.wait_for("return !document.getElementById('picture').getContext('webgl2').isContextLost()")
        drawn = self.run_script("const before = hairView.pictures; hairView.seek(0); return before")
        self.wait_for("return hairView.pictures > arguments[0] + 1 || !hairView.seek(0) && false", drawn)
        self.assertFalse(self.run_script("return hairView.stage.plain"))
        self.assertGreater(self.share_drawn(), 0.0005)


class ViewPageWithoutWebGl(PageTest):
    flags = WITHOUT_WEBGL

    def test_draws_lines(self):
        page = Path(self.folder.name) / "view.html"
        hairlab("view", "strand-swing", "--out", page)
        self.driver.get(f"file://{page}")
        self.wait_for("return window.hairView && hairView.pictures > 0")
        self.assertIn("no WebGL2", self.text("note"))
        self.run_script("hairView.clock.stop(); hairView.seek(0)")
        self.assertGreater(self.share_drawn(), 0.0005)
        self.assertEqual(self.complaints(), [])


if __name__ == "__main__":
    main()
