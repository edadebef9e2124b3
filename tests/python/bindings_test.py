#!/usr/bin/env python3
"""The Python package against the program: the same plan, byte for byte, and the same words for what is wrong.
STEPMILL_PYTHON is the folder that the package is imported from, STEPMILL_BINARY the program."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, os.environ.get("STEPMILL_PYTHON", ""))
try:
    import stepmill
except ImportError as missing:
    print(f"Skipped: no Python package of Stepmill ({missing}); make python builds it")
    sys.exit(0)

POCKET = ROOT / "step_parts" / "rounded_pocket.step"


class Bindings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.part = stepmill.load(POCKET)
        cls.plan = stepmill.plan(cls.part)

    def test_a_plan_is_the_programs_own(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["STEPMILL_BINARY"], "plan", POCKET, "-o", f"{folder}/job"], check=True,
                           capture_output=True)
            self.assertEqual(pathlib.Path(folder, "job", "plan.json").read_text(), self.plan.json_text)
            for name, text in self.plan.programs.items():
                self.assertEqual(pathlib.Path(folder, "job", name).read_text(), text)
        self.assertTrue(self.plan.may_run)
        self.assertTrue(self.plan.complete)

    def test_a_part_tells_what_it_is(self):
        self.assertEqual(self.part.file, "rounded_pocket.step")
        self.assertEqual(self.part.unit_in_file, "mm")
        low, high = self.part.box_mm
        self.assertEqual([round(h - l, 6) for l, h in zip(low, high)], [100, 80, 30])

    def test_regions_are_arrays(self):
        loops = [memoryview(loop) for loop in self.plan.target(self.plan.features[0])]
        self.assertEqual(len(loops), 2)  # the pocket and its island
        self.assertEqual(loops[0].shape[1], 2)
        area = sum((a[0] * b[1] - a[1] * b[0]) / 2 for loop in loops
                   for a, b in zip(loop.tolist(), loop.tolist()[1:] + loop.tolist()[:1]))
        self.assertAlmostEqual(area, self.plan.data["features"][0]["bands"][0]["area_mm2"], delta=2)

    def test_studies_are_the_files_of_the_program(self):
        self.assertEqual(stepmill.inspect(self.part)["format"], 1)
        self.assertTrue(stepmill.rank(self.part)["format"] >= 1)
        quote = stepmill.quote(self.plan, [1, 10])
        self.assertEqual([lot["quantity"] for lot in quote["lots"]], [1, 10])

    def test_the_notebook_runs(self):
        cells = json.loads((ROOT / "samples" / "stepmill.ipynb").read_text())["cells"]
        code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
        ran = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": os.environ["STEPMILL_PYTHON"]})
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_a_drawing_is_a_part(self):
        drawn = stepmill.load(ROOT / "samples" / "common_pocket.dxf", depths={"POCKET": 12}, outline="OUTLINE",
                              thickness=30)
        self.assertAlmostEqual(drawn.volume_mm3 / self.part.volume_mm3, 1, delta=1e-6)

    def test_wrong_input_raises_an_error_that_names_it(self):
        with self.assertRaisesRegex(stepmill.Error, "gone.step"):
            stepmill.load("gone.step")
        with self.assertRaisesRegex(stepmill.Error, "setups: expected axes"):
            stepmill.plan(self.part, setups=["up"])
        with self.assertRaisesRegex(stepmill.Error, "S9.F9"):
            self.plan.target("S9.F9")
        with self.assertRaises(ValueError) as wrong:
            stepmill.load_tools(POCKET)
        self.assertIn("rounded_pocket.step", wrong.exception.subject)


if __name__ == "__main__":
    unittest.main()
