"""Batches on a Slurm cluster of two nodes. Run by ctest under with_slurm; STEPMILL_BINARY names the program."""
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SAMPLES = ("shoulder_block", "open_slots", "rounded_pocket", "nested_pockets")
# A node that is lost is missed after SlurmdTimeout; a busy machine plans slowly.
WAIT_S = 240


def environment(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    except OSError:
        return []


def parent(pid):
    return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


class Cluster(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.parts, self.out = self.folder / "parts", self.folder / "out %j"
        self.parts.mkdir()
        self.addCleanup(self.cancel)

    def cancel(self):
        """Nothing of a test that failed runs on."""
        subprocess.run(["scancel", "--me"], check=False)

    def copies(self, count):
        for number in range(count):
            sample = ROOT / f"step_parts/{SAMPLES[number % len(SAMPLES)]}.step"
            # Another content each, or it would be planned once.
            (self.parts / f"{number}.step").write_text(sample.read_text() + f"/* {number} */\n")

    def stepmill(self, *words):
        return subprocess.run([os.environ["STEPMILL_BINARY"], "batch", *map(str, words)], cwd=self.folder,
                              capture_output=True, text=True, check=False)

    def submit(self, *words, task_seconds=0.1):
        """By default each part has a task of its own."""
        done = self.stepmill(self.parts, "-o", self.out, "--slurm", "--memory", "1", "--task-seconds", task_seconds, *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return done.stdout

    def until(self, what, happened):
        end = time.monotonic() + WAIT_S
        while not (result := happened()):
            self.assertLess(time.monotonic(), end, f"{what}: {self.told()}")
            time.sleep(0.1)
        return result

    def told(self):
        return {file.name: file.read_text() for file in self.out.glob("cluster/told/*.txt")}

    def finish(self):
        """Waits for the collecting task."""
        self.until("the batch does not end", lambda: not (self.out / "cluster/round-1").exists())
        self.until("the collecting task does not end", lambda: not self.queue())

    def queue(self):
        return subprocess.run(["squeue", "--noheader"], capture_output=True, text=True, check=True).stdout

    def ledger(self, out=None):
        """By part, all that does not depend on when and how often a part was planned."""
        with sqlite3.connect((out or self.out) / "ledger.sqlite") as book:
            rows = book.execute("SELECT name, outcome, exit_code, message, folder, jobs.key, figures"
                                " FROM parts JOIN jobs ON parts.key = jobs.key").fetchall()
        return {row[0].decode(errors="surrogateescape"): row[1:] for row in rows}

    def tries(self):
        with sqlite3.connect(self.out / "ledger.sqlite") as book:
            return {name.decode(errors="surrogateescape"): tries for name, tries in book.execute(
                "SELECT name, tries FROM parts JOIN jobs ON parts.key = jobs.key")}

    def node_of_a_task_that_began(self):
        for record in self.out.glob("records/*.task.json"):
            for node in ("node1", "node2"):
                if f'"outcome":"waiting"' in (text := record.read_text()) and f'"node":"{node}"' in text:
                    return node
        return None

    def lose(self, node):
        """Ends a node's daemon and all that it has started, as when its power fails."""
        kill(int(pathlib.Path(os.environ["SLURM_FOLDER"], f"slurmd-{node}.pid").read_text()))
        here, conf = f"SLURMD_NODENAME={node}".encode(), f"SLURM_CONF={os.environ['SLURM_CONF']}".encode()
        tasks = [int(one.name) for one in pathlib.Path("/proc").iterdir() if one.name.isdigit()
                 and here in (found := environment(one.name)) and conf in found]
        # Their stepd first: it would tell how they ended.
        for pid in [parent(task) for task in tasks if parent(task) not in tasks and parent(task) > 1] + tasks:
            kill(pid)
        self.addCleanup(self.restore, node)

    def restore(self, node):
        subprocess.run(["slurmd", "-N", node], check=True)
        self.until("the node does not come back", lambda: subprocess.run(
            ["sinfo", "--noheader", f"--nodes={node}", "--partition=both", "--format=%t"], capture_output=True, text=True,
            check=True).stdout.strip() == "idle")

    def test_two_nodes_come_to_what_one_machine_does(self):
        self.copies(8)
        (self.parts / "noise.step").write_text("ISO-no-10303")
        (self.parts / os.fsdecode(b"\xff\xfe '$(exit).step")).write_text("nothing\n")
        (self.parts / "gone.step").symlink_to(self.parts / "nowhere")
        self.assertIn("tasks", self.submit("--material", "steel"))
        refused = self.stepmill(self.parts, "-o", self.out, "--resume")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("scancel", refused.stderr)
        self.assertIn("11 parts", self.stepmill("--status", self.out).stdout)
        self.finish()
        here = self.folder / "here"
        self.assertEqual(self.stepmill(self.parts, "-o", here, "--material", "steel").returncode, 1)
        self.assertEqual(self.ledger(), self.ledger(here))
        self.assertEqual((self.out / "parts.csv").read_bytes(), (here / "parts.csv").read_bytes())
        self.assertEqual((self.out / "index.html").read_bytes(), (here / "index.html").read_bytes())
        self.assertEqual(list(self.out.glob("records/*")), [])
        told = "".join(self.told().values())
        self.assertIn("node1: ", told)
        self.assertIn("node2: ", told)
        self.assertIn("11 parts: 8 complete, 2 refused, 1 missing",
                      self.stepmill(self.parts, "-o", self.out, "--resume", "--material", "steel").stdout)
        self.assertEqual(set(self.tries().values()), {1}, "nothing is done twice")

    def test_what_a_lost_node_had_is_planned_on_the_other(self):
        self.copies(5)
        go = self.folder / "go"
        self.submit(*[word for number in range(5) for word in ("--fault", f"{number}.step:wait:{go}")])
        node = self.until("no task begins", self.node_of_a_task_that_began)
        self.lose(node)
        go.touch()
        self.finish()
        self.assertEqual({row[0] for row in self.ledger().values()}, {"complete"})
        self.assertEqual(sorted(self.tries().values()), [1, 1, 1, 1, 2])

    def test_what_ends_its_task_twice_is_entered_and_harms_no_other(self):
        self.copies(4)
        self.submit("--fault", "0.step:task", "--fault", "1.step:hang", "--timeout", "20", task_seconds=300)
        self.finish()
        outcomes = {name: row[0] for name, row in self.ledger().items()}
        self.assertEqual(outcomes, {"0.step": "killed", "1.step": "timed-out", "2.step": "complete", "3.step": "complete"})
        self.assertEqual(self.tries()["0.step"], 2)
        self.assertIn("its task on the cluster ended", self.ledger()["0.step"][2])
        told = "".join(self.told().values())
        self.assertEqual({"node1: ", "node2: "}, {word for word in ("node1: ", "node2: ") if word in told},
                         "the second try is on the other node")
        again = self.stepmill(self.parts, "-o", self.out, "--retry")
        self.assertIn("4 parts: 4 complete", again.stdout)

    def test_tasks_that_were_cancelled_lose_nothing(self):
        self.copies(3)
        go = self.folder / "go"
        self.submit("--fault", f"2.step:wait:{go}")
        self.until("the first parts are not planned", lambda: "2 complete" in self.stepmill("--status", self.out).stdout)
        self.cancel()
        self.until("the jobs do not end", lambda: not self.queue())
        done = self.stepmill(self.parts, "-o", self.out, "--resume")
        self.assertIn("3 parts: 3 complete", done.stdout, done.stderr)
        self.assertEqual(self.tries()["0.step"], 1)


class Usage(unittest.TestCase):
    def test_words_that_sbatch_does_not_take_are_told(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / "step_parts/shoulder_block.step", folder)
            done = subprocess.run([os.environ["STEPMILL_BINARY"], "batch", folder, "-o", f"{folder}/out", "--slurm",
                                   "--partition", "none"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("sbatch: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
