"""report.html with its viewer in a real browser: it plays to the end, answers clicks and keys, loads nothing, says nothing on the
console, and keeps its words in their boxes. Run by ctest; STEPMILL_BINARY names the program."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import chromium

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
HOSTILE = "</script><script>alert(1)</script>\"'&<b>" + "x" * 300 + "\u202e"
FRAME = "document.getElementById('viewer-frame')"
WAIT_S = 120

# What stands outside its box, and tables and pages wider than theirs.
FAULTS = """(() => {
  const bad = [];
  const slack = 1.5;
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width + slack)
    bad.push("page of " + width + " is " + document.documentElement.scrollWidth + " wide");
  for (const table of document.querySelectorAll("table")) {
    const frame = table.parentElement;
    if (table.getBoundingClientRect().width > frame.clientWidth + slack)
      bad.push("table of " + table.getBoundingClientRect().width + " in " + frame.clientWidth + ": " +
        table.textContent.slice(0, 40));
  }
  const walk = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
  for (let node = walk.nextNode(); node; node = walk.nextNode()) {
    const box = node.parentElement.closest("td,th,p,li,label,button,figcaption,summary,h1,h2,h3,svg,.card,.warn");
    if (!box || !node.textContent.trim() || !box.checkVisibility()) continue;
    const room = box.getBoundingClientRect();
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const at of range.getClientRects())
      if (at.left < room.left - slack || at.right > room.right + slack || at.top < room.top - 3 * slack ||
          at.bottom > room.bottom + 3 * slack) {
        bad.push("outside its " + box.tagName + ": " + node.textContent.trim().slice(0, 60));
        break;
      }
  }
  return bad.slice(0, 12);
})()"""


def plan(part, folder, *options):
    """Plans a part into the folder; returns its report."""
    run = subprocess.run([os.environ["STEPMILL_BINARY"], "plan", str(part), "-o", str(folder), *options],
                         capture_output=True, text=True)
    if run.returncode > 1:
        raise AssertionError(f"{part}: {run.stderr}")
    return pathlib.Path(folder) / "report.html"


class Report(unittest.TestCase):
    PART = SOURCE / "step_parts" / "four_setups.step"
    OPTIONS = ()

    @classmethod
    def setUpClass(cls):
        if not chromium.program():
            # ctest takes the words for a skipped test; CI must have the browser.
            if "CI" in os.environ:
                raise AssertionError("chromium must be installed in CI")
            print("Skipped: Chromium is not installed (package chromium)")
            raise unittest.SkipTest("no browser")
        cls.folder = tempfile.TemporaryDirectory()
        cls.report = plan(cls.PART, pathlib.Path(cls.folder.name) / "job", *cls.OPTIONS)
        cls.browser = chromium.Chromium(*SOFTWARE_GL)
        cls.browser.__enter__()
        cls.browser.listen()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.heard.clear()
        self.open(self.report)

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [], "the page says something on the console")
        outside = [url for url in self.browser.requests() if not url.startswith("file://")]
        self.assertEqual(outside, [], "a request leaves the page")
        self.assertEqual(len(self.browser.requests()), 1, "the page loads nothing but itself")

    def open(self, page):
        self.browser.show(page)
        self.until("ready", "yes")

    def state(self, name):
        return self.browser.run(f"{FRAME}.dataset.{name}")

    def until(self, name, value, wait_s=WAIT_S):
        deadline = time.monotonic() + wait_s
        while self.state(name) != value:
            if time.monotonic() > deadline:
                self.fail(f"{name} is {self.state(name)}, not {value}")
            time.sleep(0.05)

    def press(self, key, code=None):
        for kind in ("keyDown", "keyUp"):
            self.browser.ask("Input.dispatchKeyEvent", type=kind, key=key, code=code or key)

    def focus(self):
        self.browser.run(f"{FRAME}.focus()")

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def canvas(self):
        self.browser.run(f"{FRAME}.scrollIntoView()")
        box = self.browser.run(f"(({{x, y, width, height}}) => [x, y, width, height])"
                               f"({FRAME}.querySelector('canvas').getBoundingClientRect())")
        return box

    def buttons(self, title):
        return (f"[...{FRAME}.querySelectorAll('ul[aria-label={title}] button')]")


class Viewer(Report):
    def test_plays_to_the_end(self):
        self.browser.run(f"(() => {{ const speed = [...{FRAME}.querySelectorAll('select')].pop();"
                         " speed.value = 5000; speed.dispatchEvent(new Event('change')); })()")
        self.focus()
        self.press(" ")
        self.until("state", "ended")
        last = self.browser.run(f"{self.buttons('Operations')}.pop().textContent").split()[0]
        self.assertEqual(self.state("operation"), "S1." + last)
        # At the feeds that the moves have, whatever the cutting data's are; places and feeds are rounded.
        plan_json = json.loads((pathlib.Path(self.report).parent / "plan.json").read_text())
        whole = sum(one["time_s"] for one in plan_json["operations"] if one["setup"] == "S1")
        self.assertAlmostEqual(float(self.state("time")), whole, delta=0.005 * whole)

    def test_the_clock_runs_while_it_plays_and_stands_when_it_pauses(self):
        self.focus()
        self.press(" ")
        self.until("state", "playing")
        start = float(self.state("time"))
        time.sleep(1)
        self.assertGreater(float(self.state("time")), start)
        self.press(" ")
        self.until("state", "paused")
        stands = self.state("time")
        time.sleep(0.3)
        self.assertEqual(self.state("time"), stands)

    def test_keys_jump_between_operations_and_to_both_ends(self):
        self.focus()
        self.press("End")
        self.until("state", "ended")
        self.press("Home")
        self.until("operation", "S1.O1")
        self.until("state", "paused")
        self.press("PageDown")
        self.until("operation", "S1.O2")
        self.press("PageUp")
        self.until("operation", "S1.O1")

    def test_a_click_on_an_operation_goes_there_and_shows_its_first_line(self):
        self.browser.run(f"{self.buttons('Operations')}[1].click()")
        self.until("operation", "S1.O2")
        words = self.browser.run(f"{FRAME}.querySelector('.viewer-words').textContent")
        program = (self.report.parent / "S1.ngc").read_text().splitlines()
        place = self.browser.run(f"{FRAME}.querySelector('.viewer-place').textContent")
        line = program[int(place.split()[-1]) - 1]
        self.assertTrue(place.startswith("S1.ngc, line "), place)
        self.assertIn(line, words)
        named = next(i for i, text in enumerate(program) if text.startswith("(S1.O2 "))
        self.assertEqual(program.index(line, named), named + 1, "the first block after the operation's comment")

    def test_a_click_on_the_picture_chooses_a_feature_with_its_operations(self):
        self.focus()
        self.press("2")
        x, y, width, height = self.canvas()
        found = ""
        for share in [(i, j) for i in (0.5, 0.4, 0.6, 0.3, 0.7) for j in (0.5, 0.4, 0.6, 0.3, 0.7)]:
            self.click(x + share[0] * width, y + share[1] * height)
            time.sleep(0.1)
            found = self.state("chosen")
            if found:
                break
        self.assertTrue(found.startswith("S1.F"), found)
        marked = self.browser.run(f"{self.buttons('Features')}.filter((one) => one.classList.contains('marked')).length")
        self.assertEqual(marked, 1)
        self.assertIn("Operations:", self.browser.run(f"{FRAME}.querySelector('.viewer-words').textContent"))
        self.press("Escape")
        self.until("chosen", "")

    def test_a_click_on_a_feature_in_the_list_marks_its_operations(self):
        self.browser.run(f"{self.buttons('Features')}[0].click()")
        name = self.browser.run(f"{self.buttons('Features')}[0].textContent").split()[0]
        self.until("chosen", name)
        marked = self.browser.run(f"{self.buttons('Operations')}.filter((one) => one.classList.contains('marked')).length")
        self.assertGreater(marked, 0)

    def test_every_setup_can_be_shown(self):
        setups = self.browser.run(f"[...{FRAME}.querySelector('select').options].map((one) => one.textContent)")
        self.assertEqual(len(setups), 4)
        for i, setup in enumerate(setups):
            self.browser.run(f"(() => {{ const choice = {FRAME}.querySelector('select'); choice.value = {i};"
                             " choice.dispatchEvent(new Event('change')); })()")
            self.until("setup", setup)
            self.focus()
            self.press("End")
            self.until("state", "ended")

    def test_both_looks_draw_a_picture(self):
        """Of more than one colour: something stands on the ground."""
        for look in ("light", "dark"):
            if self.state("look") != look:
                self.focus()
                self.press("l")
            self.until("look", look)
            self.assertGreater(self.colours(), 20, look)

    def test_paths_are_coloured_by_what_they_cut(self):
        """The four setups have slots and open steps, and feeds by what they cut."""
        choice = f"[...{FRAME}.querySelectorAll('select')][1]"
        names = self.browser.run(f"[...{choice}.options].map((one) => one.value)")
        self.assertEqual(names[-2:], ["engagement", "power"])
        for name in names[-2:]:
            self.browser.run(f"(() => {{ {choice}.value = '{name}';"
                             f" {choice}.dispatchEvent(new Event('change')); }})()")
            self.focus()
            self.press("End")
            self.until("state", "ended")
            self.assertGreater(self.colours(), 20, name)
            self.press("Home")

    def colours(self):
        x, y, width, height = self.canvas()
        return self.browser.run("""(async () => {
          const canvas = document.querySelector('#viewer-frame canvas');
          return await new Promise((done) => requestAnimationFrame(() => {
            document.querySelector('#viewer-frame').dispatchEvent(new KeyboardEvent('keydown', { key: '1' }));
            requestAnimationFrame(() => {
              const copy = document.createElement('canvas');
              copy.width = 200;
              copy.height = 120;
              const flat = copy.getContext('2d');
              flat.drawImage(canvas, 0, 0, 200, 120);
              const pixels = flat.getImageData(0, 0, 200, 120).data;
              const colours = new Set();
              for (let i = 0; i < pixels.length; i += 4) colours.add(pixels[i] * 65536 + pixels[i + 1] * 256 + pixels[i + 2]);
              done(colours.size);
            });
          }));
        })()""")

    def test_words_stay_in_their_boxes(self):
        for width in (1300, 800):
            self.browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=1000, deviceScaleFactor=1, mobile=False)
            self.assertEqual(self.browser.run(FAULTS), [], f"at {width} px")
        self.browser.ask("Emulation.clearDeviceMetricsOverride")


class WithoutWebGl(Report):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.__exit__()
        cls.browser = chromium.Chromium("--disable-3d-apis")
        cls.browser.__enter__()
        cls.browser.listen()

    def open(self, page):
        self.browser.show(page)

    def test_the_page_says_so_and_the_rest_is_there(self):
        words = self.browser.run("document.getElementById('viewer-message').textContent")
        self.assertIn("WebGL", words)
        self.assertEqual(self.browser.run(f"{FRAME}.children.length"), 0)
        self.assertTrue(self.browser.run("document.getElementById('operation-S1.O1') !== null"))


class HostileNames(Report):
    PART = SOURCE / "step_parts" / "shoulder_block.step"

    @classmethod
    def setUpClass(cls):
        cls.tools = tempfile.TemporaryDirectory()
        library = json.loads((SOURCE / "samples" / "shop_metric_tools.json").read_text())
        for tool in library["tools"]:
            tool["id"] = tool["id"] + HOSTILE[:40]
            tool["description"] = HOSTILE
        hostile = pathlib.Path(cls.tools.name) / "tools.json"
        hostile.write_text(json.dumps(library))
        cls.OPTIONS = ("--tools", str(hostile))
        super().setUpClass()

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        cls.tools.cleanup()

    def test_are_text(self):
        self.browser.run(f"{self.buttons('Operations')}[0].click()")
        words = self.browser.run(f"{FRAME}.querySelector('.viewer-words').textContent")
        self.assertIn("<script>alert(1)</script>", words)
        self.assertNotIn("\u202e", words)
        self.assertEqual(self.browser.run(f"{FRAME}.querySelectorAll('b b, script').length"), 0)

    def test_words_stay_in_their_boxes(self):
        for width in (1300, 800):
            self.browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=1000, deviceScaleFactor=1, mobile=False)
            self.assertEqual(self.browser.run(FAULTS), [], f"at {width} px")
        self.browser.ask("Emulation.clearDeviceMetricsOverride")


if __name__ == "__main__":
    unittest.main()
