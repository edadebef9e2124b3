"""What the repository's scripts and its Makefile say and do. Run by ctest, a case a test."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def run(*words, **options):
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False, **options)


class Docs(unittest.TestCase):
    def test_links_and_citations_resolve(self):
        check = run("scripts/check-docs")
        self.assertEqual(check.returncode, 0, check.stdout + check.stderr)

    def test_picture_of_the_modules_is_that_of_the_code(self):
        check = run("scripts/draw-modules", "--check")
        self.assertEqual(check.returncode, 0, check.stdout + check.stderr)


class InstallDependencies(unittest.TestCase):
    """With programs of the test's own in the place of the system's package manager."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for name in ("bash", "env"):
            os.symlink(shutil.which(name), pathlib.Path(self.folder.name) / name)
        self.program("id", "echo 1000")

    def program(self, name, script):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(f"#!/usr/bin/env bash\n{script}\n")
        path.chmod(0o755)

    def packages(self, state, apt_get="exit 100"):
        self.program("dpkg-query", f"echo {state}")
        self.program("apt-cache", "exit 0")
        self.program("apt-get", apt_get)

    def install(self, *options):
        return run("scripts/install-dependencies", *options, env={"PATH": self.folder.name})

    def test_does_nothing_where_all_is_there(self):
        self.packages("installed")
        done = self.install("--tests")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_names_the_packages_where_there_is_no_apt_get(self):
        done = self.install()
        self.assertEqual(done.returncode, 0)
        self.assertIn("libocct-foundation-dev", done.stderr)
        self.assertNotIn("libgtest-dev", done.stderr)

    def test_names_the_packages_where_nobody_may_install_them(self):
        self.packages("missing")
        done = self.install("--tests")
        self.assertEqual(done.returncode, 2)
        self.assertIn("libocct-foundation-dev", done.stderr)
        self.assertIn("libgtest-dev", done.stderr)

    def test_names_the_packages_where_sudo_says_no(self):
        self.packages("missing")
        self.program("sudo", "exit 1")
        done = self.install()
        self.assertEqual(done.returncode, 2)
        self.assertIn("libocct-foundation-dev", done.stderr)

    def test_names_the_packages_where_apt_get_fails(self):
        self.packages("missing")
        self.program("sudo", '"$@"')
        done = self.install()
        self.assertEqual(done.returncode, 2)
        self.assertIn("libocct-foundation-dev", done.stderr)


class PlanningTargets(unittest.TestCase):
    def test_has_a_row_for_every_part_of_a_folder_planned_or_not(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / "step_parts/shoulder_block.step", folder)
            (pathlib.Path(folder) / "nothing.stp").write_text("")
            (pathlib.Path(folder) / "README.md").write_text("no part")
            done = run("scripts/planning-targets", "--stepmill", os.environ["STEPMILL_BINARY"], folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()]
        self.assertEqual([row[0] for row in rows], ["part", "---", "nothing", "shoulder_block"])
        self.assertTrue(rows[2][-1].startswith("no plan: "), rows[2])
        self.assertEqual(rows[3][1:6], ["10", "1", "2", "2", "2"], rows[3])
        self.assertEqual(rows[3][-3:], ["100.0 %", "0.0 %", ""], rows[3])


class MakePlan(unittest.TestCase):
    def test_asks_for_nothing_that_only_tests_need(self):
        with tempfile.TemporaryDirectory() as build:
            plan = run("make", "-n", "plan", "-W", "build/release/build.ninja")
            self.assertEqual(plan.returncode, 0, plan.stderr)
            self.assertNotIn("BUILD_TESTING=ON", plan.stdout)
            self.assertNotIn("--tests", plan.stdout)
            configured = run("cmake", "-S", ".", "-B", build, "-G", "Ninja", "-DBUILD_TESTING=OFF",
                             *[f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("GTest", "benchmark")])
            self.assertEqual(configured.returncode, 0, configured.stderr)


if __name__ == "__main__":
    unittest.main()
