"""The table of many parts in a real browser, with 10,000 made-up parts: what it shows, and how quickly. Run by ctest;
MADE_UP_BATCH names the program that writes the page."""
import os
import subprocess
import tempfile
import unittest

import chromium

PARTS = 10000
# Of the goal in milliseconds, from the click to the second frame after it: what was asked for is then on the screen.
LIMIT_MS = 200
# Other programs on the machine only ever add time: the least of so many rounds is the page's own. Each round loads the
# page anew, so that each sort is the first by its column.
ROUNDS = 3

TIMED = """(async () => {
  const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const choose = (id, value) => {
    const input = document.getElementById(id);
    input.value = value;
    input.dispatchEvent(new Event("input"));
  };
  const timed = async (work) => {
    await frames();
    const start = performance.now();
    work();
    await frames();
    return performance.now() - start;
  };
  const times = {};
  const buttons = [...document.querySelectorAll("#table-frame th button")];
  for (const button of buttons) {
    times["sort by " + button.textContent] = await timed(() => button.click());
    times["sort by " + button.textContent + " down"] = await timed(() => button.click());
  }
  for (const words of ["b", "br", "bracket-77", "steel undercut", ""])
    times["search '" + words + "'"] = await timed(() => choose("table-search", words));
  for (const outcome of ["gaps", "refused", ""])
    times["filter '" + outcome + "'"] = await timed(() => choose("table-outcome", outcome));
  times["scroll"] = await timed(() => { document.getElementById("table-frame").scrollTop = 300000; });
  return times;
})()"""

SHOWN = """(async () => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  return [...document.querySelectorAll("#table-rows tr.part")].map(
    (row) => [...row.cells].map((cell) => cell.textContent));
})()"""


def click(head):
    return f"[...document.querySelectorAll('th button')].find((one) => one.textContent === '{head}').click()"


def choose(kind, value):
    return (f"{{ const input = document.getElementById('table-{kind}'); input.value = '{value}';"
            " input.dispatchEvent(new Event('input')); }")


class PartTable(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not chromium.program():
            # ctest takes the words for a skipped test; CI must have the browser.
            if "CI" in os.environ:
                raise AssertionError("chromium must be installed in CI")
            print("Skipped: Chromium is not installed (package chromium)")
            raise unittest.SkipTest("no browser")
        cls.folder = tempfile.TemporaryDirectory()
        cls.page = f"{cls.folder.name}/index.html"
        subprocess.run([os.environ["MADE_UP_BATCH"], str(PARTS), cls.page], check=True)
        cls.browser = chromium.Chromium()
        cls.browser.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.show(self.page)

    def count(self):
        return self.browser.run("document.getElementById('table-count').textContent")

    def column(self, head):
        heads = self.browser.run("[...document.querySelectorAll('#table-frame th')].map((one) => one.textContent)")
        return [row[heads.index(head)] for row in self.browser.run(SHOWN)]

    def test_sort_filter_search_and_scroll_stay_within_the_limit(self):
        least = {}
        for _ in range(ROUNDS):
            self.browser.show(self.page)
            for what, time_ms in self.browser.run(TIMED).items():
                least[what] = min(time_ms, least.get(what, time_ms))
        for what, time_ms in sorted(least.items(), key=lambda item: -item[1])[:8]:
            print(f"{time_ms:6.0f} ms  {what}")
        self.assertGreater(len(least), 30)
        self.assertEqual({what: time for what, time in least.items() if time > LIMIT_MS}, {})

    def test_a_click_sorts_another_turns_and_empty_cells_stay_last(self):
        self.assertEqual(self.count(), f"{PARTS} of {PARTS} parts")
        self.browser.run(click("cost"))
        up = [float(cost) for cost in self.column("cost")]
        self.browser.run(click("cost"))
        down = [float(cost) for cost in self.column("cost")]
        self.assertEqual((up, down), (sorted(up), sorted(down, reverse=True)))
        self.assertLess(up[-1], down[-1])
        self.browser.run(choose("outcome", "refused"))
        self.browser.run(click("due"))
        dates = self.column("due")
        self.assertEqual(dates, sorted(dates))
        self.assertNotIn("", dates)
        self.browser.run("document.getElementById('table-frame').scrollTop = 1e9")
        self.assertEqual(set(self.column("due")), {""})
        names = self.column("part")
        places = [int(name.split("-")[1]) for name in names]
        self.assertEqual(places, sorted(places), "equal ones stay in the list's order")

    def test_search_wants_every_word_and_looks_at_words_alone(self):
        self.browser.run(choose("search", "BRACKET-777- refused"))
        self.assertEqual(self.count(), f"1 of {PARTS} parts")
        self.browser.run(choose("search", "report.html"))
        self.assertEqual(self.count(), f"0 of {PARTS} parts", "links are no words")
        self.browser.run(choose("search", ""))
        self.browser.run(choose("outcome", "gaps"))
        self.assertEqual(set(self.column("outcome")), {"gaps"})


if __name__ == "__main__":
    unittest.main()
