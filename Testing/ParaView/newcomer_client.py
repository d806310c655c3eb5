# SPDX-License-Identifier: BSD-3-Clause
"""The real ParaView client on a display of its own, driven by ParaView's test player."""

import contextlib
import os
import shutil
import signal
import subprocess
from xml.sax.saxutils import quoteattr

MAXIMIZED = """<openbox_config xmlns="http://openbox.org/3.4/rc"><applications>
<application class="*" type="normal"><decor>no</decor><maximized>yes</maximized></application>
</applications></openbox_config>
"""
SHELL = "pqClientMainWindow/pythonShellDock/pythonShell/consoleWidget"


def python(code):
    """The gesture of typing a line into the client's Python shell."""
    return (SHELL, "executeCommand", code)


@contextlib.contextmanager
def started(command, **options):
    """A process of one's own, ended by its id."""
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait()


@contextlib.contextmanager
def display(size, folder, log):
    """An X server with a window manager that makes windows as large as the screen; gives its name
    when it takes clients."""
    configuration = os.path.join(folder, "openbox.xml")
    with open(configuration, "w", encoding="utf-8") as file:
        file.write(MAXIMIZED)
    manager = ["openbox", "--config-file", configuration]
    reading, writing = os.pipe()
    server = ["Xvfb", "-displayfd", str(writing), "-screen", "0", size + "x24", "-noreset"]
    with started(server, pass_fds=[writing], stdout=log, stderr=log):
        os.close(writing)
        with os.fdopen(reading) as answer:
            name = ":" + answer.readline().strip()
        with started(manager, env={**os.environ, "DISPLAY": name}, stdout=log, stderr=log):
            yield name


def write_script(path, gestures):
    with open(path, "w", encoding="utf-8") as script:
        script.write('<?xml version="1.0" ?>\n<pqevents>\n')
        for widget, command, argument in gestures:
            script.write(f"  <pqevent object={quoteattr(widget)} command={quoteattr(command)}"
                         f" arguments={quoteattr(argument)} />\n")
        script.write("</pqevents>\n")


def play(gestures, folder, name, seconds, size="800x600"):
    """Plays gestures in a client with the plugin, on a screen of a size; its exit status and the
    lines that it printed.

    The client has a home of its own, so that no setting of an earlier run or user counts.
    """
    script = os.path.join(folder, name + ".xml")
    write_script(script, gestures)
    home = os.path.join(folder, name + "-home")
    shutil.rmtree(home, ignore_errors=True)
    os.makedirs(home, mode=0o700)
    plugin = os.environ["INTERLUME_PLUGIN"]
    command = [os.environ["INTERLUME_CLIENT"], "--dr", "--plugins", "Interlume",
               "--plugin-search-paths", os.path.dirname(plugin), "--test-script=" + script, "--exit"]
    path = os.path.join(folder, name + ".log")
    with open(path, "w", encoding="utf-8") as log, display(size, home, subprocess.DEVNULL) as screen:
        environment = {**os.environ, "DISPLAY": screen, "HOME": home, "XDG_RUNTIME_DIR": home,
                       "LIBGL_ALWAYS_SOFTWARE": "1"}
        with started(command, env=environment, cwd=home, stdout=log, stderr=log) as client:
            try:
                status = client.wait(seconds)
            except subprocess.TimeoutExpired:
                status = f"none after {seconds} s"
    with open(path, encoding="utf-8", errors="replace") as log:
        return status, log.read().splitlines()
