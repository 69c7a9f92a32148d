# STAFF ONLY. Pictures and motions looked at closer: the viewer of a student's report, and of a run's page.
import os
import subprocess
from pathlib import Path

from browser import PageTest, main

MOST_BYTES = 30_000  # of the viewer's modules
SIZE = "20"  # people


class ViewerPage(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        subprocess.run([os.environ["DESK_CLASS"], cls.folder.name, SIZE], check=True)

    # A page that has what the pattern names, with the first of its pictures looked at.
    def look(self, pattern, button=".moment button"):
        folder = Path(self.folder.name)
        page = next(one for one in sorted(folder.glob(pattern))
                    if all(part in one.read_text(encoding="utf-8") for part in ("Look closer", 'class="moment"')))
        self.driver.get("about:blank")
        self.driver.get(page.as_uri() + "#time=0.5")
        self.wait_for("return document.querySelector(arguments[0])", button)
        self.run_script("document.querySelector(arguments[0]).click()", button)
        self.wait_for("return document.querySelector('.viewer h2')?.textContent")
        return page

    def heading(self):
        return self.run_script("return document.querySelector('.viewer h2').textContent")

    def values(self):
        return self.run_script("return document.querySelector('.viewer p:last-child').textContent")

    def pressed(self):
        return self.run_script("return [...document.querySelectorAll('.viewer [aria-pressed=true]')].map((one) => one.textContent.at(-1)).join()")

    def test_measures_again_what_the_page_says(self):
        for pattern in ("*/report.html", "staff/runs/*/*.html"):
            self.look(pattern)
            self.press("f")
            self.wait_for("return document.querySelector('.viewer h2').textContent.includes('in the mean')")
            mean = float(self.heading().split(" in the mean")[0].split()[-1])
            said = self.run_script("return document.querySelector('.viewer p').textContent")
            self.assertAlmostEqual(mean / float(said.split("FLIP ")[1].split(",")[0].split(";")[0]), 1, delta=0.01)
        self.assertEqual(self.complaints(), [])

    def test_is_worked_from_the_keyboard_and_named(self):
        self.look("*/report.html")
        self.assertEqual(self.run_script("return document.activeElement.tagName"), "CANVAS")
        self.assertEqual(self.pressed(), "s")
        for key, says in (("1", "Yours"), ("2", "The reference's"), ("d", "difference, 1 times"), ("d", "difference, 4 times"), ("d", "difference, 16 times"), ("f", "FLIP")):
            self.press(key)
            self.assertEqual(self.pressed(), key)
            self.assertIn(says, self.heading())
            self.assertIn(says, self.run_script("return document.activeElement.getAttribute('aria-label')"))
        first = self.heading()
        self.press(".")
        self.wait_for("return document.querySelector('.viewer h2').textContent !== arguments[0]", first)
        self.check_no_findings_of_axe()
        self.press("\ue00c")
        self.wait_for("return document.querySelector('.viewer') === null")  # a dialog tells that it is closed later

    # A pixel of the picture is a square of whole pixels of the screen, wherever it is looked at.
    def test_enlarges_both_by_whole_pixels(self):
        self.look("*/report.html")
        self.press("1", *"+" * 5)
        self.assertIn("enlarged", self.values())
        zoom = int(self.values().split("enlarged ")[1].split()[0])
        self.press("\ue014", "\ue015")
        even = self.run_script("""const canvas = document.querySelector(".viewer canvas"), zoom = arguments[0], context = canvas.getContext("2d");
            const { data } = context.getImageData(0, 0, 6 * zoom, 6 * zoom);
            const at = (x, y) => data.slice(4 * (6 * zoom * y + x), 4 * (6 * zoom * y + x) + 3).join();
            for (let y = 0; y < 6 * zoom; ++y)
              for (let x = 0; x < 6 * zoom; ++x)
                if (at(x, y) !== at(x - x % zoom, y - y % zoom)) return false;
            return true""", zoom)
        self.assertTrue(even)
        parts = self.values().split(":")[1].split("; ")[:3]
        one, other, apart = [[int(word) for word in part.replace("apart", "").split()[-3:]] for part in parts]
        self.assertEqual([abs(a - b) for a, b in zip(one, other)], apart)

    def test_goes_to_the_first_difference_of_two_runs_and_draws_them(self):
        page = self.look("staff/runs/*/*.html", "#runs button")
        self.assertIn("apart by up to", self.run_script("return document.querySelector('.viewer p').textContent"))
        self.wait_for("const { width } = document.querySelector('.viewer canvas'); return width > 500")
        self.press("d", "d", "d", ",")
        self.wait_for("return document.querySelector('.viewer h2').textContent.startsWith('0.4 s')")
        self.press("f")
        self.wait_for("return document.querySelector('.viewer h2').textContent.includes('in the mean')")
        self.assertEqual(float(self.heading().split(" in the mean")[0].split()[-1]), 0, "frames before the difference are drawn alike")
        self.driver.get("about:blank")
        self.driver.get(page.as_uri() + "#apart=1")
        self.wait_for("return window.hairView")
        self.assertAlmostEqual(self.run_script("return hairView.clock.time"), 0.5)
        self.assertEqual(self.complaints(), [])

    def test_is_small_and_fits(self):
        page = self.look("staff/runs/*/*.html").read_text(encoding="utf-8")
        script = page[page.index("// LDR-FLIP"):page.index("watchRuns(window.hairView)")]
        self.assertLess(len(script), MOST_BYTES)
        self.press("\ue00c")
        self.check_no_sideways_scroll()


if __name__ == "__main__":
    main()
