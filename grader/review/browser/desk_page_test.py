# STAFF ONLY. The desk in a browser: its keys, other TAs, reloads, Ctrl-C, hostile texts.
import os
import signal
import sqlite3
import subprocess
from pathlib import Path

from browser import PageTest, main

HAIRGRADE, DESK_CLASS = os.environ["HAIRGRADE"], os.environ["DESK_CLASS"]
SIZE = 30  # people


class Desk:
    """hairgrade review of a TA."""

    def __init__(self, grades, who, *more):
        self.process = subprocess.Popen([HAIRGRADE, "review", grades, "--as", who, *more],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def end(self, how=signal.SIGINT):
        self.process.send_signal(how)
        self.process.communicate()
        return self.process.returncode


class DeskPage(PageTest):
    flags = ["--disable-gpu"]

    def setUp(self):
        self.grades = Path(self.folder.name) / self._testMethodName
        self.grades.mkdir()
        subprocess.run([DESK_CLASS, self.grades, str(SIZE)], check=True)
        self.desk = Desk(self.grades, "ada")
        self.open(self.desk)

    def tearDown(self):
        self.assertIn(self.desk.end(), (0, -signal.SIGKILL))
        self.driver.get("about:blank")
        self.complaints()

    def open(self, desk):
        self.driver.get("about:blank")
        self.driver.get(desk.address)
        self.wait_for("return document.readyState === 'complete' && document.querySelector('#item > article')")

    def key(self):
        return self.run_script("return document.querySelector('#item > article').dataset.key")

    def press_and_wait(self, key):
        before = self.key()
        self.press(key)
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
        return self.key()

    def wait_told(self, part):
        self.wait_for("return document.getElementById('told').textContent.includes(arguments[0])", part)

    def dialog(self):
        return self.run_script("return document.querySelector('dialog[open]')?.id")

    def ask(self, sql, *values):
        with sqlite3.connect(f"file:{self.grades}/class.sqlite?mode=ro", uri=True) as record:
            return record.execute(sql, values).fetchall()

    def decisions(self):
        return self.ask("SELECT name, kind, number FROM decisions JOIN people ON people.id = person WHERE who = 'ada'")

    def complaints(self):
        return [one for one in super().complaints() if "/favicon.ico" not in one]  # it has no token

    def accepted(self):
        return self.ask("SELECT what, who FROM desk_items WHERE who <> ''")

    # One that belongs to a person and an exercise.
    def open_one(self):
        key = self.run_script("""const rows = [...document.querySelectorAll("#list > li")].filter((row) =>
            row.dataset.exercise && row.dataset.key.split("/").length === 3 && !row.classList.contains("decided"));
            rows[0].firstElementChild.click(); return rows[0].dataset.key""")
        self.wait_for("return document.querySelector('#item[aria-busy=false] > article')?.dataset.key === arguments[0]", key)
        return key

    def test_goes_through_the_list_by_keys(self):
        first = self.key()
        second = self.press_and_wait("j")
        self.assertEqual(self.press_and_wait("k"), first)
        self.press("k")
        self.wait_told("This is the first one")
        self.assertEqual(self.press_and_wait("u"), second)
        self.press("?")
        self.assertEqual(self.dialog(), "help")
        self.press("j", "a", "z")
        self.press("\ue00c")
        self.assertIsNone(self.dialog())
        self.assertEqual(self.key(), second)
        self.assertEqual(self.accepted(), [])
        self.assertEqual(self.complaints(), [])

    def test_accepts_and_takes_it_back(self):
        first = self.key()
        second = self.press_and_wait("a")
        self.assertEqual([who for _, who in self.accepted()], ["ada"])
        self.assertEqual(self.press_and_wait("z"), first)
        self.assertEqual(self.accepted(), [])
        self.press("a")
        self.wait_for("return document.querySelector('#item > article').dataset.key === arguments[0]", second)
        self.driver.refresh()
        self.wait_for("return document.readyState === 'complete'")
        self.assertIn("decided", self.run_script("return [...document.querySelectorAll('#list > li')].find((row) => row.dataset.key === arguments[0]).className", first))

    def desk_has_a_comment(self, text):
        self.open_one()
        self.press("c", text)
        before = self.key()
        self.run_script("document.querySelector('#comment button[type=submit]').click()")
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)

    def test_sets_points_by_three_keys(self):
        key = self.open_one()
        name = key.split("/")[-1]
        self.press("e")
        self.assertEqual(self.dialog(), "points")
        self.press("1")
        before = self.key()
        self.press("\ue007")
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
        self.assertEqual(self.decisions(), [(name, "points", 1.0)])

    def test_comments_anew_and_by_a_digit(self):
        text = "<b onclick=x>k j a</b> \u202e &amp;"
        self.open_one()
        self.press("c")
        self.assertEqual(self.dialog(), "comment")
        self.press(text)
        self.assertEqual(self.accepted(), [], "these keys are a text")
        before = self.key()
        self.run_script("document.querySelector('#comment button[type=submit]').click()")
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
        self.open_one()
        before = self.key()
        self.press("c", "1")
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
        self.assertEqual(self.ask("SELECT text, count(*) FROM comments JOIN commented ON comment = comments.id GROUP BY comments.id"), [(text, 2)])

    def test_takes_letters_for_a_new_comment(self):
        self.desk_has_a_comment("hand-in.rar can't be read")
        self.open_one()
        self.press("c", "Y", "o", " ", "1")
        self.assertEqual(self.dialog(), "comment")
        self.assertEqual(self.run_script("return document.querySelector('#comment [name=text]').value"), "Yo 1")

    def test_shows_what_the_filters_choose_and_no_more(self):
        self.run_script("const s = document.getElementById('search'); s.value = 'zzz'; s.dispatchEvent(new Event('input'))")
        self.assertEqual(self.text("count"), "Nothing matches.")
        self.assertEqual(self.run_script("return document.querySelectorAll('#list > li:not([hidden])').length"), 0)
        self.press("j")
        self.wait_told("This is the last one")
        self.run_script("const s = document.getElementById('search'); s.value = 'chloe'; s.dispatchEvent(new Event('input'))")
        self.assertIn("Chloé", self.text("list"))

    def test_unsets_what_was_decided_for_other_points(self):
        self.run_script("[...document.querySelectorAll('#list > li')].find((row) => row.dataset.kind === 'conflict').firstElementChild.click()")
        self.wait_for("return document.querySelector('#item [data-action=unset]') !== null")
        before = self.key()
        self.run_script("document.querySelector('#item [data-action=unset]').click()")
        self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
        self.assertEqual(self.ask("SELECT count(*) FROM decisions WHERE kind = 'points' AND place = 'S2.2'"), [(0,)])

    def test_says_what_is_wrong_and_keeps_the_text(self):
        self.open_one()
        self.press("e", "9999", "\ue007")
        self.wait_for("return document.querySelector('#points .told').textContent.includes('is worth')")
        self.assertEqual(self.run_script("return document.querySelector('#points [name=number]').value"), "9999")
        self.assertEqual(self.decisions(), [])

    def test_its_keys_can_be_switched_off_and_each_is_a_button(self):
        for action in ("next", "back", "undecided", "accept", "comment", "points", "undo", "help"):
            self.assertEqual(self.run_script("return document.querySelectorAll(`button[data-action=${arguments[0]}]`).length", action), 1, action)
        self.press("?")
        self.run_script("document.getElementById('keys').click()")
        self.press("\ue00c")
        for _ in range(2):
            first = self.key()
            self.press("j", "a", "c", "e", "u")
            self.assertIsNone(self.dialog())
            self.assertEqual((self.key(), self.accepted()), (first, []))
            self.driver.refresh()
            self.wait_for("return document.readyState === 'complete'")
        self.run_script("localStorage.clear()")

    def test_its_keys_are_letters_in_a_field(self):
        first = self.key()
        self.run_script("document.getElementById('search').focus()")
        self.press("j", "a", "u", "c", "e", "z", "?")
        self.assertEqual(self.run_script("return document.getElementById('search').value"), "jaucez?")
        self.assertEqual((self.key(), self.accepted(), self.dialog()), (first, [], None))

    def test_a_key_that_is_pressed_twice_decides_one(self):
        self.run_script("""for (let i = 0; i < 5; ++i)
            document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "a", bubbles: true, repeat: i > 2 }));""")
        self.wait_for("return document.querySelectorAll('#list .decided').length === 1")
        self.assertEqual(len(self.accepted()), 1)

    def test_shows_what_another_does_and_neither_loses(self):
        key = self.open_one()
        ben = Desk(self.grades, "ben")
        try:
            mine = self.driver.current_window_handle
            self.driver.switch_to.new_window("tab")
            self.driver.get(f"{ben.address}#{key.replace('/', '%2F')}")
            self.wait_for("return document.querySelector('#item > article')?.dataset.key === arguments[0]", key)
            self.assertIn("ada has this open", self.text("item"))
            before = self.key()
            self.press("a")
            self.wait_for("return ![undefined, arguments[0]].includes(document.querySelector('#item[aria-busy=false] > article')?.dataset.key)", before)
            self.driver.close()
            self.driver.switch_to.window(mine)
            self.press("e", "1", "\ue007")
            self.wait_for("return /ben/.test(document.querySelector('#points .told').textContent)")
            self.assertEqual(self.decisions(), [], "ada is told first")
            self.press("\ue00c")
            self.wait_for("return [...document.querySelectorAll('#list .decided')].some((row) => row.dataset.key === arguments[0])", key)
        finally:
            self.assertEqual(ben.end(), 0)

    def test_says_that_it_has_ended_and_what_was_decided_stays(self):
        for how in (signal.SIGINT, signal.SIGKILL):
            self.press_and_wait("a")
            kept = self.accepted()
            self.assertIn(self.desk.end(how), (0, -signal.SIGKILL))
            self.press("a")
            self.wait_told("it has ended")
            self.assertEqual(self.accepted(), kept)
            self.desk = Desk(self.grades, "ada")
            self.open(self.desk)
            self.complaints()

    def test_runs_no_script_of_others(self):
        self.assertEqual(self.run_script("return document.querySelectorAll('#list > li').length > 10"), True)
        count = self.run_script("return document.querySelectorAll('#list > li').length")
        for i in range(count):
            self.run_script("document.querySelectorAll('#list > li')[arguments[0]].firstElementChild.click()", i)
            self.wait_for("return document.querySelector('#list [aria-current]')?.parentNode === document.querySelectorAll('#list > li')[arguments[0]]", i)
        self.assertIsNone(self.run_script("return window.planted"))
        self.assertEqual(self.run_script("return document.querySelectorAll('#item img[src=x], #list img, #item script').length"), 0)
        self.assertEqual(self.complaints(), [])

    def test_serves_the_class_and_its_pages(self):
        links = self.run_script("""return [...document.querySelectorAll(".top a, #item a")].map((one) => one.href)""")
        self.assertGreater(len(links), 2)
        for link in links:
            self.driver.get(link)
            self.assertTrue(self.run_script("return document.querySelector('h1') !== null"), link)
            self.assertEqual(self.complaints(), [], link)

    def test_has_no_sideways_scroll(self):
        self.open_one()
        self.check_no_sideways_scroll()

    def test_has_no_findings_of_axe(self):
        self.check_no_findings_of_axe()


if __name__ == "__main__":
    main()
