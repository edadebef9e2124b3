"""A headless Chromium that shows one page at a time, driven over a pipe (Chrome DevTools Protocol)."""
import json
import os
import select
import shutil
import subprocess
import tempfile
import time


def program():
    """The browser's path, None where there is none."""
    return shutil.which("chromium") or shutil.which("chromium-browser")


class Chromium:
    """Use it as `with Chromium() as browser`. It may be given more options of the browser."""

    WAIT_S = 120  # for any answer: only a browser that hangs takes so long

    def __init__(self, *options):
        self.options = options
        self.heard = []  # what the browser tells of its own accord, once listen() was called

    def __enter__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        theirs_in, self.to = os.pipe()
        self.back, theirs_out = os.pipe()
        # It reads from its file 3 and writes to its file 4; sh moves ours there, whatever numbers they have.
        moved = f'exec "$@" 3<&{theirs_in} 4>&{theirs_out}'
        self.process = subprocess.Popen(
            ["bash", "-c", moved, "bash", program(), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--window-size=1400,900", *self.options, f"--user-data-dir={self.profile.name}", "--remote-debugging-pipe", "about:blank"],
            pass_fds=(theirs_in, theirs_out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(theirs_in)
        os.close(theirs_out)
        self.rest, self.last, self.session = b"", 0, None
        target = next(target for target in self.ask("Target.getTargets")["targetInfos"] if target["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        return self

    def __exit__(self, *trouble):
        os.close(self.to)
        self.process.kill()
        self.process.wait()
        os.close(self.back)
        self.profile.cleanup()

    def message(self, deadline):
        while b"\0" not in self.rest:
            if not select.select([self.back], [], [], max(0, deadline - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            piece = os.read(self.back, 1 << 20)
            if not piece:
                raise EOFError("the browser has ended")
            self.rest += piece
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, **parameters):
        """Sends a command and waits for its answer."""
        self.last += 1
        command = {"id": self.last, "method": method, "params": parameters}
        if self.session:
            command["sessionId"] = self.session
        os.write(self.to, json.dumps(command).encode() + b"\0")
        deadline = time.monotonic() + self.WAIT_S
        while True:
            answer = self.message(deadline)
            if "method" in answer:
                self.heard.append(answer)
            if answer.get("id") == self.last:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def run(self, script):
        """What a JavaScript expression gives; a promise is waited for."""
        result = self.ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def show(self, path):
        """Loads a file and waits until its scripts have run."""
        self.ask("Page.navigate", url=f"file://{path}")
        deadline = time.monotonic() + self.WAIT_S
        while self.run("location.protocol + document.readyState") != "file:complete":
            if time.monotonic() > deadline:
                raise TimeoutError(f"{path} is not shown")
            time.sleep(0.05)

    def listen(self):
        """From now on what the page logs and loads is heard."""
        for domain in ("Log", "Runtime", "Network", "Page"):
            self.ask(f"{domain}.enable")

    # What a browser without a graphics card says of itself, whatever the page.
    OWN_WORDS = ("GL Driver Message", "software WebGL")

    def complaints(self):
        """What the page said on the console, and what went wrong in its scripts."""
        said = []
        for event in self.heard:
            if event["method"] == "Log.entryAdded":
                words = event["params"]["entry"]["text"]
                if not any(own in words for own in self.OWN_WORDS):
                    said.append(words)
            if event["method"] == "Runtime.consoleAPICalled":
                said.append(str(event["params"]["args"]))
            if event["method"] == "Runtime.exceptionThrown":
                said.append(str(event["params"]["exceptionDetails"]))
        return said

    def requests(self):
        """Addresses of all that was asked for."""
        return [event["params"]["request"]["url"] for event in self.heard
                if event["method"] == "Network.requestWillBeSent"]
