# STAFF ONLY. The page of `hairlab live` in a browser.
import os
import signal
import subprocess

from selenium.webdriver.common.action_chains import ActionChains

from browser import HAIRLAB, PageTest, main


class LivePage(PageTest):
    def setUp(self):
        self.server = subprocess.Popen([HAIRLAB, "live", "strand-swing"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        self.driver.get(self.server.stdout.readline().strip())
        self.wait_for("return window.hairView && hairView.pictures > 0")

    def tearDown(self):
        self.server.send_signal(signal.SIGTERM)
        self.assertEqual(self.server.wait(), 0)
        self.server.stdout.close()
        self.driver.get("about:blank")
        self.complaints()  # for a page whose server ended

    def wait_for_state(self, part):
        self.wait_for("return document.getElementById('state').textContent.includes(arguments[0])", part)

    def test_plays_to_its_end_without_complaints(self):
        self.wait_for_state("It is over")
        self.assertEqual(self.run_script("return hairView.runs[0].frames"), 91)
        self.assertGreater(self.share_drawn(), 0.0005)
        self.assertEqual(self.complaints(), [])
        self.assertIn("91 frames", self.text("words"))
        self.run_script("document.getElementById('restart').click()")
        self.wait_for_state("running")
        self.assertEqual(self.text("words"), "", "they tell of this run")

    def test_has_no_sideways_scroll(self):
        self.check_no_sideways_scroll()

    def test_has_no_findings_of_axe(self):
        self.check_no_findings_of_axe()

    def test_goes_by_keys_alone(self):
        for name in ("picture", "play", "step", "restart", "time", "step-size", "stiffness", "wind", "method", "drag"):
            self.assertIn(name, self.reached_by_tab())
        self.go_to("picture")
        self.press("r")
        self.wait_for_state("running")
        self.press(" ")
        self.wait_for_state("paused after step")
        before = self.text("state")
        self.press(".")
        step = int(before.split()[-1]) + 1
        self.wait_for_state(f"paused after step {step}")
        self.press(" ")
        self.wait_for_state("It is over")

    def test_takes_the_roots_by_mouse_and_goes_on_beyond_the_end(self):
        self.wait_for_state("It is over")
        self.run_script("document.getElementById('drag').value = 'root'")
        root = "const r = hairView.runs[0]; return [...r.places(r.frames - 1, 0).slice(0, 3)]"
        start = self.run_script(root)
        picture = self.driver.find_element("id", "picture")
        for way in ((150, 0), (-300, -60)):
            ActionChains(self.driver).drag_and_drop_by_offset(picture, *way).perform()
        self.wait_for_state("running")
        self.wait_for("const r = hairView.runs[0], x = r.places(r.frames - 1, 0); return x[0] < arguments[0] - 0.05 "
                      "&& x[2] > arguments[1] + 0.01", start[0], start[2])
        self.assertGreater(self.run_script("return hairView.runs[0].frames"), 91)
        self.assertEqual(self.complaints(), [])

    def test_says_where_it_blew_up_and_starts_anew(self):
        self.run_script("""const method = document.getElementById("method");
            method.value = "forward_euler"; method.dispatchEvent(new Event("change"))""")
        self.wait_for_state("It blew up: strand 0, step ")
        self.run_script("""const method = document.getElementById("method");
            method.value = "implicit_euler"; method.dispatchEvent(new Event("change"))""")
        self.wait_for_state("It is over")

    def test_names_a_crash_and_goes_on_with_new_code(self):
        self.wait_for_state("It is over")  # "running" belongs to the next run
        self.go_to("restart")
        self.press(" ")
        self.wait_for_state("running")
        children = subprocess.run(["pgrep", "-P", str(self.server.pid)], check=True, capture_output=True,
                                  text=True).stdout
        os.kill(int(children.split()[0]), signal.SIGSEGV)
        self.wait_for_state("The code crashed after step")
        os.utime(HAIRLAB + "-live")
        self.wait_for_state("It is over")


if __name__ == "__main__":
    main()
