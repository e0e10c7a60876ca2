#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Opens a report in headless Chromium, as its reader would, and uses it.

    report_check.py PAGE.html                      check: exit 0 all right, 1 not
    report_check.py PAGE.html --planes             and show an index plane by clicks
    report_check.py PAGE.html --screenshot F.png   keep a picture of the page as it opens
                 [--script JS] [--size WxH]        ... after some clicks of one's own

It renders; the console has no errors; nothing is fetched; a click on a worst cell changes the view; a
click shows a plane.
Exit 77: Chromium or its driver is not installed (Debian: chromium, chromium-driver).
"""
import argparse
import base64
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

FLAGS = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
         "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"]


class Browser:
    """The WebDriver protocol (W3C), as far as it is needed."""

    def __init__(self, folder, size):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.base = f"http://127.0.0.1:{port}/session"
        wanted = {"browserName": "chrome", "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
                  "goog:chromeOptions": {"args": [*FLAGS, f"--user-data-dir={folder}", f"--window-size={size}"]}}
        for attempt in range(100):
            try:
                answer = self.call("", {"capabilities": {"alwaysMatch": wanted}})
                break
            except (ConnectionError, urllib.error.URLError):
                if attempt == 99:
                    raise
                time.sleep(0.1)
        self.base += "/" + answer["sessionId"]

    def call(self, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=120) as response:
            return json.load(response)["value"]

    def run(self, script):
        return self.call("/execute/sync", {"script": script, "args": []})

    def click(self, selector):
        element = self.call("/element", {"using": "css selector", "value": selector})
        key = next(iter(element.values()))
        self.run(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{block: 'center'}})")
        self.call(f"/element/{key}/click", {})

    def picture(self):
        """What the canvas shows, once two frames have passed."""
        return self.call("/execute/async", {"args": [], "script": """
            const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(
                () => done(document.getElementById('canvas').toDataURL())));"""})

    def logs(self, kind):
        return self.call("/se/log", {"type": kind})

    def close(self):
        urllib.request.urlopen(urllib.request.Request(self.base, method="DELETE"), timeout=60).close()
        self.driver.terminate()
        self.driver.wait()


def faults(browser, page, planes):
    """What is wrong with the page, line by line."""
    found = []
    first = browser.picture()
    blank = browser.run("""const c = document.createElement('canvas'), own = document.getElementById('canvas');
        c.width = own.width; c.height = own.height; const x = c.getContext('2d');
        x.fillStyle = '#fff'; x.fillRect(0, 0, c.width, c.height); return c.toDataURL();""")
    if first == blank:
        found.append("the canvas is empty")
    if browser.run("return document.querySelectorAll('#zones tr').length") < 2:
        found.append("the table of zones is empty")
    browser.run("const c = document.getElementById('colour'); c.value = '0'; c.dispatchEvent(new Event('change'))")
    coloured = browser.picture()
    if coloured == first:
        found.append("colouring by a measure changes nothing")
    if planes:
        browser.click("#plane_toggle")
        with_plane = browser.picture()
        if with_plane == coloured:
            found.append("a click on 'show' shows no plane")
        if browser.run("return document.querySelectorAll('#planes_shown label').length") != 1:
            found.append("the plane shown is not listed")
        browser.click("#plane_toggle")
        if browser.picture() != coloured:
            found.append("a click on 'hide' does not take the plane away")
    browser.click("#worst tr:nth-child(2)")
    if browser.picture() == coloured:
        found.append("a click on a worst cell does not change the view")
    if not browser.run("return document.getElementById('picked').textContent"):
        found.append("the worst cell is not named")
    browser.click("#reset")
    for entry in browser.logs("browser"):
        found.append(f"console: {entry['level']}: {entry['message']}")
    for entry in browser.logs("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            if url.startswith(("http", "file")) and url != page:
                found.append(f"the page asks for {url}")
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page")
    parser.add_argument("--planes", action="store_true")
    parser.add_argument("--screenshot")
    parser.add_argument("--script", default="")
    parser.add_argument("--size", default="1400,1000")
    arguments = parser.parse_args()
    if not (shutil.which("chromedriver") and shutil.which("chromium")):
        print("skipped: Chromium is not installed (Debian: chromium, chromium-driver)")
        return 77
    page = pathlib.Path(arguments.page).resolve().as_uri()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(folder, arguments.size)
        try:
            browser.logs("performance")  # what the browser does of its own
            browser.call("/url", {"url": page})
            if arguments.screenshot:
                browser.run(arguments.script)
                browser.picture()
                pathlib.Path(arguments.screenshot).write_bytes(base64.b64decode(browser.call("/screenshot")))
                return 0
            found = faults(browser, page, arguments.planes)
        finally:
            browser.close()
    print("\n".join(found) or "all right")
    return 1 if found else 0


sys.exit(main())
